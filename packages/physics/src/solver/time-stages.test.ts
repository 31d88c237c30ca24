// A profile tells where the time of a step of rigid bodies goes.
import {
  createPhysicsWorld,
  linearDrag,
  type PhysicsWorld,
  resetProfile,
  SOLVER_STAGES,
  spawn,
  standard,
  startProfile,
  step,
  stopProfile,
  uniformGravity,
} from '@principia/physics';
import { expect, test } from 'vitest';
import { DT, rigidWorld } from '../../../../test/support/rigid-world.ts';

/** A clock that counts how often it was read: every stage takes 1. */
const counting = () => {
  let now = 0;
  return () => now++;
};

const addBody = (world: PhysicsWorld) =>
  spawn(world, { position: {}, mass: 1, linearDrag: 1, collider: { radius: 1 } });

test('the stages of a step make up the time of the phase', () => {
  const world = rigidWorld({ forces: [uniformGravity(), linearDrag()] });
  addBody(world);
  const profile = startProfile(world, counting());
  step(world, DT);
  // Drag depends on the velocity: forces are found again in each of four sub-steps.
  const once = { gather: 1, broadPhase: 1, narrowPhase: 1, restitution: 1, continuous: 1, sleep: 1 };
  expect(profile.stages).toEqual({ ...once, forces: 4, solve: 4 });
  const sum = SOLVER_STAGES.reduce((all, stage) => all + profile.stages[stage], 0);
  // One reading begins the stages, and one ends the phase.
  expect(profile.times.integrate).toBe(sum + 2);
  resetProfile(profile);
  expect(Object.values(profile.stages)).toEqual(SOLVER_STAGES.map(() => 0));
  stopProfile(world);
  step(world, DT);
  expect(Object.values(profile.stages)).toEqual(SOLVER_STAGES.map(() => 0));
});

test('other integrators have no such stages', () => {
  const world = createPhysicsWorld({ preset: standard, capacity: 10, forces: [uniformGravity()] });
  addBody(world);
  const profile = startProfile(world, counting());
  step(world, DT);
  expect(Object.values(profile.stages)).toEqual(SOLVER_STAGES.map(() => 0));
  expect(profile.times.integrate).toBe(1);
});
