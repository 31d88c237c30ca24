// The body behind a surface: how it moves, and whether it yields.
import { bodyOf, hasLiveBody } from '../bodies/parts.ts';
import { isOpen } from '../ecs/rows.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { type Surface, type Vector2, ZERO } from './surface.ts';

/** The body to which an entity belongs that queries name; 0 for a wall, and for a part whose body is gone. */
export function bodyBehind(world: PhysicsWorld, id: number): number {
  if (id === 0 || !isOpen(world, id, 'Position')) return 0;
  return isOpen(world, id, 'Attachment') && !hasLiveBody(world, id) ? 0 : bodyOf(world, id);
}

/** Velocity of the matter of a body, a part or a wall at a point, m/s: v + ω × (p - r). */
export function velocityAt(world: PhysicsWorld, id: number, point: Vector2): Vector2 {
  const body = bodyBehind(world, id);
  if (body === 0) return ZERO;
  const { Position, Velocity, AngularVelocity } = world.components;
  const spin = canTurn(world, body) ? AngularVelocity.z[body] : 0;
  return {
    x: Velocity.x[body] - spin * (point.y - Position.y[body]),
    y: Velocity.y[body] + spin * (point.x - Position.x[body]),
  };
}

/** Velocity with which a surface carries what is on it, m/s: that of its matter, and as a conveyor belt. */
export function carryingVelocity(world: PhysicsWorld, { id, point, normal, isWall }: Surface): Vector2 {
  const velocity = velocityAt(world, id, point);
  const speed = isWall ? 0 : world.components.Collider.tangentSpeed[id];
  return { x: velocity.x + speed * normal.y, y: velocity.y - speed * normal.x };
}

/** Whether a body turns: it has an angular velocity that is not locked. */
export function canTurn(world: PhysicsWorld, body: number): boolean {
  return isOpen(world, body, 'AngularVelocity') && world.components.MotionLocks.angle[body] === 0;
}

/** Whether forces move a body: it has a finite mass, and is not kinematic. */
export function isMovable(world: PhysicsWorld, body: number): boolean {
  const mass = world.components.Mass.value[body];
  return mass > 0 && mass < Infinity && isOpen(world, body, 'Velocity') && !isOpen(world, body, 'Kinematic');
}
