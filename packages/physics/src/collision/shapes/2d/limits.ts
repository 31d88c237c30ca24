import { checkNumber } from '../../../errors/validate.ts';

/** Least length of an edge and least radius, m: shorter ones have no direction left in f32 a few metres away. */
export const MIN_LENGTH = 1e-5;

/** Greatest coordinate and size, m. */
const MAX_LENGTH = 1e6;

/** Kernels have room for this number of vertices. */
export const MAX_VERTICES = 8;

const LENGTH_HINT = 'Shapes are given in metres.';

/**
 * Returns a length that is neither tiny nor huge.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE
 */
export function checkLength(value: unknown, field: string): number {
  return checkNumber(value, field, { min: MIN_LENGTH, max: MAX_LENGTH }, undefined, LENGTH_HINT);
}

/**
 * Returns a rounding: 0 for sharp corners, which is the default, or a radius.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE
 */
export function checkRounding(value: unknown, field: string): number {
  if (value === undefined || value === 0) return 0;
  return checkLength(value, field);
}

/** Bounds of a coordinate. */
export const COORDINATE = {
  min: -MAX_LENGTH,
  max: MAX_LENGTH,
  hint: 'Give the points in metres from an origin nearby, and place bodies by `position`.',
};
