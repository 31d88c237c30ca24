// Added mass: an accelerating body also accelerates surrounding fluid, so the same force accelerates it less.
//
//   (m + A) v' = F - (∇A·w) w + ½ w² ∇A        A = C ρ V f
//
//   F  force of all laws listed before this one, N    C  coefficient: ½ for a sphere, 1 for a cylinder across the flow
//   ρ V f  mass of the displaced fluid, kg    w  velocity relative to the fluid, m/s
//
// List it last. Without it a bubble lighter than water would rise at hundreds of g; with C = ½ at no more than 2 g.
// The terms in ∇A act at the surface, where the immersed fraction f changes: they are those of Lagrange's equations
// for the kinetic energy ½ m v² + ½ A w². The part of the fluid, ½ A w², is not in `energy(world)`; the sum is kept as
// a body enters and leaves. No energy goes into spray and waves, and what moves along the surface is drawn in by ½ w² ∇A.
//
// In waves the fluid has an acceleration u̇ of its own, with which what it surrounds has the force A u̇ as well (Morison).
//
// It changes accelerations by forces of laws. Contacts, joints and walls know the mass m alone: of the weight of a
// wet stone the ground then carries the part m/(m + A), and a float lifts as much less of what hangs from it. For such
// bodies, wholly immersed, leave it out: give them `mass: m + A` and `gravityScale: m / (m + A)`, which is exact.
//
// Lamb, Hydrodynamics, sections 92 and 136; valid for inviscid flow far from walls. In single precision the small
// remaining acceleration has the rounding error of the whole: 3·10⁻⁵ for a bubble of air in water. Cost: about 20
// operations and two divisions per body; with a surface 45 and three.
import { Collider } from '../components/collider.ts';
import { Hull } from '../components/hull.ts';
import { defineLaw } from '../dynamics/define-law.ts';
import { checkNumber } from '../errors/validate.ts';
import { type Scalar, select, type Vector } from '../laws/expression.ts';
import { scalar, vector } from '../laws/parameter.ts';
import type { Force } from '../world/types.ts';
import {
  FLUID_VOLUME,
  type FluidVolume,
  fluidVolumeValues,
  type Immersion,
  immersion,
  immersionAt,
} from './support/fluid-volume.ts';
import { WAVES, waveAt } from './support/waves.ts';

const about = {
  name: 'added mass',
  formula: "(m + A) v' = F - (∇A·w) w + ½ w² ∇A, A = C ρ V f",
  source: 'Lamb, Hydrodynamics, sections 92 and 136.',
  reads: { hull: Hull, collider: Collider },
};

const { density } = FLUID_VOLUME;
const coefficient = /* @__PURE__ */ scalar('');

/** Returns the change of the acceleration, a m/(m + A) - a, for the added mass A, kg. */
function accelerationChange({ acceleration, mass }: { acceleration: Vector; mass: Scalar }, addedMass: Scalar): Vector {
  return acceleration.mul(partOf(addedMass, mass.add(addedMass)).negate());
}

/** Of what has neither mass nor volume there are no parts. */
function partOf(value: Scalar, total: Scalar): Scalar {
  return select(total.greater(0), value.div(total), 0);
}

const unbounded = /* @__PURE__ */ defineLaw({
  ...about,
  parameters: { density, coefficient },
  acceleration: (body, { density: rho, coefficient: c }) => accelerationChange(body, c.mul(rho).mul(body.hull.volume)),
});

const SURFACE = /* @__PURE__ */ {
  density,
  up: FLUID_VOLUME.up,
  level: FLUID_VOLUME.level,
  flow: vector('m/s'),
  coefficient,
};

type Body = Parameters<typeof accelerationChange>[0] & { readonly hull: { readonly volume: Scalar } };

/** The added mass, kg, and the acceleration by its gradient where the body moves at w relative to the fluid, m/s². */
function ofSurface(
  body: Body,
  fluid: { readonly density: Scalar; readonly coefficient: Scalar },
  { immersedFraction, growth }: Immersion,
  normal: Vector,
  w: Vector,
): { readonly added: Scalar; readonly acceleration: Vector } {
  const whole = fluid.coefficient.mul(fluid.density).mul(body.hull.volume);
  const added = whole.mul(immersedFraction);
  // The gradient of the added mass is against the normal, because it grows with depth.
  const slope = partOf(whole.mul(growth), body.mass.add(added));
  const change = w.mul(w.dot(normal)).sub(normal.mul(w.lengthSquared().mul(0.5)));
  return { added, acceleration: change.mul(slope) };
}

const withSurface = /* @__PURE__ */ defineLaw({
  ...about,
  parameters: SURFACE,
  acceleration(body, fluid) {
    const w = body.velocity.sub(fluid.flow);
    const { added, acceleration } = ofSurface(body, fluid, immersion(body, fluid), fluid.up, w);
    return accelerationChange(body, added).add(acceleration);
  },
});

const withWaves = /* @__PURE__ */ defineLaw({
  ...about,
  parameters: { ...SURFACE, ...WAVES },
  acceleration(body, fluid) {
    const wave = waveAt(body.position, fluid);
    const w = body.velocity.sub(fluid.flow).sub(wave.velocity);
    const { added, acceleration } = ofSurface(body, fluid, immersionAt(wave.depth, body), wave.normal, w);
    const ofFluid = wave.acceleration.mul(partOf(added, body.mass.add(added)));
    return accelerationChange(body, added).add(acceleration).add(ofFluid);
  },
});

/**
 * The inertia of surrounding fluid, of all forces listed before. Contacts, joints and walls do not feel it: bodies that they
 * press or hold take `mass: m + A` and `gravityScale: m / (m + A)` instead.
 * @param coefficient C; default 0.5, that of a sphere
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function addedMass(fluidVolume: FluidVolume, coefficient = 0.5): Force {
  const { fluid, level, flow, waves } = fluidVolumeValues(fluidVolume, 'addedMass');
  const given = {
    density: fluid.density,
    coefficient: checkNumber(coefficient, 'addedMass.coefficient', { min: 0, max: 100 }),
  };
  if (level === undefined) return unbounded(given);
  const surface = { ...given, up: fluid.up, level, flow };
  return waves === undefined ? withSurface(surface) : withWaves({ ...surface, ...waves });
}
