// Drag on the immersed fraction of a body in a fluid with a surface.
//
//   F = -f (k |w| + c) w
//
//   f  immersed fraction of the volume (see `buoyancy`)    w  velocity relative to the fluid, m/s
//   k  QuadraticDrag, kg/m    c  LinearDrag, kg/s
//
// The coefficients are those of the fully immersed body in this fluid. List no other drag with this one, which would
// act in the air as well. The fraction of the volume stands for that of the frontal area. Of a sphere that moves along the
// surface they differ by 0.04 at most; one that enters vertically already meets the fluid with 0.89 of its disc when 0.26 of the volume
// are immersed, so that drag comes late. Polygons count as upright boxes of the half height of the hull. Batchelor, An Introduction to Fluid Dynamics, section 5.11. Cost: a square root and a division per body.
import { Collider } from '../components/collider.ts';
import { LinearDrag, QuadraticDrag } from '../components/drag.ts';
import { Hull } from '../components/hull.ts';
import { defineLaw } from '../dynamics/define-law.ts';
import type { Scalar, Vector } from '../laws/expression.ts';
import { scalar, vector } from '../laws/parameter.ts';
import type { Force } from '../world/types.ts';
import { type FluidVolume, fluidVolumeValues, immersion, immersionAt } from './support/fluid-volume.ts';
import { WAVES, waveAt } from './support/waves.ts';

const about = {
  name: 'immersed drag',
  formula: 'F = -f (k |w| + c) w',
  source: 'Batchelor, An Introduction to Fluid Dynamics, section 5.11.',
};

function drag(w: Vector, k: Scalar, c: Scalar): Vector {
  return w.mul(k.mul(w.length()).add(c)).negate();
}

const unbounded = /* @__PURE__ */ defineLaw({
  ...about,
  reads: { k: QuadraticDrag, c: LinearDrag },
  parameters: { flow: vector('m/s') },
  force: ({ velocity, k, c }, { flow }) => drag(velocity.sub(flow), k, c),
});

const withSurface = /* @__PURE__ */ defineLaw({
  ...about,
  reads: { k: QuadraticDrag, c: LinearDrag, hull: Hull, collider: Collider },
  parameters: { up: vector(''), level: scalar('m'), flow: vector('m/s') },
  force(body, fluid) {
    const { immersedFraction } = immersion(body, fluid);
    return drag(body.velocity.sub(fluid.flow), body.k.mul(immersedFraction), body.c.mul(immersedFraction));
  },
});

const withWaves = /* @__PURE__ */ defineLaw({
  ...about,
  reads: { k: QuadraticDrag, c: LinearDrag, hull: Hull, collider: Collider },
  parameters: { up: vector(''), level: scalar('m'), flow: vector('m/s'), ...WAVES },
  force(body, fluid) {
    const { depth, velocity } = waveAt(body.position, fluid);
    const { immersedFraction } = immersionAt(depth, body);
    const w = body.velocity.sub(fluid.flow).sub(velocity);
    return drag(w, body.k.mul(immersedFraction), body.c.mul(immersedFraction));
  },
});

/**
 * Drag on the immersed fraction f of a body: F = -f (k |w| + c) w, N, with its quadratic drag k, kg/m, and linear drag
 * c, kg/s, and its velocity w through the fluid.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function immersedDrag(fluidVolume: FluidVolume): Force {
  const { fluid, level, flow, waves } = fluidVolumeValues(fluidVolume, 'immersedDrag');
  if (level === undefined) return unbounded({ flow });
  const surface = { up: fluid.up, level, flow };
  return waves === undefined ? withSurface(surface) : withWaves({ ...surface, ...waves });
}
