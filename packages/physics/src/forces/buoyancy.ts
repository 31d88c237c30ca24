// Buoyancy of a fluid on bodies that are wholly or partly immersed.
//
//   F = -ρ V f g        f: immersed fraction of the volume, from d = depth of the centre / half height, -1 to 1:
//   sphere  f = ½ + ¼ d (3 - d²)        upright box  f = ½ + ½ d
//
//   potential  U = ρ V g R u(d),  sphere u = d/2 + 3d²/8 - d⁴/16 + 3/16,  box u = (1 + d)²/4,  zero out of the fluid
//
//   ρ  density of the fluid, kg/m³    V  volume, m³: Hull.volume    g  gravity, m/s²    R  half height, m
//
// With `waves`, in which the fluid has the acceleration u̇ (support/waves.ts), F = -ρ V f (g - u̇): hulls that are much shorter than the
// waves ride on them, and what is as dense as the fluid goes with it. There is no potential then, because waves do work.
//
// Archimedes, On Floating Bodies, proposition 5. Valid for slow motion: no pressure drag (`immersedDrag`), no fluid that
// the body accelerates (`addedMass`). Without a level the fluid is unbounded and f = 1, as for
// a balloon. For rotating polygons see `polygonBuoyancy`. Cost: about 20 operations and one division per body.
import { Collider } from '../components/collider.ts';
import { Hull } from '../components/hull.ts';
import { defineLaw } from '../dynamics/define-law.ts';
import { type Scalar, select } from '../laws/expression.ts';
import type { Force } from '../world/types.ts';
import {
  FLUID,
  FLUID_VOLUME,
  type FluidVolume,
  fluidVolumeValues,
  type HullSymbols,
  immersion,
  immersionAt,
} from './support/fluid-volume.ts';
import { WAVES, waveAt } from './support/waves.ts';

const about = {
  name: 'buoyancy',
  formula: 'F = -ρ V f g',
  source: 'Archimedes, On Floating Bodies, proposition 5.',
};

/** Volume of a sphere or box, m³; hulls of other shapes are not of this force. */
function volumeOf({ hull }: HullSymbols): Scalar {
  return select(hull.shape.lessOrEqual(1), hull.volume, 0);
}

/** Weight of the fluid in the whole volume, N. */
function weight(body: HullSymbols, { density, gravity }: { density: Scalar; gravity: Scalar }): Scalar {
  return density.mul(gravity).mul(volumeOf(body));
}

const unbounded = /* @__PURE__ */ defineLaw({
  ...about,
  reads: { hull: Hull, collider: Collider },
  parameters: FLUID,
  force: (body, fluid) => fluid.up.mul(weight(body, fluid)),
  potential: (body, fluid) => weight(body, fluid).mul(fluid.up.dot(body.position)).negate(),
});

const withSurface = /* @__PURE__ */ defineLaw({
  ...about,
  reads: { hull: Hull, collider: Collider },
  parameters: FLUID_VOLUME,
  force: (body, fluid) => fluid.up.mul(weight(body, fluid).mul(immersion(body, fluid).immersedFraction)),
  potential(body, fluid) {
    const { depth, half, relative: d } = immersion(body, fluid);
    const ofSphere = d.square().mul(-0.0625).add(0.375).mul(d).add(0.5).mul(d).add(0.1875);
    const ofBox = d.add(1).square().mul(0.25);
    const immersedEnergy = half.mul(select(body.hull.shape.equals(0), ofSphere, ofBox));
    return weight(body, fluid).mul(select(d.less(1), immersedEnergy, depth));
  },
});

const withWaves = /* @__PURE__ */ defineLaw({
  ...about,
  formula: 'F = -ρ V f (g - u̇)',
  reads: { hull: Hull, collider: Collider },
  parameters: { ...FLUID_VOLUME, ...WAVES },
  force(body, fluid) {
    const { depth, acceleration } = waveAt(body.position, fluid);
    const displaced = fluid.density.mul(volumeOf(body)).mul(immersionAt(depth, body).immersedFraction);
    return fluid.up.mul(fluid.gravity).add(acceleration).mul(displaced);
  },
});

/**
 * Buoyancy of a fluid, with or without a surface, on spheres and upright boxes: F = -ρ V f g, N, with the immersed
 * fraction f of the volume V of the `hull`, m³. Archimedes.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function buoyancy(fluidVolume: FluidVolume): Force {
  const { fluid, level, waves } = fluidVolumeValues(fluidVolume, 'buoyancy');
  if (level === undefined) return unbounded(fluid);
  return waves === undefined ? withSurface({ ...fluid, level }) : withWaves({ ...fluid, level, ...waves });
}
