// Wind with correlated gusts: an Ornstein-Uhlenbeck process per axis, for `linearDrag` and `quadraticDrag`.
//
//   dg = -g dt/τ + σ √(2/τ) dW        mean 0, standard deviation σ, correlation e^(-|s|/τ)
//
//   g  gust, m/s    σ  deviation, m/s    τ  correlation time, s
//
// Drawn at nodes τ/16 apart by the exact update g' = a g + σ √(1 - a²) N, a = e^(-1/16), and interpolated linearly,
// scaled so that the variance over time is σ². The gust is a function of the seed and the time only: any step, any
// frame rate and any rewinding yield the same wind. Values older than 20 τ are neglected (e^-20 of their size). Times
// may come in any order, but increasing times are fastest: after a jump about 500 nodes are drawn again. Uhlenbeck
// and Ornstein, Phys. Rev. 36, 823 (1930); Gillespie, Phys. Rev. E 54, 2084 (1996). Cost: three normal random numbers
// every τ/16.
import { checkKeys, checkNumber, checkVector, type Vector, type VectorInput } from '../../errors/validate.ts';
import { exp } from '../../math/elementary.ts';
import { createRandom, seedWords } from '../../math/random.ts';
import { LENGTH_BOUNDS, VELOCITY_BOUNDS } from './bounds.ts';

/** Options of `correlatedGusts`. */
export interface CorrelatedGustOptions {
  /** Mean wind, m/s; default zero. */
  readonly mean?: VectorInput;
  /** Standard deviation σ of each axis, m/s. */
  readonly deviation: VectorInput;
  /** Correlation time τ, s; default 1. */
  readonly time?: number;
  /** Seed; default 1. */
  readonly seed?: number;
}

const NODES_PER_TIME = 16;
/** The number of nodes after which earlier values are neglected. */
const MEMORY = 20 * NODES_PER_TIME;

/**
 * Returns a wind as a function of time. It returns the same object on every call, so copy values to keep.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function correlatedGusts(options: CorrelatedGustOptions): (time: number) => Vector {
  checkKeys(options, 'correlatedGusts', ['mean', 'deviation', 'time', 'seed']);
  const mean = checkVector(options.mean ?? {}, 'correlatedGusts.mean', VELOCITY_BOUNDS);
  const deviation = checkVector(options.deviation, 'correlatedGusts.deviation', VELOCITY_BOUNDS);
  const interval = checkNumber(options.time ?? 1, 'correlatedGusts.time', LENGTH_BOUNDS) / NODES_PER_TIME;
  const series = nodes(options.seed ?? 1);
  const current = { x: 0, y: 0, z: 0 };
  return (time) => {
    const position = time / interval;
    const node = Math.floor(position);
    const { before, after } = series(node);
    const s = position - node;
    current.x = mean.x + deviation.x * (before.x + (after.x - before.x) * s);
    current.y = mean.y + deviation.y * (before.y + (after.y - before.y) * s);
    current.z = mean.z + deviation.z * (before.z + (after.z - before.z) * s);
    return current;
  };
}

interface Axes {
  x: number;
  y: number;
  z: number;
}

/** Returns a function that gives the values at a node and at the next. */
function nodes(seed: number): (node: number) => { readonly before: Axes; readonly after: Axes } {
  const correlation = exp(-1 / NODES_PER_TIME);
  // Linear interpolation reduces the variance to two thirds, plus a third of the covariance of the nodes.
  const scale = 1 / Math.sqrt(1 - (1 - correlation) / 3);
  const innovation = scale * Math.sqrt(1 - correlation * correlation);
  const random = createRandom(seed);
  const pair = { before: { x: 0, y: 0, z: 0 }, after: { x: 0, y: 0, z: 0 } };
  let currentNode = Number.NaN;
  const advance = (axes: Axes, node: number) => {
    seedWords(random.state, seed, ((node % 2 ** 32) + 2 ** 32) % 2 ** 32);
    axes.x = correlation * axes.x + innovation * random.gaussian();
    axes.y = correlation * axes.y + innovation * random.gaussian();
    axes.z = correlation * axes.z + innovation * random.gaussian();
  };
  // Every node is computed from the start of the block before its own, independent of earlier calls: a pure function.
  const computeNode = (axes: Axes, node: number) => {
    axes.x = 0;
    axes.y = 0;
    axes.z = 0;
    for (let n = (Math.floor(node / MEMORY) - 1) * MEMORY; n <= node; n++) advance(axes, n);
  };
  const next = (node: number) => {
    if (node % MEMORY === 0) computeNode(pair.after, node);
    else advance(Object.assign(pair.after, pair.before), node);
  };
  return (node) => {
    if (node > currentNode && node - currentNode < MEMORY) {
      for (let n = currentNode + 1; n <= node; n++) {
        Object.assign(pair.before, pair.after);
        next(n + 1);
      }
    } else if (node !== currentNode) {
      computeNode(pair.before, node);
      next(node + 1);
    }
    currentNode = node;
    return pair;
  };
}
