import type { Precision } from '@principia/physics';

export type Column = Float32Array | Float64Array;

/** Copies the rows `ids` of a column into a dense array of the world's precision. */
export function denseColumn(precision: Precision, column: Column, ids: Uint32Array): Column {
  const values = precision === 'f32' ? new Float32Array(ids.length) : new Float64Array(ids.length);
  for (let i = 0; i < ids.length; i++) values[i] = column[ids[i]];
  return values;
}
