// Added mass: a body that accelerates takes some of the fluid along, so the same force accelerates it less.
//
//   F' = F m/(m + C ρ V f)        so that  a = F/(m + C ρ V f)
//
//   F  force of all laws listed before this one, N    C  coefficient: ½ for a sphere, 1 for a cylinder across the flow
//   ρ V f  mass of the fluid displaced, kg
//
// List it last. Without it a bubble lighter than water would leave at hundreds of g; with C = ½ at no more than 2 g.
// The fluid's share of kinetic energy, ½ C ρ V f v², is not in `energy(world)`.
// Lamb, Hydrodynamics, section 92; valid for inviscid flow far from walls. In single precision, what is left of an
// acceleration that is nearly all taken back has the rounding of the whole: 3·10⁻⁵ of it for a bubble of air in water.
// Cost: some 20 operations and two divisions a body.
import { Collider } from '../components/collider.ts';
import { Hull } from '../components/hull.ts';
import { defineLaw } from '../dynamics/define-law.ts';
import { checkNumber } from '../errors/validate.ts';
import { type Scalar, select, type Vector } from '../laws/expression.ts';
import { scalar } from '../laws/parameter.ts';
import type { Force } from '../world/types.ts';
import { type FluidVolume, fluidVolumeValues, immersion, POOL } from './support/fluid-volume.ts';

const about = {
  name: 'added mass',
  formula: "F' = F m / (m + C ρ V f)",
  source: 'Lamb, Hydrodynamics, section 92.',
  reads: { hull: Hull, collider: Collider },
};

const { density } = POOL;
const coefficient = /* @__PURE__ */ scalar('');

/** What is taken from the acceleration: a - a m/(m + M) for the mass M of fluid that goes along. */
function taken({ acceleration, mass }: { acceleration: Vector; mass: Scalar }, along: Scalar): Vector {
  const both = mass.add(along);
  return acceleration.mul(select(both.greater(0), along.div(both).negate(), 0));
}

const everywhere = /* @__PURE__ */ defineLaw({
  ...about,
  parameters: { density, coefficient },
  acceleration: (body, { density: rho, coefficient: c }) => taken(body, c.mul(rho).mul(body.hull.volume)),
});

const withSurface = /* @__PURE__ */ defineLaw({
  ...about,
  parameters: { density, up: POOL.up, level: POOL.level, coefficient },
  acceleration(body, pool) {
    const displaced = body.hull.volume.mul(immersion(body, pool).share);
    return taken(body, pool.coefficient.mul(pool.density).mul(displaced));
  },
});

/**
 * @param coefficient C
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function addedMass(pool: FluidVolume, coefficient = 0.5): Force {
  const { fluid, level } = fluidVolumeValues(pool, 'addedMass');
  const given = {
    density: fluid.density,
    coefficient: checkNumber(coefficient, 'addedMass.coefficient', { min: 0, max: 100 }),
  };
  return level === undefined ? everywhere(given) : withSurface({ ...given, up: fluid.up, level });
}
