// Drag of a sphere in a fluid of known density and viscosity, at any speed below the drag crisis.
//
//   F = -½ ρ C_d π r² |w| w        C_d = 24/Re (1 + 0.15 Re^0.687) + 0.42/(1 + 42500 Re^-1.16)        Re = 2 r ρ |w|/η
//
//   ρ  density of the fluid, kg/m³    η  viscosity, Pa s    r  radius of the collider, m    w  velocity through it, m/s
//   Re  Reynolds number               C_d  drag coefficient
//
// Clift and Gauvin, Proc. Chemeca 70, 14 (1970), within 6 % of the standard drag curve for Re < 3·10⁵; its first term
// is Schiller and Naumann (1933), and Re → 0 is Stokes' law 6π η r w. Beyond Re = 3·10⁵ a smooth sphere's drag drops
// to a third, which is not modelled. Steady drag: no added mass, no history force. For 2D too the body is a sphere.
// Cost: one square root and two powers, some 190 ns a body; for many bodies in one range of Re use linear or quadratic
// drag.
import { checkKeys, checkNumber } from '../faults/validate';
import { pow } from '../math/elementary';
import { POSITIVE } from './bounds';
import type { Force } from './force';
import { lawKernels } from './law-kernels';
import { type Wind, windState } from './wind';

export interface FluidOptions {
  /** Density ρ, kg/m³: air 1.2, water 1000. */
  readonly density: number;
  /** Dynamic viscosity η, Pa s: air 1.8e-5, water 1.0e-3. */
  readonly viscosity: number;
  /** How the fluid moves, m/s; default not. */
  readonly wind?: Wind;
}

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function sphereDrag(options: FluidOptions): Force {
  checkKeys(options, 'sphereDrag', ['density', 'viscosity', 'wind']);
  const density = checkNumber(options.density, 'sphereDrag.density', POSITIVE);
  const viscosity = checkNumber(options.viscosity, 'sphereDrag.viscosity', POSITIVE);
  const medium = windState(options.wind ?? {}, 'sphereDrag.wind');
  return {
    name: 'sphere drag',
    equation: 'F = -½ ρ C_d(Re) π r² |w| w',
    parameters: { density: { unit: 'kg/m³', value: density }, viscosity: { unit: 'Pa s', value: viscosity } },
    reads: ['Velocity', 'Collider'],
    local: true,
    timeless: medium.steady !== undefined,
    accumulate(world, first, last, time) {
      const w = medium.at(world, time);
      const { x, y, z } = world.scratch.at.force;
      const wz = world.dimensions === 3 ? w.z : 0;
      lawKernels(world).sphereDrag(x, y, z, density, viscosity, w.x, w.y, wz, first, last);
    },
  };
}

/** Drag coefficient of a sphere at a Reynolds number: the curve `sphereDrag` follows. @throws PhysicsError */
export function sphereDragCoefficient(reynolds: number): number {
  const re = checkNumber(reynolds, 'sphereDragCoefficient', POSITIVE);
  return (24 / re) * (1 + 0.15 * pow(re, 0.687)) + 0.42 / (1 + 42500 * pow(re, -1.16));
}
