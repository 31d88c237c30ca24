// Drag of a sphere in a fluid of known density and viscosity, at any speed below the drag crisis.
//
//   F = -½ ρ C_d π r² |w| w        C_d = 24/Re (1 + 0.15 Re^0.687) + 0.42/(1 + 42500 Re^-1.16)        Re = 2 r ρ |w|/η
//
//   ρ  density of the fluid, kg/m³    η  viscosity, Pa s    r  radius of the collider, m    w  relative velocity, m/s
//   Re  Reynolds number               C_d  drag coefficient
//
// Clift and Gauvin, Proc. Chemeca 70, 14 (1970), within 6 % of the standard drag curve for Re < 3·10⁵; its first term
// is Schiller and Naumann (1933), and Re → 0 is Stokes' law 6π η r w. Beyond Re = 3·10⁵ the drag of a smooth sphere
// drops to a third, which is not modelled. Steady drag: no added mass, no history force. In 2D the body is a sphere
// as well. Cost: one square root, one division and two powers per body; powers cost many times the rest, so for many
// bodies in one range of Re use linear or quadratic drag.
import { Collider } from '../components/collider.ts';
import { defineLaw } from '../dynamics/define-law.ts';
import { checkNumber } from '../errors/validate.ts';
import { constant } from '../laws/expression.ts';
import { scalar } from '../laws/parameter.ts';
import { pow } from '../math/elementary.ts';
import type { Force } from '../world/types.ts';
import { POSITIVE } from './support/bounds.ts';
import { type Wind, windParameter } from './support/wind.ts';

/** The fluid of `sphereDrag`. */
export interface FluidOptions {
  /** Density ρ, kg/m³: air 1.2, water 1000. */
  readonly density: number;
  /** Dynamic viscosity η, Pa s: air 1.8e-5, water 1.0e-3. */
  readonly viscosity: number;
  /** Velocity of the fluid, m/s; default at rest. */
  readonly wind?: Wind;
}

const law = /* @__PURE__ */ defineLaw({
  name: 'sphere drag',
  formula: 'F = -½ ρ C_d(Re) π r² |w| w',
  source: 'Clift and Gauvin, Proc. Chemeca 70, 14 (1970).',
  reads: { collider: Collider },
  parameters: { density: scalar('kg/m³', POSITIVE), viscosity: scalar('Pa s', POSITIVE), wind: windParameter },
  // Written so that Re = 0 gives Stokes' law and not 0/0.
  force({ velocity, collider: { radius } }, { density, viscosity, wind }) {
    const w = velocity.sub(wind);
    const speed = w.length();
    const reynolds = radius.mul(speed).mul(density.mul(2).div(viscosity));
    const stokes = radius.mul(viscosity.mul(6 * Math.PI));
    const viscousDrag = stokes.mul(constant(1).add(constant(0.15).mul(reynolds.pow(0.687))));
    const inertialDrag = radius
      .mul(radius)
      .mul(speed)
      .mul(density.mul(0.21 * Math.PI));
    const k = viscousDrag.add(inertialDrag.div(constant(1).add(constant(42500).mul(reynolds.pow(-1.16)))));
    return w.mul(k).negate();
  },
});

/**
 * Drag of spheres in a fluid of known density and viscosity: F = -½ ρ C_d(Re) π r² |w| w, N, from Stokes' law up to Re
 * = 3·10⁵. Clift and Gauvin (1970).
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function sphereDrag(options: FluidOptions): Force {
  return law(options);
}

/** Returns the drag coefficient of a sphere at a Reynolds number, as in `sphereDrag`. @throws PhysicsError */
export function sphereDragCoefficient(reynolds: number): number {
  const re = checkNumber(reynolds, 'sphereDragCoefficient', POSITIVE);
  return (24 / re) * (1 + 0.15 * pow(re, 0.687)) + 0.42 / (1 + 42500 * pow(re, -1.16));
}
