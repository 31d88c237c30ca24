// Drag of a medium at rest or moving with the wind w.
//
//   linear     F = -c (v - w)            slow, viscous: Re < 1     c, kg/s: 6 π η r for a sphere (Stokes 1851)
//   quadratic  F = -k |v - w| (v - w)    fast: Re > 1000           k, kg/m: ρ C_d A / 2 (Rayleigh)
//
// The coefficients are the columns LinearDrag and QuadraticDrag; zero, or an absent component, means no drag. Cost:
// linear one multiply-add per axis; quadratic one square root more. Explicit integrators need c dt/m < 2 and k v dt/m < 2, or
// drag throws bodies back faster than they came; and k v dt/m < 1 at a terminal speed v, about which they would oscillate. A warning is
// given above c dt/m = 2 and k v dt/m = 1.
import { LinearDrag, QuadraticDrag } from '../components/drag.ts';
import { defineLaw } from '../dynamics/define-law.ts';
import type { Force } from '../world/types.ts';
import { type Wind, windParameter } from './support/wind.ts';

const source = 'Batchelor, An Introduction to Fluid Dynamics, sections 4.9 and 5.11.';

const linear = /* @__PURE__ */ defineLaw({
  name: 'linear drag',
  formula: 'F = -c (v - w)',
  source,
  reads: { c: LinearDrag },
  parameters: {
    /** Velocity w of the medium, m/s, or a function of time, s; default at rest. */
    wind: windParameter,
  },
  force: ({ velocity, c }, { wind }) => velocity.sub(wind).mul(c).negate(),
});

const quadratic = /* @__PURE__ */ defineLaw({
  name: 'quadratic drag',
  formula: 'F = -k |v - w| (v - w)',
  source,
  reads: { k: QuadraticDrag },
  parameters: {
    /** Velocity w of the medium, m/s, or a function of time, s; default at rest. */
    wind: windParameter,
  },
  force: ({ velocity, k }, { wind }) => {
    const u = velocity.sub(wind);
    return u.mul(k.mul(u.length())).negate();
  },
});

/**
 * Drag proportional to the speed.
 * @param wind velocity of the medium, m/s; default at rest
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function linearDrag(wind: Wind = {}): Force {
  return linear({ wind });
}

/**
 * Drag proportional to the square of the speed.
 * @param wind velocity of the medium, m/s; default at rest
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function quadraticDrag(wind: Wind = {}): Force {
  return quadratic({ wind });
}
