/** Arrows that many examples draw. */
import type { PhysicsWorld } from '@principia/physics';
import { type Arrow, COLORS, type Point } from '../picture.ts';
import { positionOf, velocityOf } from './read.ts';

/** The velocity of a body, in green. */
export function velocityArrow(world: PhysicsWorld, body: number, scale: number): Arrow {
  const from = () => positionOf(world, body);
  return { label: 'v', from, vector: () => velocityOf(world, body), scale, color: COLORS.green };
}

/** A force on a body, in red. */
export function forceArrow(
  world: PhysicsWorld,
  body: number,
  label: string,
  vector: () => Point,
  scale: number,
): Arrow {
  return { label, from: () => positionOf(world, body), vector, scale, color: COLORS.red };
}
