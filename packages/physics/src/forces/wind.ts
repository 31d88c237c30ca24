// How a medium moves: steadily, or as a function of time.
import { MAX_SPEED } from '../components/velocity';
import { collectThrown } from '../faults/thrown';
import { checkNumber, checkVector, type Vector, type VectorInput } from '../faults/validate';
import { createRandom } from '../math/random';
import type { PhysicsWorld } from '../world';

/**
 * Velocity of a medium, m/s: a vector, or a function of the time in seconds that returns one. The function must give the
 * same vector for the same time, and may return the same object each time, which makes no garbage.
 */
export type Wind = VectorInput | ((time: number) => VectorInput);

const SPEEDS = { min: -MAX_SPEED, max: MAX_SPEED };

/** The wind at a moment. */
export interface WindState {
  at(world: PhysicsWorld, time: number): Vector;
}

/**
 * A steady wind is checked here. One that changes is asked once per moment; when it throws, or returns what is no
 * velocity, the step reports that and the last good wind goes on blowing.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function windState(wind: Wind, caller: string): WindState {
  if (typeof wind !== 'function') {
    const steady = checkVector(wind, caller, SPEEDS);
    return { at: () => steady };
  }
  const now = { x: 0, y: 0, z: 0 };
  let asked = Number.NaN;
  return {
    at(world, time) {
      if (time === asked) return now;
      asked = time;
      try {
        const { x = 0, y = 0, z = 0 } = wind(time);
        checkNumber(x, 'wind.x', SPEEDS);
        checkNumber(y, 'wind.y', SPEEDS);
        checkNumber(z, 'wind.z', SPEEDS);
        now.x = x;
        now.y = y;
        now.z = z;
      } catch (error) {
        collectThrown(world, error);
      }
      return now;
    },
  };
}

/** Turbulence: how it is drawn. */
export interface GustOptions {
  /** Mean wind, m/s. */
  readonly mean?: VectorInput;
  /** Each axis is drawn uniformly within this much of the mean, m/s. */
  readonly spread: VectorInput;
  /** How long a gust lasts, s; default 0.1. */
  readonly hold?: number;
  /** Default 1. */
  readonly seed?: number;
}

/**
 * Wind in gusts: a new velocity is drawn every `hold` seconds. It depends on the time alone, not on the step.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function gusts(options: GustOptions): (time: number) => Vector {
  const mean = checkVector(options.mean ?? {}, 'gusts.mean', SPEEDS);
  const spread = checkVector(options.spread, 'gusts.spread', SPEEDS);
  const hold = checkNumber(options.hold ?? 0.1, 'gusts.hold', { above: 0 });
  const { seed = 1 } = options;
  createRandom(seed);
  const now = { x: 0, y: 0, z: 0 };
  let drawn = -1;
  return (time) => {
    const gust = Math.floor(time / hold);
    if (gust === drawn) return now;
    drawn = gust;
    const random = createRandom(seed, ((gust % 2 ** 32) + 2 ** 32) % 2 ** 32);
    now.x = mean.x + spread.x * random.uniform(-1, 1);
    now.y = mean.y + spread.y * random.uniform(-1, 1);
    now.z = mean.z + spread.z * random.uniform(-1, 1);
    return now;
  };
}
