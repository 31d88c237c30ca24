// A uniform electric field, steady or changing with time.
//
//   F = q E(t)        potential  U = -q E·r   (zero at the origin; only for a steady field)
//
//   q  charge, C    E  field, V/m (= N/C)
//
// Valid between plates that are wide compared to their distance, and for fields that change slowly compared to the
// light travel time across the scene: no radiation, no induced magnetic field. Griffiths, Introduction to
// Electrodynamics, chapter 2. Cost: one multiply-add per axis.
import { Charge } from '../components/charge.ts';
import { defineLaw } from '../dynamics/define-law.ts';
import type { LawOptions } from '../laws/law.ts';
import { vectorOverTime } from '../laws/parameter.ts';
import type { VectorOverTime } from '../laws/time-vector.ts';
import type { Force } from '../world/types.ts';
import { ANY } from './support/bounds.ts';

const reads = { charge: Charge };
const parameters = { field: vectorOverTime('V/m', ANY) };

const changing: LawOptions<typeof reads, typeof parameters> = {
  name: 'electric field',
  formula: 'F = q E(t)',
  source: 'Griffiths, Introduction to Electrodynamics, chapter 2.',
  reads,
  parameters,
  force: ({ charge }, { field }) => field.mul(charge),
};

const changingLaw = /* @__PURE__ */ defineLaw(changing);
const steadyLaw = /* @__PURE__ */ defineLaw({
  ...changing,
  potential: ({ position, charge }, { field }) => charge.mul(field.dot(position)).negate(),
});

/**
 * A uniform electric field, steady or changing with time: F = q E, N, on every body with `charge`.
 *
 * @param field E, V/m, or a function of the time, s, that returns it
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function electricField(field: VectorOverTime): Force {
  return typeof field === 'function' ? changingLaw({ field }) : steadyLaw({ field });
}
