/** Numbers of functions of one variable, found as a computer does: from values alone. */
import { type Point, pointsOf } from '../picture.ts';

export type RealFunction = (x: number) => number;

/** Points of the graph of a function. */
export function graphOf(f: RealFunction, from: number, to: number, count = 400): Point[] {
  return pointsOf((x) => ({ x, y: f(x) }), from, to, count);
}

/** The zero between two numbers at which the function has opposite signs, by bisection. */
export function rootOf(f: RealFunction, from: number, to: number): number {
  let [a, b] = [from, to];
  for (let i = 0; i < 60; i++) {
    const middle = (a + b) / 2;
    if (f(a) > 0 === f(middle) > 0) a = middle;
    else b = middle;
  }
  return (a + b) / 2;
}

/** The slope at a place, by the centred difference over ±h: exact for parabolas. */
export function slopeOf(f: RealFunction, x: number, h = 1e-3): number {
  return (f(x + h) - f(x - h)) / (2 * h);
}

/** The area under a function by the trapezoid rule. */
export function areaOf(f: RealFunction, from: number, to: number, steps: number): number {
  const h = (to - from) / steps;
  let sum = (f(from) + f(to)) / 2;
  for (let i = 1; i < steps; i++) sum += f(from + i * h);
  return h * sum;
}

/** The area under a function by rectangles whose height is the value at their left side. */
export function leftSumOf(f: RealFunction, from: number, to: number, steps: number): number {
  return areaOf(f, from, to, steps) - (((to - from) / steps) * (f(to) - f(from))) / 2;
}

/** Largest absolute value at equal distances. */
export function largestOf(f: RealFunction, from: number, to: number, count = 1000): number {
  let largest = 0;
  for (let i = 0; i <= count; i++) largest = Math.max(largest, Math.abs(f(from + ((to - from) * i) / count)));
  return largest;
}
