import type { Precision } from '../kernels/instantiate.ts';
import { realBytes } from './columns.ts';
import { LISTED_VECTOR_SIZE, WALL_LIST_BYTES } from './layouts.gen.ts';

/** Bytes of a list of bodies at walls with room for all rows: a `WallList` of kernels/particle-contacts/walls/box.ts. */
export function wallListBytes(rows: number, precision: Precision): number {
  const vectors = (rows * realBytes(precision)) / 16;
  return WALL_LIST_BYTES + vectors * LISTED_VECTOR_SIZE;
}
