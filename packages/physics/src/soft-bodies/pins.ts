// Pins: a pinned node has no finite mass, so only its velocity moves it, not forces or constraints.
import { addComponent, set } from 'bitecs';
import { warnAboutFreePin } from '#warnings';
import { assertBody } from '../ecs/entity-ref.ts';
import { checkNumber, checkPoint, type VectorInput } from '../errors/validate.ts';
import type { PhysicsWorld } from '../world/types.ts';

/**
 * Pins a node at its position.
 * @returns its mass before, kg (0 if it was pinned already), to pass to `unpin`
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

/** Releases a node by giving it a mass, kg. @throws PhysicsError E_STALE, E_TYPE, E_NONFINITE, E_RANGE, E_DESTROYED */
export function unpin(world: PhysicsWorld, node: number, mass: number): void {
  assertBody(world, node);
  checkNumber(mass, 'unpin: mass', { above: 0 });
  addComponent(world, node, set(world.components.Mass, { value: mass }));
}

/**
 * Sets the velocity of a pinned node, or of a kinematic body, so that it reaches `to` within the next `dt` seconds. Call it before every step
 * of the motion; `pin` stops the node.
 * @throws PhysicsError E_STALE, E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN, E_DESTROYED
 */
export function movePin(world: PhysicsWorld, node: number, to: VectorInput, dt: number): void {
  assertBody(world, node);
  const { x, y, z } = checkPoint(to, 'movePin: to');
  checkNumber(dt, 'movePin: dt', { above: 0 });
  warnAboutFreePin(world, node);
  const { Position, Velocity } = world.components;
  const velocity = {
    x: (x - Position.x[node]) / dt,
    y: (y - Position.y[node]) / dt,
    z: (z - Position.z[node]) / dt,
  };
  addComponent(world, node, set(Velocity, velocity));
}
