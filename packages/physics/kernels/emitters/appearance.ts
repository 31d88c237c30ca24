// Colour and size of a particle by the elapsed fraction of its life, linear between evenly spaced stops.
import { put } from '../memory/columns';
import { computeSineCosine, sineCosine } from '../math/elementary';
import { Emitter, MAX_STOPS, putWord, word } from './record';

// The number of colours of a ramp's lookup table, a power of two.
const SHADE_BITS: i32 = 8;
const SHADES: u32 = 1 << SHADE_BITS;

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

// The elapsed fractions of two lives; `lifetimes` holds them in its first two lanes.
// @ts-ignore: decorator
@inline export function fractionsOf(lifetimes: v128, births: usize, clock: f64): v128 {
  return f64x2.div(f64x2.sub(f64x2.splat(clock), v128.load(births)), f64x2.promote_low_f32x4(lifetimes));
}

// The last two lanes of four, as the first two.
// @ts-ignore: decorator
@inline export function lastTwo(lanes: v128): v128 {
  return v128.shuffle<f64>(lanes, lanes, 1, 1);
}

// As `writeColor`, for four neighbouring rows of which `column` is the first. The fractions are those of two rows each.
// @ts-ignore: decorator
@inline export function writeColors(colors: usize, ramps: usize, column: usize, first: v128, second: v128): void {
  const shades = f64x2.splat(SHADES);
  // Engines convert to integers with a sign in fewer instructions; below 0 they are 0, as without one.
  const shade = v128.shuffle<u64>(
    i32x4.trunc_sat_f64x2_s_zero(f64x2.mul(first, shades)),
    i32x4.trunc_sat_f64x2_s_zero(f64x2.mul(second, shades)),
    0,
    2,
  );
  const at = i32x4.shl(i32x4.add(i32x4.shl(v128.load(ramps), SHADE_BITS), i32x4.max_s(shade, i32x4.splat(0))), 2);
  store<u32>(column, load<u32>(colors + i32x4.extract_lane(at, 0)));
  store<u32>(column, load<u32>(colors + i32x4.extract_lane(at, 1)), 4);
  store<u32>(column, load<u32>(colors + i32x4.extract_lane(at, 2)), 8);
  store<u32>(column, load<u32>(colors + i32x4.extract_lane(at, 3)), 12);
}

// As `writeSize`, for four neighbouring rows of which `column` is the first.
// @ts-ignore: decorator
@inline export function writeSizes(
  sizes: usize,
  stops: i32,
  factors: usize,
  column: usize,
  first: v128,
  second: v128,
): void {
  const factor = v128.load(factors);
  const a = f64x2.mul(f64x2.promote_low_f32x4(factor), sizesAt(sizes, stops, first));
  const b = f64x2.mul(f64x2.promote_low_f32x4(lastTwo(factor)), sizesAt(sizes, stops, second));
  if (sizeof<real>() == 4) {
    v128.store(column, v128.shuffle<u64>(f32x4.demote_f64x2_zero(a), f32x4.demote_f64x2_zero(b), 0, 2));
  } else {
    v128.store(column, a);
    v128.store(column, b, 16);
  }
}

// @ts-ignore: decorator
@inline function sizesAt(sizes: usize, stops: i32, fractions: v128): v128 {
  if (stops == 1) return v128.load_splat<u64>(sizes);
  const position = f64x2.mul(fractions, f64x2.splat(stops - 1));
  const stop = i32x4.trunc_sat_f64x2_s_zero(position);
  // Each stop and the next.
  const a = v128.load(sizes + ((<usize>i32x4.extract_lane(stop, 0)) << 3));
  const b = v128.load(sizes + ((<usize>i32x4.extract_lane(stop, 1)) << 3));
  const before = v128.shuffle<f64>(a, b, 0, 2);
  const step = f64x2.sub(v128.shuffle<f64>(a, b, 1, 3), before);
  return f64x2.add(before, f64x2.mul(step, f64x2.sub(position, f64x2.convert_low_i32x4_s(stop))));
}

// Sets the initial colour and size of a particle.
export function applyAppearance(e: Emitter, slot: u32, row: u32, fraction: f64): void {
  writeColor(e.colors, e.ramp, e.color, slot, row, fraction);
  writeSize(changetype<usize>(e) + offsetof<Emitter>('size0'), e.sizeStops, e.sizeFactor, e.size, slot, row, fraction);
}
