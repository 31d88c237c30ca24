import { expect, it } from 'vitest';
import { spawn } from '../bodies/spawn';
import { semiImplicitEuler } from '../integrators/semi-implicit-euler';
import { step } from '../step';
import { createPhysicsWorld } from '../world';
import { linearDrag } from './drag';
import type { Force } from './force';
import { uniformGravity } from './uniform-gravity';

const DT = 1 / 60;

/** Velocity after two steps of a body of 2 kg under 3 kg/s of drag that starts at 4 m/s along each axis. */
function velocityUnder(forces: Force[]): number[] {
  const world = createPhysicsWorld({ dimensions: 3, precision: 'f64', integrator: semiImplicitEuler, forces });
  const id = spawn(world, {
    position: {},
    velocity: { x: 4, y: 4, z: 4 },
    mass: 2,
    linearDrag: 3,
  });
  step(world, DT);
  step(world, DT);
  const { x, y, z } = world.components.Velocity;
  return [x[id], y[id], z[id]];
}

it('gravity that comes first writes over the forces of the step before, along every axis', () => {
  const gravity = uniformGravity({ y: -10 });
  const first = velocityUnder([gravity, linearDrag()]);
  // v' = v (1 - c dt/m) + g dt, twice
  const factor = 1 - (3 / 2) * DT;
  expect(first[0]).toBeCloseTo(4 * factor * factor, 14);
  expect(first[1]).toBeCloseTo(4 * factor * factor - 10 * DT * (1 + factor), 14);
  expect(first[2]).toBe(first[0]);
});

it('a copy of gravity with a law of its own is asked for that law', () => {
  const nothing: Force = { ...uniformGravity({ y: -10 }), accumulate() {} };
  expect(velocityUnder([nothing])).toEqual([4, 4, 4]);
});
