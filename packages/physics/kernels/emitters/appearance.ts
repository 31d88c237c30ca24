// Colour and size of a particle by the elapsed fraction of its life, linear between evenly spaced stops.
import { put } from '../memory/columns';
import { computeSineCosine, sineCosine } from '../math/elementary';
import { Emitter, MAX_STOPS, putWord, word } from './record';

// The number of colours of a ramp's lookup table.
const SHADES: u32 = 256;

// Computes the values derived from the parameters: the cosine of the spread, and the lookup tables of the colour
// ramps.
export function prepareEmitter(emitter: usize): void {
  const e = changetype<Emitter>(emitter);
  computeSineCosine(e.spread);
  e.cosSpread = sineCosine.cosine;
  for (let ramp: i32 = 0; ramp < e.rampCount; ramp++) {
    const stops = word(emitter + offsetof<Emitter>('stops0'), ramp);
    const first = emitter + offsetof<Emitter>('color0') + ((<usize>ramp * MAX_STOPS) << 2);
    for (let shade: u32 = 0; shade < SHADES; shade++) {
      putWord(e.colors, <u32>ramp * SHADES + shade, stops == 1 ? load<u32>(first) : blend(first, stops, shade));
    }
  }
}

// Blends red and blue, and green and alpha, as pairs: two products for four channels. The result is never 0, which
// means "no colour given".
function blend(first: usize, stops: u32, shade: u32): u32 {
  const position = shade * (stops - 1);
  const stop = position / SHADES;
  const t = position % SHADES;
  const a = load<u32>(first + ((<usize>stop) << 2));
  const b = load<u32>(first + ((<usize>stop) << 2), 4);
  const redBlue = (a & 0xff00ff) * (SHADES - t) + (b & 0xff00ff) * t;
  const greenAlpha = ((a >> 8) & 0xff00ff) * (SHADES - t) + ((b >> 8) & 0xff00ff) * t;
  return max<u32>(1, ((redBlue >> 8) & 0xff00ff) | (greenAlpha & 0xff00ff00));
}

// @ts-ignore: decorator
@inline export function writeColor(
  colors: usize,
  ramps: usize,
  column: usize,
  slot: u32,
  row: u32,
  fraction: f64,
): void {
  putWord(column, row, word(colors, word(ramps, slot) * SHADES + <u32>(fraction * <f64>SHADES)));
}

// @ts-ignore: decorator
@inline export function writeSize(
  sizes: usize,
  stops: i32,
  factors: usize,
  column: usize,
  slot: u32,
  row: u32,
  fraction: f64,
): void {
  let size = load<f64>(sizes);
  if (stops > 1) {
    const position = fraction * <f64>(stops - 1);
    const stop = <i32>position;
    const at = sizes + ((<usize>stop) << 3);
    size = load<f64>(at) + (load<f64>(at, 8) - load<f64>(at)) * (position - <f64>stop);
  }
  put(column, row, <real>(<f64>load<f32>(factors + ((<usize>slot) << 2)) * size));
}

// Sets the initial colour and size of a particle.
export function applyAppearance(e: Emitter, slot: u32, row: u32, fraction: f64): void {
  writeColor(e.colors, e.ramp, e.color, slot, row, fraction);
  writeSize(changetype<usize>(e) + offsetof<Emitter>('size0'), e.sizeStops, e.sizeFactor, e.size, slot, row, fraction);
}
