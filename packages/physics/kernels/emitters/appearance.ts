// Colour and size of a particle by the part of its life that is over, linear between evenly spaced stops.
import { put } from '../memory/columns';
import { turn, turned } from '../math/elementary';
import { Emitter, MOST_STOPS, putWord, word } from './record';

// Shades of a ramp: a life shows 256.
const SHADES: u32 = 256;

// What follows from the parameters, once they are set: the cosine of the spread, and the tables of shades from the stops
// of the ramps.
export function prepareEmitter(emitter: usize): void {
  const e = changetype<Emitter>(emitter);
  turn(e.spread);
  e.cosSpread = turned.cosine;
  for (let ramp: i32 = 0; ramp < e.rampCount; ramp++) {
    const stops = word(emitter + offsetof<Emitter>('stops0'), ramp);
    const first = emitter + offsetof<Emitter>('color0') + ((<usize>ramp * MOST_STOPS) << 2);
    for (let shade: u32 = 0; shade < SHADES; shade++) {
      putWord(e.colors, <u32>ramp * SHADES + shade, stops == 1 ? load<u32>(first) : blend(first, stops, shade));
    }
  }
}

// Red and blue, green and alpha in pairs: two products for four channels. Never 0, which means "no colour given".
function blend(first: usize, stops: u32, shade: u32): u32 {
  const place = shade * (stops - 1);
  const stop = place / SHADES;
  const t = place % SHADES;
  const a = load<u32>(first + ((<usize>stop) << 2));
  const b = load<u32>(first + ((<usize>stop) << 2), 4);
  const redBlue = (a & 0xff00ff) * (SHADES - t) + (b & 0xff00ff) * t;
  const greenAlpha = ((a >> 8) & 0xff00ff) * (SHADES - t) + ((b >> 8) & 0xff00ff) * t;
  return max<u32>(1, ((redBlue >> 8) & 0xff00ff) | (greenAlpha & 0xff00ff00));
}

// @ts-ignore: decorator
@inline export function paintColor(
  colors: usize,
  ramps: usize,
  column: usize,
  slot: u32,
  row: u32,
  part: f64,
): void {
  putWord(column, row, word(colors, word(ramps, slot) * SHADES + <u32>(part * <f64>SHADES)));
}

// @ts-ignore: decorator
@inline export function paintSize(
  sizes: usize,
  stops: i32,
  factors: usize,
  column: usize,
  slot: u32,
  row: u32,
  part: f64,
): void {
  let size = load<f64>(sizes);
  if (stops > 1) {
    const place = part * <f64>(stops - 1);
    const stop = <i32>place;
    const at = sizes + ((<usize>stop) << 3);
    size = load<f64>(at) + (load<f64>(at, 8) - load<f64>(at)) * (place - <f64>stop);
  }
  put(column, row, <real>(<f64>load<f32>(factors + ((<usize>slot) << 2)) * size));
}

// What a particle is born with.
export function dress(e: Emitter, slot: u32, row: u32, part: f64): void {
  paintColor(e.colors, e.ramp, e.color, slot, row, part);
  paintSize(changetype<usize>(e) + offsetof<Emitter>('size0'), e.sizeStops, e.factor, e.size, slot, row, part);
}
