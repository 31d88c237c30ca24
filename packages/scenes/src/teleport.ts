import type { PhysicsWorld } from '@principia/physics';

/** Moves a body to another place at once, with another velocity: by default it is at rest there. */
export function teleport(
  { components: { Position, Velocity }, previous, versions }: PhysicsWorld,
  id: number,
  position: { readonly x: number; readonly y: number },
  velocity: { readonly x: number; readonly y: number } = { x: 0, y: 0 },
): void {
  Position.x[id] = position.x;
  Position.y[id] = position.y;
  Velocity.x[id] = velocity.x;
  Velocity.y[id] = velocity.y;
  // Prevents interpolation between the old and the new position.
  previous.Position.x[id] = position.x;
  previous.Position.y[id] = position.y;
  versions.pose++;
}
