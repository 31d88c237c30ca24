import type { PhysicsWorld } from '../world/types.ts';
import type { AxisAddresses } from './columns.ts';

/** Zeroes rows [first, last) of one column per axis. */
export function clearAxes(
  { kernels }: PhysicsWorld,
  columns: Readonly<AxisAddresses>,
  axes: readonly (keyof AxisAddresses)[],
  first: number,
  last: number,
): void {
  for (const axis of axes) kernels.zeroColumn(columns[axis], first, last);
}
