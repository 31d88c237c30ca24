// Systems of the `begin` phase run before the integrator, which continues from the state that they leave.
import { describe, expect, test } from 'vitest';
import { spawn } from '../bodies/spawn.ts';
import { springs } from '../forces/springs.ts';
import { INTEGRATORS, type IntegratorName } from '../integrators/support/integrator-list.ts';
import { createPhysicsWorld } from '../world/create-world.ts';
import { step } from '../world/step.ts';

/** Wisdom-Holman needs a central body. */
const NAMES = (Object.keys(INTEGRATORS) as IntegratorName[]).filter((name) => name !== 'wisdomHolman');

const STEPS = 10;
const DT = 0.125;
const SPEED = 3;

describe.each([
  ['laws alone', []],
  ['a force that is not a law', [springs()]],
])('a velocity that a system of the `begin` phase writes, with %s', (_name, forces) => {
  test.each(NAMES)('moves the body in the same step: %s', (name) => {
    const world = createPhysicsWorld({ capacity: 4, precision: 'f64', forces, integrator: INTEGRATORS[name].create() });
    const body = spawn(world, { position: { x: 1 }, velocity: {}, mass: 1 });
    const { Position, Velocity } = world.components;
    world.phases.begin.push(() => {
      Velocity.x[body] = world.tick < STEPS / 2 ? SPEED : -SPEED;
    });
    for (let s = 0; s < STEPS / 2; s++) step(world, DT);
    // Some schemes add up a step from several parts, each rounded once; there are at most eight.
    const tolerance = STEPS * 8 * Number.EPSILON * (1 + SPEED * STEPS * DT);
    expect(Math.abs(Position.x[body] - (1 + (SPEED * STEPS * DT) / 2))).toBeLessThan(tolerance);
    for (let s = 0; s < STEPS / 2; s++) step(world, DT);
    expect(Math.abs(Position.x[body] - 1)).toBeLessThan(tolerance);
  });
});
