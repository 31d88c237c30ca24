import type { Loop } from '../laws/compile.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** Handles the vector of rows [first, last): repairs its bodies and runs the loop on it unchecked. */
export type HandleInvalid = (world: PhysicsWorld, run: Loop, first: number, last: number, dt: number) => void;

/**
 * Runs a loop with its checks over rows [first, last). Where a body is out of range the loop stops before it stores anything
 * for the body's vector; `handle` takes that vector, and the loop continues after it.
 */
export function runChecked(
  world: PhysicsWorld,
  run: Loop,
  first: number,
  last: number,
  dt: number,
  handle: HandleInvalid,
): void {
  const lanes = world.precision === 'f32' ? 4 : 2;
  let row = run(first, last, 1);
  while (row < last) {
    handle(world, run, row, row + lanes, dt);
    row += lanes;
    if (row < last) row = run(row, last, 1);
  }
}
