// Colour and size of a particle by the part of its life that is over, linear between evenly spaced stops.
import { put } from '../columns';
import { Emitter, MOST_STOPS, putWord, word } from './record';

export function paint(e: Emitter, slot: u32, row: u32, part: f64): void {
  const ramp = word(e.ramp, slot);
  const stops = load<u32>(changetype<usize>(e) + offsetof<Emitter>('stops0') + ((<usize>ramp) << 2));
  if (stops > 1) {
    const first = changetype<usize>(e) + offsetof<Emitter>('color0') + <usize>ramp * MOST_STOPS * 4;
    putWord(e.color, row, blend(first, stops, part));
  }
  if (e.sizeStops > 1) {
    const factor = <f64>load<f32>(e.factor + ((<usize>slot) << 2));
    put(e.size, row, <real>(factor * sizeAt(e, part)));
  }
}

// Red and blue, green and alpha in pairs: two products for four channels. Never 0, which means "no colour given".
function blend(first: usize, stops: u32, part: f64): u32 {
  const place = part * <f64>(stops - 1);
  const stop = min<u32>(<u32>place, stops - 2);
  const t = <u32>((place - <f64>stop) * 256);
  const a = load<u32>(first + ((<usize>stop) << 2));
  const b = load<u32>(first + ((<usize>stop) << 2), 4);
  const redBlue = (a & 0xff00ff) * (256 - t) + (b & 0xff00ff) * t;
  const greenAlpha = ((a >> 8) & 0xff00ff) * (256 - t) + ((b >> 8) & 0xff00ff) * t;
  return max<u32>(1, ((redBlue >> 8) & 0xff00ff) | (greenAlpha & 0xff00ff00));
}

function sizeAt(e: Emitter, part: f64): f64 {
  if (e.sizeStops < 2) return e.size0;
  const place = part * <f64>(e.sizeStops - 1);
  const stop = min<i32>(<i32>place, e.sizeStops - 2);
  const at = changetype<usize>(e) + offsetof<Emitter>('size0') + ((<usize>stop) << 3);
  const from = load<f64>(at);
  return from + (load<f64>(at, 8) - from) * (place - <f64>stop);
}

// What a particle is born with.
export function dress(e: Emitter, slot: u32, row: u32, part: f64): void {
  const ramp = word(e.ramp, slot);
  const first = word(changetype<usize>(e) + offsetof<Emitter>('color0'), ramp * MOST_STOPS);
  putWord(e.color, row, first);
  put(e.size, row, <real>(<f64>load<f32>(e.factor + ((<usize>slot) << 2)) * e.size0));
  paint(e, slot, row, part);
}
