import { MAX_TEXT_STARS } from '@principia/scenes';
import { expect, it } from 'vitest';
import { samplePoints } from './text-points.ts';

/** Pixels that `color` paints: red, green, blue, opacity. */
function image(width: number, height: number, color: (x: number, y: number) => readonly number[]) {
  const data = new Uint8ClampedArray(4 * width * height);
  for (let y = 0; y < height; y++) for (let x = 0; x < width; x++) data.set(color(x, y), 4 * (y * width + x));
  return { width, height, data };
}

const [WHITE, RED, NOTHING, BLACK] = [
  [255, 255, 255, 255],
  [250, 60, 50, 255],
  [0, 0, 0, 0],
  [0, 0, 0, 255],
];

it('fills a form with as many stars as there are for it, within the unit circle about the middle', () => {
  const points = samplePoints(image(200, 100, (x, y) => (x >= 20 && x < 120 && y >= 30 && y < 80 ? WHITE : NOTHING)));
  const count = points.length / 3;
  expect(count).toBeLessThanOrEqual(MAX_TEXT_STARS);
  // One step of the grid finer would have had too many: (5.5/5)² = 1.21 times as many.
  expect(count).toBeGreaterThan(MAX_TEXT_STARS / 1.5);
  const axis = (a: number) => points.filter((_, i) => i % 3 === a);
  // The corners lie on the unit circle, and it is half as high as wide, to a step of the grid.
  expect(Math.hypot(points[0], points[1])).toBeCloseTo(1, 2);
  expect(Math.abs(Math.max(...axis(1)) / Math.max(...axis(0)) - 0.5)).toBeLessThan(0.08);
  expect(Math.max(...axis(1))).toBeCloseTo(-Math.min(...axis(1)), 9);
  expect(new Set(axis(2))).toEqual(new Set([-1]));
});

it('has y upwards, colours of stars, and dark places without stars', () => {
  const points = samplePoints(image(60, 60, (_, y) => (y < 20 ? RED : y < 40 ? BLACK : WHITE)));
  for (let i = 0; i < points.length; i += 3) {
    expect(Math.abs(points[i + 1])).toBeGreaterThan(0.2);
    expect(points[i + 2]).toBe(points[i + 1] > 0 ? 0 : -1);
  }
});

it('is empty where nothing is drawn', () => {
  expect(samplePoints(image(30, 30, () => NOTHING))).toEqual([]);
});
