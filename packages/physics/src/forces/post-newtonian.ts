// First post-Newtonian correction to the gravity of a dominant body: it advances Mercury's perihelion by 43″ per
// century.
//
//   F = m μ/(c² r³) [(4 μ/r - v²) r + 4 (r·v) v]
//
//   m  mass, kg    μ = G M of the dominant body, m³/s²    r, v  position and velocity relative to it    c  speed of light, m/s
//
// It is added to Newtonian attraction, on every body with mass except the dominant one, whose recoil, smaller by the
// mass ratio, is neglected. Valid for v²/c² and μ/(c² r) far below 1, and one body far heavier than all others. In
// the harmonic gauge of general relativity: Einstein, Infeld, Hoffmann (1938); Will, Theory and Experiment in
// Gravitational Physics, section 6.2. No potential: the force depends on velocity. Cost: a square root per body.
import { checkKeys, checkNumber } from '../errors/validate.ts';
import type { Force } from '../world/types.ts';
import { GRAVITATIONAL_CONSTANT } from './enclosed-mass-gravity.ts';
import { forceKernels } from './support/force-kernels.ts';

/** The dominant body and the constants, in the units of the world. */
export interface PostNewtonianOptions {
  /** Entity of the dominant body. */
  readonly central: number;
  /** Gravitational constant; default 6.6743e-11 m³/(kg s²). */
  readonly G?: number;
  /** Speed of light; default 299 792 458 m/s. */
  readonly speedOfLight?: number;
}

/**
 * The first post-Newtonian correction to the gravity of a dominant body, which advances perihelia: F = m μ/(c² r³) [(4
 * μ/r - v²) r + 4 (r·v) v], N. List the Newtonian attraction, too.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function postNewtonian(options: PostNewtonianOptions): Force {
  checkKeys(options, 'postNewtonian', ['central', 'G', 'speedOfLight']);
  const central = checkNumber(options.central, 'central', { min: 1, integer: true });
  const G = checkNumber(options.G ?? GRAVITATIONAL_CONSTANT, 'G', { above: 0, max: 1e30 });
  const c = checkNumber(options.speedOfLight ?? 299_792_458, 'speedOfLight', { above: 0, max: 1e30 });
  return {
    name: 'post-Newtonian',
    equation: 'F = m μ/(c² r³) [(4 μ/r - v²) r + 4 (r·v) v]',
    parameters: { G: { unit: 'm³/(kg s²)', value: G }, speedOfLight: { unit: 'm/s', value: c } },
    reads: ['Position', 'Velocity', 'Mass'],
    local: false,
    readsOfOthers: ['Mass'],
    accumulate(world, first, last) {
      const mass = world.components.Mass.value[central];
      if (!(mass > 0 && mass < Infinity)) return;
      const { x, y, z } = world.scratch.at.force;
      const inSpace = world.dimensions === 3 ? z : 0;
      forceKernels(world).postNewtonian(x, y, inSpace, central, G * mass, c, first, last);
    },
  };
}
