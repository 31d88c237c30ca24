// Uniform gravity: every body with mass has the same acceleration.
//
//   F = m g            potential  U = -m g·r   (zero at the origin)
//
//   m  mass, kg        g  acceleration, m/s², times the GravityScale of the body if it has one
//
// Valid near the surface of a planet, over heights small compared to its radius (over 1 km g decreases by 0.03 %).
// Cost: one multiply-add per axis.
import { GravityScale } from '../components/gravity-scale.ts';
import { defineLaw } from '../dynamics/define-law.ts';
import type { VectorInput } from '../errors/validate.ts';
import { select } from '../laws/expression.ts';
import { vector } from '../laws/parameter.ts';
import type { Force } from '../world/types.ts';
import { STANDARD_GRAVITY } from './support/standard-gravity.ts';

const law = /* @__PURE__ */ defineLaw({
  name: 'uniform gravity',
  formula: 'F = m g',
  source: 'Standard gravity 9.80665 m/s²: 3rd CGPM (1901), resolution on the unit of mass.',
  parameters: {
    /** Acceleration g, m/s²; by default standard gravity downwards. */
    acceleration: vector('m/s²', { default: { y: -STANDARD_GRAVITY }, min: -1e12, max: 1e12 }),
  },
  reads: { scale: GravityScale },
  acceleration: ({ has, scale }, { acceleration }) => acceleration.mul(select(has(GravityScale), scale, 1)),
  potential: ({ position, mass, has, scale }, { acceleration }) =>
    mass
      .mul(acceleration.dot(position))
      .negate()
      .mul(select(has(GravityScale), scale, 1)),
});

/**
 * The same acceleration for every body with mass.
 * @param acceleration g, m/s²; by default standard gravity downwards
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function uniformGravity(acceleration: VectorInput = { y: -STANDARD_GRAVITY }): Force {
  return law({ acceleration });
}
