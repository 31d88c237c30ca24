/** What tests of force laws share: one body under some forces, the force on it, and how it goes on. */
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
import { prepareForces } from '../../packages/physics/src/dynamics/evaluate-forces.ts';

export type Body = Parameters<typeof spawn>[1];

/** A world with one body, which is at rest at the origin with mass 1 unless said otherwise. */
export function single(forces: readonly Force[], body: Body = {}, options: PhysicsWorldOptions = {}) {
  const world = createPhysicsWorld({ capacity: 20, forces, ...options });
  const eid = spawn(world, { position: {}, velocity: {}, mass: 1, ...body });
  return { world, eid, ...read(world, eid) };
}

/** Where a body is and how fast. */
export function read(world: PhysicsWorld, eid: number) {
  const { Position: p, Velocity: v } = world.components;
  return {
    at: () => ({ x: p.x[eid], y: p.y[eid], z: p.z[eid] }),
    going: () => ({ x: v.x[eid], y: v.y[eid], z: v.z[eid] }),
    speed: () => Math.hypot(v.x[eid], v.y[eid], v.z[eid]),
  };
}

/** Goes on for some seconds in equal steps of at most `dt`. */
export function run(world: PhysicsWorld, seconds: number, dt = 1 / 60, each?: () => void): void {
  const steps = Math.ceil(seconds / dt - 1e-9);
  for (let i = 0; i < steps; i++) {
    step(world, seconds / steps);
    each?.();
  }
}

/** The force on a body now, N, and the torque, N m. */
export function forceOn(world: PhysicsWorld, eid: number, time = world.time) {
  bodies(world);
  world.internal.sweptRows = 16 * Math.ceil((world.lastId + 1) / 16);
  prepareForces(world, 1e-3);
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
  // No force has no direction: of minus zero this makes zero.
  return { x: force.x[eid] + 0, y: force.y[eid] + 0, z: force.z[eid] + 0, torque: torque.z[eid] + 0 };
}

/** The force that a law puts on one body, 2D unless the body says otherwise. */
export function lawOn(law: Force, body: Body, options: PhysicsWorldOptions = {}) {
  const { world, eid } = single([law], body, options);
  return forceOn(world, eid);
}

/** Minus the gradient of the energy of all forces at a body, by central differences: what a conservative force must be. */
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
