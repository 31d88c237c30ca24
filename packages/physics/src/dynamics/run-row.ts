// Runs the loop of impacts for one body, whatever else is in its vector.
import type { PhysicsWorld } from '../world/types.ts';
import type { ImpactLoop } from './impact-loop.ts';

/** Memory for the states of the bodies of a vector of `lanes` lanes. */
export const keptStates = (world: PhysicsWorld, lanes: number) => new Float64Array(lanes * 2 * world.dimensions);

/** Runs the loop on a row, and keeps the states of the others of its vector. */
export function runRow(loop: ImpactLoop, row: number, lanes: number, kept: Float64Array): void {
  const first = row - (row % lanes);
  keepLanes(loop, first, lanes, kept);
  loop.run(first, first + lanes, 0);
  restoreLanes(loop, first, row, lanes, kept);
}

/** Keeps the states of the bodies of a vector. */
function keepLanes({ position, velocity }: ImpactLoop, first: number, lanes: number, kept: Float64Array): void {
  const axes = position.length;
  for (let lane = 0; lane < lanes; lane++) {
    for (let i = 0; i < axes; i++) {
      kept[2 * (lane * axes + i)] = position[i][first + lane];
      kept[2 * (lane * axes + i) + 1] = velocity[i][first + lane];
    }
  }
}

/** Gives the bodies of a vector their states back, except that of one row. */
function restoreLanes(
  { position, velocity }: ImpactLoop,
  first: number,
  row: number,
  lanes: number,
  kept: Float64Array,
): void {
  const axes = position.length;
  for (let lane = 0; lane < lanes; lane++) {
    if (first + lane === row) continue;
    for (let i = 0; i < axes; i++) {
      position[i][first + lane] = kept[2 * (lane * axes + i)];
      velocity[i][first + lane] = kept[2 * (lane * axes + i) + 1];
    }
  }
}
