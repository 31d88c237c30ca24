import { expect, it } from 'vitest';
import { gravityOnScreen } from './device-tilt.ts';

/** Angles of the device, of its screen, and the direction of gravity on the screen. */
it.each([
  ['flat on a table', 0, 0, 0, [0, 0, -1]],
  ['upright', 90, 0, 0, [0, -1, 0]],
  ['on its head', -90, 0, 0, [0, 1, 0]],
  ['on its right edge', 0, 90, 0, [1, 0, 0]],
  // Held sideways, the screen turns with the hand, and down stays down.
  ['turned to the left', 0, -90, 90, [0, -1, 0]],
  ['turned to the right', 0, 90, 270, [0, -1, 0]],
])('gravity of a device %s', (_, beta, gamma, angle, expected) => {
  const { x, y, z } = gravityOnScreen(beta, gamma, angle);
  expect([x, y, z]).toEqual(expected);
});

it('is a unit vector in steps of 1/64', () => {
  for (let beta = -180; beta < 180; beta += 17) {
    for (let gamma = -90; gamma < 90; gamma += 13) {
      const { x, y, z } = gravityOnScreen(beta, gamma, 90);
      for (const value of [x, y, z]) expect(Number.isInteger(64 * value)).toBe(true);
      // Each component is off by half a step at most.
      expect(Math.abs(Math.hypot(x, y, z) - 1)).toBeLessThan(Math.sqrt(3) / 128);
    }
  }
});
