/** Shared by tests of force laws: a body under given forces, the force on it, and its motion. */
import {
  bodies,
  createPhysicsWorld,
  evaluateForces,
  type Force,
  type PhysicsWorld,
  type PhysicsWorldOptions,
  spawn,
  step,
} from '@principia/physics';
import type { Example, ExampleOptions } from '@principia/scenes/examples';
import { prepareForces } from '../../packages/physics/src/dynamics/evaluate-forces.ts';

export type Body = Parameters<typeof spawn>[1];

/** Creates a world with one body, by default at rest at the origin with mass 1. */
export function single(forces: readonly Force[], body: Body = {}, options: PhysicsWorldOptions = {}) {
  const world = createPhysicsWorld({ capacity: 20, forces, ...options });
  const eid = spawn(world, { position: {}, velocity: {}, mass: 1, ...body });
  return { world, eid, ...read(world, eid) };
}

/** Starts an example, and reads one of its bodies. @param eid id of the body: bodies are counted from 1 */
export function started(example: Example, options: ExampleOptions = {}, eid = 1) {
  const { world } = example.start(options);
  return { world, eid, ...read(world, eid) };
}

/** Returns position and velocity of a body. */
export function read(world: PhysicsWorld, eid: number) {
  const { Position: p, Velocity: v } = world.components;
  return {
    at: () => ({ x: p.x[eid], y: p.y[eid], z: p.z[eid] }),
    going: () => ({ x: v.x[eid], y: v.y[eid], z: v.z[eid] }),
    speed: () => Math.hypot(v.x[eid], v.y[eid], v.z[eid]),
  };
}

/** Steps for some seconds in equal steps of at most `dt`. */
export function run(world: PhysicsWorld, seconds: number, dt = 1 / 60, each?: () => void): void {
  const steps = Math.ceil(seconds / dt - 1e-9);
  for (let i = 0; i < steps; i++) {
    step(world, seconds / steps);
    each?.();
  }
}

/** Returns the force on a body, N, and the torque, N m, as at the start of a step of `dt`. */
export function forceOn(world: PhysicsWorld, eid: number, time = world.time, dt = 1e-3) {
  bodies(world);
  world.internal.sweptRows = 16 * Math.ceil((world.lastId + 1) / 16);
  prepareForces(world, dt);
  const { kernels, addresses, scratch } = world;
  for (const axis of ['x', 'y', 'z'] as const) {
    kernels.copyColumn(
      scratch.at.startVelocity[axis],
      addresses.Velocity[axis],
      0,
      16 * Math.ceil((world.lastId + 1) / 16),
    );
  }
  evaluateForces(world, world.ranges, time);
  const { force, torque } = scratch;
  // Adding 0 converts -0 to 0.
  return { x: force.x[eid] + 0, y: force.y[eid] + 0, z: force.z[eid] + 0, torque: torque.z[eid] + 0 };
}

/** Returns the force of a law on a body, 2D by default. */
export function lawOn(law: Force, body: Body, options: PhysicsWorldOptions = {}) {
  const { world, eid } = single([law], body, options);
  return forceOn(world, eid);
}

/**
 * Returns minus the gradient of the energy of all forces at a body, by central differences: the expected
 * conservative force.
 */
export function slope(world: PhysicsWorld, eid: number, h = 1e-5) {
  const energy = () => world.forces.reduce((sum, force) => sum + (force.potential?.(world) ?? Number.NaN), 0);
  const along = (axis: 'x' | 'y' | 'z') => {
    const column = world.components.Position[axis];
    const here = column[eid];
    column[eid] = here + h;
    const above = energy();
    column[eid] = here - h;
    const below = energy();
    column[eid] = here;
    return -(above - below) / (2 * h);
  };
  return { x: along('x'), y: along('y'), z: along('z') };
}
