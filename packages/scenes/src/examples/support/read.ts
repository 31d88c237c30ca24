/** Short readings of a world, for pictures, plots and checks. */
import { createPhysicsWorld, type PhysicsWorld } from '@principia/physics';
import type { Point } from '../picture.ts';

/** A run with one body of interest. */
export interface BallRun {
  readonly world: PhysicsWorld;
  readonly ball: number;
}

export function positionOf({ components: { Position } }: PhysicsWorld, id: number): Required<Point> {
  return { x: Position.x[id], y: Position.y[id], z: Position.z[id] };
}

export function velocityOf({ components: { Velocity } }: PhysicsWorld, id: number): Required<Point> {
  return { x: Velocity.x[id], y: Velocity.y[id], z: Velocity.z[id] };
}

/** Length of a vector. */
export function lengthOf({ x, y, z = 0 }: Point): number {
  return Math.sqrt(x * x + y * y + z * z);
}

export function speedOf(world: PhysicsWorld, id: number): number {
  return lengthOf(velocityOf(world, id));
}

export function distanceBetween(a: Point, b: Point): number {
  return lengthOf({ x: a.x - b.x, y: a.y - b.y, z: (a.z ?? 0) - (b.z ?? 0) });
}

/** An empty world, for examples without bodies: only its time goes on. */
export function emptyWorld(): PhysicsWorld {
  return createPhysicsWorld({ capacity: 1 });
}
