// The instructions of the operations on 128-bit vectors.
import type { Operation } from './node.ts';

/** Instructions with a type of lanes. */
export const LANES: Readonly<Partial<Record<Operation, string>>> = {
  add: 'add',
  sub: 'sub',
  mul: 'mul',
  div: 'div',
  sqrt: 'sqrt',
  floor: 'floor',
  round: 'nearest',
  min: 'pmin',
  max: 'pmax',
  less: 'lt',
  lessOrEqual: 'le',
  equal: 'eq',
};

/** Instructions on all bits. */
export const BITS: Readonly<Partial<Record<Operation, string>>> = { and: 'v128.and', or: 'v128.or', not: 'v128.not' };

/** Instructions on a value and the mask of the sign bits, made once: engines make it anew at each `abs` and `neg`. */
export const SIGNS: Readonly<Partial<Record<Operation, string>>> = { negate: 'v128.xor', abs: 'v128.andnot' };

/** Functions of kernels/math, called per lane, so that the results are bitwise equal to scalar calls. */
export const FUNCTIONS = new Set<Operation>(['sin', 'cos', 'exp', 'log', 'pow', 'atan2', 'noise']);
