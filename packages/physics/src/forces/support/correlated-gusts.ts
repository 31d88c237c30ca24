// Wind whose gusts come and go: an Ornstein-Uhlenbeck process on each axis, for `linearDrag` and `quadraticDrag`.
//
//   dg = -g dt/τ + σ √(2/τ) dW        mean 0, standard deviation σ, correlation e^(-|s|/τ)
//
//   g  gust, m/s    σ  deviation, m/s    τ  correlation time, s
//
// Drawn at nodes τ/16 apart by the exact update g' = a g + σ √(1 - a²) N, a = e^(-1/16), and joined by straight lines,
// scaled so that the variance over time is σ². The gust is a function of the seed and the time alone: any step, any
// frame rate and any rewinding see the same wind. What is older than 20 τ is forgotten (e^-20 of its size).
// Times may come in any order, but forwards is fastest: after a jump some 500 nodes are drawn anew.
// Uhlenbeck and Ornstein, Phys. Rev. 36, 823 (1930); Gillespie, Phys. Rev. E 54, 2084 (1996).
// Cost: three normal numbers every τ/16.
import { checkKeys, checkNumber, checkVector, type Vector, type VectorInput } from '../../errors/validate.ts';
import { exp } from '../../math/elementary.ts';
import { createRandom, seedWords } from '../../math/random.ts';
import { LENGTHS, SPEEDS } from './bounds.ts';

export interface CorrelatedGustOptions {
  /** Mean wind, m/s; default none. */
  readonly mean?: VectorInput;
  /** Standard deviation σ of each axis, m/s. */
  readonly deviation: VectorInput;
  /** Correlation time τ, s; default 1. */
  readonly time?: number;
  /** Default 1. */
  readonly seed?: number;
}

const NODES_PER_TIME = 16;
/** After this many nodes what was before is forgotten. */
const MEMORY = 20 * NODES_PER_TIME;

/**
 * A wind as a function of time: the same object every time, so copy what you keep.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function correlatedGusts(options: CorrelatedGustOptions): (time: number) => Vector {
  checkKeys(options, 'correlatedGusts', ['mean', 'deviation', 'time', 'seed']);
  const mean = checkVector(options.mean ?? {}, 'correlatedGusts.mean', SPEEDS);
  const deviation = checkVector(options.deviation, 'correlatedGusts.deviation', SPEEDS);
  const interval = checkNumber(options.time ?? 1, 'correlatedGusts.time', LENGTHS) / NODES_PER_TIME;
  const series = nodes(options.seed ?? 1);
  const now = { x: 0, y: 0, z: 0 };
  return (time) => {
    const place = time / interval;
    const node = Math.floor(place);
    const { before, after } = series(node);
    const s = place - node;
    now.x = mean.x + deviation.x * (before.x + (after.x - before.x) * s);
    now.y = mean.y + deviation.y * (before.y + (after.y - before.y) * s);
    now.z = mean.z + deviation.z * (before.z + (after.z - before.z) * s);
    return now;
  };
}

interface Axes {
  x: number;
  y: number;
  z: number;
}

/** The values at a node and at the next. */
function nodes(seed: number): (node: number) => { readonly before: Axes; readonly after: Axes } {
  const keep = exp(-1 / NODES_PER_TIME);
  // A straight line between nodes has less variance than the process: two thirds of it, and a third of the covariance.
  const scale = 1 / Math.sqrt(1 - (1 - keep) / 3);
  const fresh = scale * Math.sqrt(1 - keep * keep);
  const random = createRandom(seed);
  const pair = { before: { x: 0, y: 0, z: 0 }, after: { x: 0, y: 0, z: 0 } };
  let known = Number.NaN;
  const advance = (axes: Axes, node: number) => {
    seedWords(random.state, seed, ((node % 2 ** 32) + 2 ** 32) % 2 ** 32);
    axes.x = keep * axes.x + fresh * random.gaussian();
    axes.y = keep * axes.y + fresh * random.gaussian();
    axes.z = keep * axes.z + fresh * random.gaussian();
  };
  // A node is reached from the start of the block before its own, whichever node was asked for last: a pure function.
  const reach = (axes: Axes, node: number) => {
    axes.x = 0;
    axes.y = 0;
    axes.z = 0;
    for (let n = (Math.floor(node / MEMORY) - 1) * MEMORY; n <= node; n++) advance(axes, n);
  };
  const next = (node: number) => {
    if (node % MEMORY === 0) reach(pair.after, node);
    else advance(Object.assign(pair.after, pair.before), node);
  };
  return (node) => {
    if (node > known && node - known < MEMORY) {
      for (let n = known + 1; n <= node; n++) {
        Object.assign(pair.before, pair.after);
        next(n + 1);
      }
    } else if (node !== known) {
      reach(pair.before, node);
      next(node + 1);
    }
    known = node;
    return pair;
  };
}
