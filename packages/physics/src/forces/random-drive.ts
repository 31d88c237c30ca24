// White noise: a random force, independent for every body with mass, whose effect does not depend on the step.
//
//   F = √(S/dt) N(0, 1), drawn anew each step:   ⟨F(t) F(t')⟩ = S δ(t - t')
//
//   S  spectral density (two-sided), N² s, per axis    dt  step, s
//
// The effect of a random force of fixed size decreases with the step; scaled by 1/√dt, the impulse over a time T has
// the variance S T for any dt. So a free body gains ⟨v²⟩ = S t/m² per axis, a damped oscillator (k, c) has ⟨x²⟩ =
// S/(2 k c), and with S = 2 c k_B T and linear drag bodies reach the temperature T (Langevin 1908; the
// fluctuation-dissipation theorem), if steps are short: with x = c dt/m velocity Verlet brings them to some
// (1 - x²/4) T, and semi-implicit Euler to T/(1 - x/2). The random number depends only on the seed, the step and the
// body's id, so it is the same in every evaluation of a step. Without a seed of its own, each drive of a world has one made of the world's
// seed and its number among such drives, so that their variances add; drives of one seed draw the same numbers. With
// white noise every integrator is of first order at best. Gillespie, Am. J. Phys. 64, 225 (1996). Cost: a logarithm, a
// sine or cosine and a square root per body and axis.
import { defineLaw } from '../dynamics/define-law.ts';
import { checkKeys, checkWhole, type VectorInput } from '../errors/validate.ts';
import { select, vec3 } from '../laws/expression.ts';
import { type Supplied, suppliedScalar, vector } from '../laws/parameter.ts';
import { mix } from '../math/random.ts';
import { cachedWithPlan } from '../world/execution-plan.ts';
import type { Force, PhysicsWorld } from '../world/types.ts';
import { NOT_NEGATIVE } from './support/bounds.ts';

/** Options of `randomDrive`. */
export interface RandomDriveOptions {
  /** Spectral density S per axis, N² s; a number applies to all axes. */
  readonly spectralDensity: number | VectorInput;
  /** Seed; default one made of the world's, different for each drive of the world. */
  readonly seed?: number;
}

/**
 * White noise on every body with mass, drawn anew each step: F = √(S/dt) N(0, 1) on each axis, N, whose effect does
 * not depend on the step. With linear drag it is Brownian motion.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function randomDrive(options: RandomDriveOptions): Force {
  checkKeys(options, 'randomDrive', ['spectralDensity', 'seed']);
  const { spectralDensity: given, seed } = options;
  if (seed !== undefined) checkWhole(seed, 'randomDrive.seed', 0, 2 ** 53 - 1);
  const spectralDensity = typeof given === 'number' ? { x: given, y: given, z: given } : given;
  return driveOf(seed)({ spectralDensity });
}

function driveOf(own: number | undefined) {
  const seed: Supplied = suppliedScalar((world) => (own === undefined ? seedIn(world, seed.supply) : foldSeed(own)));
  if (own === undefined) withoutSeed.add(seed.supply);
  return defineLaw({
    name: 'random drive',
    formula: 'F = √(S/dt) N(0, 1)',
    source: 'Gillespie, Am. J. Phys. 64, 225 (1996).',
    parameters: {
      spectralDensity: vector('N² s', NOT_NEGATIVE),
      seed,
    },
    force({ mass, dt, noise }, { spectralDensity: { x, y, z }, seed }) {
      const [fx, fy, fz] = [x, y, z].map((density, i) => density.div(dt).sqrt().mul(noise(seed, i)));
      // Before the first step dt is 0, and there is no force.
      return select(mass.greater(0).and(dt.greater(0)), vec3(fx, fy, fz), vec3(0, 0, 0));
    },
  });
}

/** What supplies the seeds of drives that have none of their own. */
const withoutSeed = /* @__PURE__ */ new WeakSet<object>();

/** Those of a world, in the order of its forces. */
const drivesOf = /* @__PURE__ */ cachedWithPlan(({ forces }) =>
  forces
    .flatMap(({ sources = [] }) => sources.map(({ write }): object => write))
    .filter((write) => withoutSeed.has(write)),
);

/** The seed of a drive without its own: far from the small numbers that laws pass to `noise`. */
function seedIn(world: PhysicsWorld, supply: object): number {
  const number = drivesOf(world).indexOf(supply);
  return mix(foldSeed(world.seed) + mix(number + 1));
}

/** Folds both halves of a seed into the 32 bits of the noise function. */
function foldSeed(seed: number): number {
  return ((seed >>> 0) ^ Math.imul(Math.floor(seed / 2 ** 32), 0x9e3779b1)) >>> 0;
}
