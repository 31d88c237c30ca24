import { BLACK_HOLE } from '@principia/scenes';
import { expect, it } from 'vitest';
import { frequencyRatio, hearHole, tideAt } from './tidal-hum.ts';

it('tides fall with the cube of the distance', () => {
  expect(tideAt(40, 20)).toBeCloseTo(1 / 8, 12);
  expect(tideAt(10, 20)).toBe(1);
});

it('the pitch falls near a horizon, to nothing at it, and by the Doppler effect on the way there', () => {
  expect(frequencyRatio(1e9, 20, 0)).toBeCloseTo(1, 6);
  expect(frequencyRatio(40, 20, 0)).toBeCloseTo(Math.SQRT1_2, 12);
  expect(frequencyRatio(20, 20, 0)).toBe(0);
  const half = BLACK_HOLE.lightSpeed / 2;
  expect(frequencyRatio(40, 20, half) / frequencyRatio(40, 20, 0)).toBeCloseTo(2 / 3, 12);
  expect(frequencyRatio(40, 20, -half) / frequencyRatio(40, 20, 0)).toBeCloseTo(2, 12);
});

it('the hole with the strongest tides is heard', () => {
  const hum = { loudness: 0, frequency: 0 };
  const ship = { x: 0, y: 0, vx: 0, vy: 0 };
  hearHole(hum, ship, 100, 0, 20);
  const { loudness } = hum;
  hearHole(hum, ship, 0, 300, 20);
  expect(hum.loudness).toBe(loudness);
  hearHole(hum, ship, 0, 40, 20);
  expect(hum.loudness).toBeGreaterThan(loudness);
});
