/** Hyperbolic functions that are the same on every engine. */
import { exp, log } from '@principia/physics';

/** Valid for |x| below 700, as `cosh`. */
export function sinh(x: number): number {
  return (exp(x) - exp(-x)) / 2;
}

export function cosh(x: number): number {
  return (exp(x) + exp(-x)) / 2;
}

/** Valid for |x| below 300. */
export function tanh(x: number): number {
  const square = exp(2 * x);
  return (square - 1) / (square + 1);
}

/** Valid for |x| below 1. */
export function atanh(x: number): number {
  return log((1 + x) / (1 - x)) / 2;
}
