// Added mass: an accelerating body also accelerates surrounding fluid, so the same force accelerates it less.
//
//   F' = F m/(m + C ρ V f)        so that  a = F/(m + C ρ V f)
//
//   F  force of all laws listed before this one, N    C  coefficient: ½ for a sphere, 1 for a cylinder across the flow
//   ρ V f  mass of the displaced fluid, kg
//
// List it last. Without it a bubble lighter than water would rise at hundreds of g; with C = ½ at no more than 2 g.
// The kinetic energy of the fluid, ½ C ρ V f v², is not in `energy(world)`. Lamb, Hydrodynamics, section 92; valid
// for inviscid flow far from walls. In single precision the small remaining acceleration has the rounding error of
// the whole: 3·10⁻⁵ for a bubble of air in water. Cost: about 20 operations and two divisions per body.
import { Collider } from '../components/collider.ts';
import { Hull } from '../components/hull.ts';
import { defineLaw } from '../dynamics/define-law.ts';
import { checkNumber } from '../errors/validate.ts';
import { type Scalar, select, type Vector } from '../laws/expression.ts';
import { scalar } from '../laws/parameter.ts';
import type { Force } from '../world/types.ts';
import { FLUID_VOLUME, type FluidVolume, fluidVolumeValues, immersion } from './support/fluid-volume.ts';

const about = {
  name: 'added mass',
  formula: "F' = F m / (m + C ρ V f)",
  source: 'Lamb, Hydrodynamics, section 92.',
  reads: { hull: Hull, collider: Collider },
};

const { density } = FLUID_VOLUME;
const coefficient = /* @__PURE__ */ scalar('');

/** Returns the change of the acceleration, a m/(m + M) - a, for the added mass M, kg. */
function accelerationChange({ acceleration, mass }: { acceleration: Vector; mass: Scalar }, addedMass: Scalar): Vector {
  const total = mass.add(addedMass);
  return acceleration.mul(select(total.greater(0), addedMass.div(total).negate(), 0));
}

const unbounded = /* @__PURE__ */ defineLaw({
  ...about,
  parameters: { density, coefficient },
  acceleration: (body, { density: rho, coefficient: c }) => accelerationChange(body, c.mul(rho).mul(body.hull.volume)),
});

const withSurface = /* @__PURE__ */ defineLaw({
  ...about,
  parameters: { density, up: FLUID_VOLUME.up, level: FLUID_VOLUME.level, coefficient },
  acceleration(body, fluid) {
    const displaced = body.hull.volume.mul(immersion(body, fluid).immersedFraction);
    return accelerationChange(body, fluid.coefficient.mul(fluid.density).mul(displaced));
  },
});

/**
 * @param coefficient C; default 0.5, that of a sphere
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function addedMass(fluidVolume: FluidVolume, coefficient = 0.5): Force {
  const { fluid, level } = fluidVolumeValues(fluidVolume, 'addedMass');
  const given = {
    density: fluid.density,
    coefficient: checkNumber(coefficient, 'addedMass.coefficient', { min: 0, max: 100 }),
  };
  return level === undefined ? unbounded(given) : withSurface({ ...given, up: fluid.up, level });
}
