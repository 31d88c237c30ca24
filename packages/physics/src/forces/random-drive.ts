// White noise: a random force, independent for every body with mass, whose effect does not depend on the step.
//
//   F = √(S/dt) N(0, 1), drawn anew each step:   ⟨F(t) F(t')⟩ = S δ(t - t')
//
//   S  spectral density (two-sided), N² s, for each axis    dt  step, s
//
// A force drawn with a fixed size each step does less the shorter the step; scaled by 1/√dt the impulse over a time T
// has the variance S T whatever dt is. So a free body gains ⟨v²⟩ = S t/m² an axis, a damped oscillator (k, c) keeps
// ⟨x²⟩ = S/(2 k c), and with S = 2 c k_B T and linear drag bodies come to the temperature T (Langevin 1908; the
// fluctuation-dissipation theorem). The number depends on the seed, the step and the body's id alone, so it is the same
// in every evaluation of a step. With white noise every integrator is of first order at best.
// Gillespie, Am. J. Phys. 64, 225 (1996). Cost: some 60 ns a body in the plane, 130 ns in space.
import { checkKeys, checkVector, checkWhole, type VectorInput } from '../faults/validate';
import { NOT_NEGATIVE } from './bounds';
import type { Force } from './force';
import { lawKernels } from './law-kernels';
import { shownVector } from './time-vector';

export interface RandomDriveOptions {
  /** S of each axis, N² s; a number is all axes. */
  readonly spectralDensity: number | VectorInput;
  /** Default the world's. */
  readonly seed?: number;
}

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function randomDrive(options: RandomDriveOptions): Force {
  checkKeys(options, 'randomDrive', ['spectralDensity', 'seed']);
  const given = options.spectralDensity;
  const all = typeof given === 'number' ? { x: given, y: given, z: given } : given;
  const density = checkVector(all, 'randomDrive.spectralDensity', NOT_NEGATIVE);
  const own = options.seed;
  if (own !== undefined) checkWhole(own, 'randomDrive.seed', 0, 2 ** 53 - 1);
  let length = 0;
  return {
    name: 'random drive',
    equation: 'F = √(S/dt) N(0, 1)',
    parameters: shownVector('spectralDensity', 'N² s', density),
    reads: ['Mass'],
    local: true,
    timeless: true,
    prepare(_world, dt) {
      length = dt;
    },
    accumulate(world, first, last) {
      if (length === 0) return;
      const seed = own ?? world.seed;
      // Both halves of the seed, folded into the 32 bits the kernel takes.
      const key = (seed >>> 0) ^ Math.imul(Math.floor(seed / 2 ** 32), 0x9e3779b1);
      const { x, y, z } = world.scratch.at.force;
      const dx = Math.sqrt(density.x / length);
      const dy = Math.sqrt(density.y / length);
      const dz = world.dimensions === 3 ? Math.sqrt(density.z / length) : 0;
      lawKernels(world).noiseForce(x, y, z, dx, dy, dz, key, world.tick, first, last);
    },
  };
}
