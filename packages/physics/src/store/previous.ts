import type { RealColumn } from '../components/define';
import type { Precision } from '../kernels/instantiate';
import type { Arena } from './arena';
import { type AxisAddresses, type AxisColumns, axisColumns, realColumn } from './columns';

/** The pose of every body at the start of the last step: what renderers interpolate from. */
export interface Previous {
  readonly Position: AxisColumns;
  readonly Rotation: { readonly angle: RealColumn };
  readonly Orientation: AxisColumns & { readonly w: RealColumn };
}

export interface PreviousAddresses {
  readonly Position: AxisAddresses;
  readonly Rotation: { readonly angle: number };
  readonly Orientation: AxisAddresses & { readonly w: number };
}

/** Number of real columns it takes. */
export const PREVIOUS_COLUMNS = 8;

export function createPrevious(arena: Arena, precision: Precision, rows: number): [Previous, PreviousAddresses] {
  const [position, positionAt] = axisColumns(arena, precision, rows, 'previous Position');
  const [angle, angleAt] = realColumn(arena, precision, rows, 'previous Rotation');
  const [orientation, orientationAt] = axisColumns(arena, precision, rows, 'previous Orientation');
  const [w, wAt] = realColumn(arena, precision, rows, 'previous Orientation.w');
  return [
    { Position: position, Rotation: { angle }, Orientation: { ...orientation, w } },
    { Position: positionAt, Rotation: { angle: angleAt }, Orientation: { ...orientationAt, w: wAt } },
  ];
}
