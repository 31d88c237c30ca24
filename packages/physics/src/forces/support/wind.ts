// The velocity of a medium, constant or as a function of time.
import { checkKeys, checkNumber, checkVector, type Vector, type VectorInput } from '../../errors/validate.ts';
import { vectorOverTime } from '../../laws/parameter.ts';
import type { VectorOverTime } from '../../laws/time-vector.ts';
import { createRandom } from '../../math/random.ts';
import { VELOCITY_BOUNDS } from './bounds.ts';

/** Velocity of a medium, m/s, steady or over time. */
export type Wind = VectorOverTime;

/** The velocity of a medium as a parameter of a law. */
export const windParameter = vectorOverTime('m/s', { default: {}, ...VELOCITY_BOUNDS });

/** The options of `gusts`. */
export interface GustOptions {
  /** Mean wind, m/s. Default 0. */
  readonly mean?: VectorInput;
  /** Half range of the uniform distribution about the mean, per axis, m/s. */
  readonly spread: VectorInput;
  /** Duration of a gust, s; default 0.1. */
  readonly interval?: number;
  /** Seed; default 1. */
  readonly seed?: number;
}

/**
 * Wind in gusts: a new velocity is drawn every `interval` seconds. It depends only on the time, not on the step.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function gusts(options: GustOptions): (time: number) => Vector {
  checkKeys(options, 'gusts', ['mean', 'spread', 'interval', 'seed']);
  const mean = checkVector(options.mean ?? {}, 'gusts.mean', VELOCITY_BOUNDS);
  const spread = checkVector(options.spread, 'gusts.spread', VELOCITY_BOUNDS);
  const interval = checkNumber(options.interval ?? 0.1, 'gusts.interval', { above: 0 });
  const { seed = 1 } = options;
  createRandom(seed);
  const current = { x: 0, y: 0, z: 0 };
  let drawn = -1;
  return (time) => {
    const gust = Math.floor(time / interval);
    if (gust === drawn) return current;
    drawn = gust;
    const random = createRandom(seed, ((gust % 2 ** 32) + 2 ** 32) % 2 ** 32);
    current.x = mean.x + spread.x * random.uniform(-1, 1);
    current.y = mean.y + spread.y * random.uniform(-1, 1);
    current.z = mean.z + spread.z * random.uniform(-1, 1);
    return current;
  };
}
