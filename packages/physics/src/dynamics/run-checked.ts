import type { Loop } from '../laws/compile.ts';
import type { PhysicsWorld } from '../world/types.ts';
import type { WorldLoop } from './world-loop.ts';

/** Handles the rows [first, last) of an iteration: repairs its bodies and runs the loop on it unchecked. */
export type HandleInvalid = (world: PhysicsWorld, run: Loop, first: number, last: number, dt: number) => void;

/**
 * Runs a loop with its checks over rows [first, last). Where a body is out of range the loop stops before it stores anything
 * in that iteration; `handle` takes its rows, and the loop continues after them.
 */
export function runChecked(
  world: PhysicsWorld,
  { run, compiled }: WorldLoop,
  first: number,
  last: number,
  dt: number,
  handle: HandleInvalid,
): void {
  const rows = compiled.vectors * (world.precision === 'f32' ? 4 : 2);
  let row = run(first, last, 1);
  while (row < last) {
    handle(world, run, row, row + rows, dt);
    row += rows;
    if (row < last) row = run(row, last, 1);
  }
}
