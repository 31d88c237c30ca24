// Normal noise as a function of seed, step, body and channel only: equal in every evaluation of a step, for any order
// of the bodies.
import { cosine, logarithm, sine } from './elementary';

// A bijection of 32 bits with good avalanche (Wellons, lowbias32, 2018).
// @ts-ignore: decorator
@inline function mix(value: u32): u32 {
  let z = value;
  z = (z ^ (z >> 16)) * 0x21f0aaad;
  z = (z ^ (z >> 15)) * 0x735a2d97;
  return z ^ (z >> 15);
}

// Uniform in (0, 1) from two words; never 0.
// @ts-ignore: decorator
@inline function unit(a: u32, b: u32): f64 {
  return (<f64>(a >> 6) * 67108864 + <f64>(b >> 6) + 0.5) * 2.220446049250313e-16;
}

// A normal number with mean 0 and variance 1. Channels 2n and 2n + 1 are the two numbers of one pair. Source: Box and
// Muller, Annals of Mathematical Statistics 29, 610 (1958).
export function noise(seed: f64, step: f64, row: i32, channel: i32): f64 {
  const body = mix(mix(<u32>seed ^ mix(<u32>step + 0x9e3779b9)) + <u32>row * 0x85ebca6b);
  const pair = mix(body + <u32>(channel >> 1) * 0x9e3779b9);
  const radius = sqrt<f64>(-2 * logarithm(unit(mix(pair ^ 0x243f6a88), mix(pair + 0x85a308d3))));
  const angle = 6.283185307179586 * unit(mix(pair ^ 0x13198a2e), mix(pair + 0x03707344));
  return radius * ((channel & 1) == 0 ? cosine(angle) : sine(angle));
}
