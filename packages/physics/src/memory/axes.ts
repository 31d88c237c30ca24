import type { PhysicsWorld } from '../world/create-world.ts';
import type { AxisAddresses } from './columns.ts';

/** The axes of a world by its dimensions: names that key columns and addresses alike. */
export const AXES = { 2: ['x', 'y'], 3: ['x', 'y', 'z'] } as const;

/** The component that holds how far a body is turned, likewise. */
export const ANGLES = { 2: 'Rotation', 3: 'Orientation' } as const;

/** Zeroes the rows [first, last) of columns, one for each axis. */
export function clearAxes(
  { kernels }: PhysicsWorld,
  columns: Readonly<AxisAddresses>,
  axes: readonly (keyof AxisAddresses)[],
  first: number,
  last: number,
): void {
  for (const axis of axes) kernels.zeroColumn(columns[axis], first, last);
}
