import { expect, it } from 'vitest';
import { pedalsByKey } from './rudder-slider.ts';

it('moves the pedals by the keys of a slider, in ten steps to each side', () => {
  let position = 0;
  for (let i = 0; i < 12; i++) position = pedalsByKey('ArrowLeft', position) ?? Number.NaN;
  expect(position).toBe(-1);
  for (let i = 0; i < 10; i++) position = pedalsByKey('ArrowRight', position) ?? Number.NaN;
  expect(position).toBeCloseTo(0, 12);
  expect(['Home', 'End', 'ArrowUp', 't'].map((key) => pedalsByKey(key, position))).toEqual([
    -1,
    1,
    undefined,
    undefined,
  ]);
});
