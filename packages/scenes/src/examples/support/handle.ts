/** A grip that one can drag, which carries an emitter along. */
import { type PhysicsWorld, rgba, spawn } from '@principia/physics';
import type { Point } from '../picture.ts';

export function addHandle(world: PhysicsWorld, position: Point): number {
  return spawn(world, { position, velocity: {}, collider: 9, appearance: rgba(0.75, 0.8, 1, 0.7) });
}
