// Pins: a node that is held has no finite mass, so forces and constraints do not move it; its velocity does.
import { addComponent, set } from 'bitecs';
import { assertBody } from '../ecs/entity-ref.ts';
import { checkNumber, checkVector, type VectorInput } from '../errors/validate.ts';
import type { PhysicsWorld } from '../world/types.ts';

/**
 * Holds a node where it is.
 * @returns the mass it had, kg (0 when it was held before): what `unpin` wants back
 * @throws PhysicsError E_STALE, E_DESTROYED
 */
export function pin(world: PhysicsWorld, node: number): number {
  assertBody(world, node);
  const { Mass, Velocity } = world.components;
  const mass = Mass.value[node];
  addComponent(world, node, set(Mass, { value: Infinity }));
  addComponent(world, node, set(Velocity, { x: 0, y: 0, z: 0 }));
  return mass;
}

/** Lets a node go. @throws PhysicsError E_STALE, E_TYPE, E_NONFINITE, E_RANGE, E_DESTROYED */
export function unpin(world: PhysicsWorld, node: number, mass: number): void {
  assertBody(world, node);
  checkNumber(mass, 'unpin: mass', { above: 0 });
  addComponent(world, node, set(world.components.Mass, { value: mass }));
}

/**
 * Gives a held node the velocity that takes it to a place within the next `dt` seconds. Call it every step while it
 * moves; `pin` stops it.
 * @throws PhysicsError E_STALE, E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN, E_DESTROYED
 */
export function movePin(world: PhysicsWorld, node: number, to: VectorInput, dt: number): void {
  assertBody(world, node);
  const { x, y, z } = checkVector(to, 'movePin: to');
  checkNumber(dt, 'movePin: dt', { above: 0 });
  const { Position, Velocity } = world.components;
  const speeds = {
    x: (x - Position.x[node]) / dt,
    y: (y - Position.y[node]) / dt,
    z: (z - Position.z[node]) / dt,
  };
  addComponent(world, node, set(Velocity, speeds));
}
