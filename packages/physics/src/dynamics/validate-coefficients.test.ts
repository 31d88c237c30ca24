// When a bad coefficient is found: at once if other bodies read it, within 128 steps if it stays with its own body.
import { expect, test } from 'vitest';
import { bodyState, steps } from '../../../../test/support/worlds.ts';
import {
  createPhysicsWorld,
  defineForce,
  type Fault,
  type Force,
  mutualGravity,
  on,
  particleContacts,
  spawn,
  springs,
  step,
} from '../index.ts';

const ROUND = 128;

/** Pulls each body towards the first, in proportion to the first one's mass. */
const leash = (readsOfOthers?: readonly 'Mass'[]): Force =>
  defineForce({
    name: 'leash',
    local: false,
    ...(readsOfOthers && { readsOfOthers }),
    accumulate({ components: { Position, Mass }, scratch: { force } }, first, last) {
      for (let eid = first; eid < last; eid++) {
        if (Mass.value[eid] > 0) force.x[eid] -= Mass.value[1] * Position.x[eid];
      }
    },
  });

/** Three bodies, two of them tied by a spring: the first, whose mass becomes NaN after a step, and the last. */
function tied(force: Force, mass: number) {
  const world = createPhysicsWorld({ capacity: 64, forces: [force] });
  const faults: Fault[] = [];
  on(world, 'fault', (fault) => void faults.push(fault));
  const [a, b, c] = [0, 1, 2].map((x) => spawn(world, { position: { x }, mass: 1 }));
  spawn(world, { spring: { a, b: c, stiffness: 10, length: 1 } });
  step(world, 1 / 60);
  world.components.Mass.value[a] = mass;
  return { world, faults, others: () => [b, c].map((eid) => bodyState(world, eid)) };
}

test.each([
  ['springs', springs()],
  ['gravity', mutualGravity({ G: 1, softening: 0.1 })],
  ['a force that says what it reads', leash(['Mass'])],
  ['a force that does not', leash()],
])('a mass of NaN reaches no other body: %s', (_, force) => {
  // A mass of 0 is that of an anchor.
  const [good, bad] = [tied(force, 0), tied(force, Number.NaN)];
  for (const { world } of [good, bad]) steps(world, ROUND);
  expect(bad.others()).toEqual(good.others());
  expect(bad.faults).toMatchObject([{ code: 'E_NONFINITE', field: 'Mass.value' }]);
});

test.each([
  ['gravity', mutualGravity({ G: 1, softening: 0.1 })],
  ['a force that does not say what it reads', leash()],
])('%s: the fault is found in the step in which the value was written', (_, force) => {
  const { world, faults } = tied(force, Number.NaN);
  step(world, 1 / 60);
  expect(faults).toHaveLength(1);
});

test.each([
  ['restitution', 1],
  ['friction', 1],
  ['rollingResistance', ROUND],
] as const)('contacts of round bodies: a bad %s is found after at most %i steps', (field, most) => {
  const world = createPhysicsWorld({ capacity: 64, preset: particleContacts });
  const [a, b] = [0, 1].map((x) => spawn(world, { position: { x }, velocity: {}, mass: 1, collider: 0.4 }));
  step(world, 1 / 60);
  world.components.Collider[field][a] = Number.NaN;
  let taken = 0;
  while (world.faults.faults.length === 0 && taken < ROUND) {
    step(world, 1 / 60);
    taken++;
  }
  expect(world.faults.faults).toMatchObject([{ entity: a, field: `Collider.${field}` }]);
  expect(taken).toBeLessThanOrEqual(most);
  expect(bodyState(world, b)).not.toContain('NaN');
});
