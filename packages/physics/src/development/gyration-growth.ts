// What the integrators make of the speed of a body that a force only turns: v' = iΩ v, with v a complex number.
//
// A step of h multiplies v by a polynomial in z = iθ, θ = Ω h, of which only the length matters:
//
//   Euler's schemes, and others that add one force to v      |1 + z|² = 1 + θ²
//   velocity Verlet, midpoint, Heun                           |1 + z + z²/2|² = 1 + θ⁴/4
//   Runge-Kutta 4                      |1 + z + z²/2 + z³/6 + z⁴/24|² = 1 - θ⁶/72 + θ⁸/576
//   implicit Euler                                            1/|1 - z|² = 1/(1 + θ²)
//   position Verlet, which acts on v as Adams and Bashforth's second order does:
//                                      λ² - (1 + 3z/2) λ + z/2 = 0, of which the longer root counts
//
// Rigid bodies move by semi-implicit Euler in their sub-steps. `dormandPrince` and `gaussRadau` choose their steps by the error,
// `boris` turns velocities, and the schemes that split a step have a warning of their own.
import { log } from '../math/elementary.ts';
import type { Integrator } from '../world/types.ts';

type SquaredFactor = (theta: number) => number;

const square = (x: number) => x * x;

const oneKick: SquaredFactor = (theta) => 1 + square(theta);
const twoKicks: SquaredFactor = (theta) => 1 + square(square(theta)) / 4;

const SQUARED_FACTORS: Readonly<Record<string, SquaredFactor>> = {
  'explicit Euler': oneKick,
  'semi-implicit Euler': oneKick,
  'position-first Euler': oneKick,
  'Wisdom-Holman': oneKick,
  'velocity Verlet': twoKicks,
  midpoint: twoKicks,
  Heun: twoKicks,
  'Runge-Kutta 4': (theta) => 1 - (square(theta * theta) * square(theta)) / 72 + square(square(theta * theta)) / 576,
  'implicit Euler': (theta) => 1 / (1 + square(theta)),
  'position Verlet': ofPositionVerlet,
};

/**
 * Returns the rate, 1/s, at which the integrator makes a speed grow that is turned by Ω, rad/s; negative where it gets smaller, and
 * undefined where that is not known. In n seconds the speed is e^(n rate) times as large.
 * @param omega Ω, rad/s
 * @param dt length of the step, s
 */
export function growthRate(integrator: Integrator, omega: number, dt: number): number | undefined {
  const { name, solvesWalls, evaluations } = integrator;
  const squared = solvesWalls === true ? oneKick : SQUARED_FACTORS[name];
  if (squared === undefined) return undefined;
  const h = solvesWalls === true ? dt / evaluations : dt;
  return log(squared(omega * h)) / 2 / h;
}

/** The squared length of λ = (1 + 3z/2 + √((1 + 3z/2)² - 2z))/2. */
function ofPositionVerlet(theta: number): number {
  const re = 1 - 2.25 * square(theta);
  const length = Math.sqrt(square(re) + square(theta));
  const rootRe = Math.sqrt(Math.max(0, (length + re) / 2));
  const rootIm = Math.sqrt(Math.max(0, (length - re) / 2));
  return (square(1 + rootRe) + square(1.5 * theta + rootIm)) / 4;
}
