import { expect, test } from 'vitest';
import { DrawingRate } from './drawing-rate.ts';

const FRAME = 1 / 64;

/** Frames of so many seconds that are drawn, and the seconds that these are told. */
function drawn(rate: DrawingRate, seconds: number, stands: boolean): { frames: number; told: number } {
  let frames = 0;
  let told = 0;
  for (let i = 0; i < seconds / FRAME; i++) {
    const since = rate.next(FRAME, stands);
    if (since < 0) continue;
    frames++;
    told += since;
  }
  return { frames, told };
}

test('a world that moves is drawn in every frame', () => {
  expect(drawn(new DrawingRate(), 10, false)).toEqual({ frames: 640, told: 10 });
});

test('a world that stands is drawn in every frame for a second, and then four times a second', () => {
  const rate = new DrawingRate();
  drawn(rate, 2, false);
  // The frame with which the second ends is the first that may be left out.
  expect(drawn(rate, 1, true).frames).toBe(63);
  expect(drawn(rate, 10, true)).toEqual({ frames: 40, told: 10 });
});

test('what happens is drawn in the next frame, and a second on', () => {
  const rate = new DrawingRate();
  drawn(rate, 5, true);
  rate.wake();
  expect(drawn(rate, 0.5, true).frames).toBe(32);
  drawn(rate, 5, true);
  expect(rate.next(FRAME, false)).toBeGreaterThan(0);
});
