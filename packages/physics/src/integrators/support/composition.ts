// Schemes composed of drifts and kicks.
import type { SchemeFunction } from '../../laws/scheme.ts';

/** Fractions of the step, in the order drift, kick, drift, kick, …, with an optional last drift. */
export type Lengths = readonly number[];

/** Returns the scheme drift d₁, kick k₁, drift d₂, … */
export function compose(drifts: Lengths, kicks: Lengths): SchemeFunction {
  return ({ position, velocity, dt }, kick) => {
    let [x, v] = [position, velocity];
    kicks.forEach((length, stage) => {
      x = x.add(v.mul(dt.mul(drifts[stage])));
      v = v.add(kick(x, v, sum(drifts.slice(0, stage + 1)), dt.mul(length)));
    });
    if (drifts.length > kicks.length) x = x.add(v.mul(dt.mul(drifts[kicks.length])));
    return { position: x, velocity: v };
  };
}

function sum(numbers: Lengths): number {
  return numbers.reduce((total, number) => total + number, 0);
}

/** Returns the drifts and kicks of consecutive drift-kick-drift steps of the given lengths. */
export function composeLengths(lengths: Lengths): { readonly drifts: Lengths; readonly kicks: Lengths } {
  const drifts = [lengths[0] / 2];
  for (let i = 1; i < lengths.length; i++) drifts.push((lengths[i - 1] + lengths[i]) / 2);
  drifts.push(lengths[lengths.length - 1] / 2);
  return { drifts, kicks: lengths };
}

/**
 * Tests whether the scheme keeps x″ = -ω² x - γ x′ bounded, with `stiffness` ω² dt² and `damping` γ dt: the
 * eigenvalues of the step matrix of (x, v dt) lie in the unit circle (Jury's condition).
 */
export function isStableComposition(drifts: Lengths, kicks: Lengths, stiffness: number, damping: number): boolean {
  // Columns of the matrix: the images of (1, 0) and of (0, 1).
  let [x1, v1, x2, v2] = [1, 0, 0, 1];
  for (let stage = 0; stage < drifts.length; stage++) {
    x1 += drifts[stage] * v1;
    x2 += drifts[stage] * v2;
    if (stage >= kicks.length) break;
    v1 -= kicks[stage] * (stiffness * x1 + damping * v1);
    v2 -= kicks[stage] * (stiffness * x2 + damping * v2);
  }
  const determinant = x1 * v2 - x2 * v1;
  return Math.abs(determinant) <= 1 + 1e-9 && Math.abs(x1 + v2) <= 1 + determinant + 1e-9;
}
