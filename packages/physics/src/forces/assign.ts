import type { PhysicsWorld } from '../world';
import type { Force } from './force';

/** Writes a force, N, over whatever stands in the force columns of rows [first, last), every axis of them. */
export type Assign = (world: PhysicsWorld, first: number, last: number) => void;

/** Kept beside the forces, so that a copy with an `accumulate` of its own does not inherit it. */
const assigners = new WeakMap<Force, Assign>();

/** Lets a local, timeless force that comes first in a world spare the step clearing the force columns. */
export function letAssign(force: Force, assign: Assign): void {
  assigners.set(force, assign);
}

export function assignerOf(force: Force): Assign | undefined {
  return assigners.get(force);
}
