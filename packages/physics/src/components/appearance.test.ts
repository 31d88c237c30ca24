import { expect, test } from 'vitest';
import { rgba } from '../index.ts';

test('a colour has its bytes in memory order, and transparent black is not the default colour', () => {
  expect(rgba(1, 0.5, 0)).toBe(0xff0080ff);
  expect(rgba(0, 0, 0, 0)).toBe(1);
  expect(rgba(0, 0, 0)).toBe(0xff000000);
});
