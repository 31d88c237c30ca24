import { expect, test } from 'vitest';
import { cloud } from '../../../../test/support/point-clouds.ts';
import { spawnMany } from '../bodies/spawn-many.ts';
import { createPhysicsWorld } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import { mutualGravity } from './mutual-gravity.ts';

const COUNT = 8000;
const SOFTENING = 0.1;
const REQUESTED = 0.005;

/** Measures of the tree for a uniform cloud, a tenth of which is in a cube of `side`, after some steps at rest. */
function measured(side: number | undefined, dimensions: 2 | 3, steps = 1) {
  const force = mutualGravity({ G: 1e-9, softening: SOFTENING, method: 'tree', relativeError: REQUESTED });
  const world = createPhysicsWorld({ dimensions, capacity: COUNT, forces: [force], arenaBytes: 2 ** 23 });
  const { x, y, z, mass } = cloud('uniform', COUNT, dimensions);
  if (side !== undefined) {
    const clump = cloud('uniform', COUNT / 10, dimensions);
    for (let i = 0; i < COUNT / 10; i++) {
      const at = 10 * i;
      [x[at], y[at], z[at]] = [0.5 + side * clump.x[i], side * clump.y[i], side * clump.z[i]];
    }
  }
  spawnMany(world, COUNT, { position: { x, y, ...(dimensions === 3 && { z }) }, velocity: {}, mass });
  for (let i = 0; i < steps; i++) step(world, 1e-3);
  const { bodyPairs, error } = force.report(world);
  return { bodyPairs, error, now: force.rmsError(world) };
}

test.each([2, 3] as const)(
  'a clump that softening smooths costs the tree hardly more than none, in %iD',
  (dimensions) => {
    const none = measured(undefined, dimensions);
    // Bodies of a clump of this size are near each other for every cell of the tree, but as far as forces go in one place.
    const clumped = measured(SOFTENING / 100, dimensions);
    expect(clumped.now).toBeLessThan(REQUESTED);
    expect(clumped.bodyPairs / none.bodyPairs).toBeLessThan(1.6);
  },
);

test.each([2, 3] as const)('the first evaluation finds a tolerance that is not far too small, in %iD', (dimensions) => {
  for (const side of [0.5, 0.1, 0.02, 0.001]) {
    const { error, now } = measured(side, dimensions);
    expect(now, `${side}`).toBeLessThan(REQUESTED);
    // A third of the error that is allowed costs about a fifth more.
    expect(error, `${side}`).toBeGreaterThan(0.3 * REQUESTED);
  }
});
