// The Gauss-Radau scheme of order 15 with adaptive sub-steps within the world's step: reference accuracy.
//
//   a(h) = a₀ + b₀ h + b₁ h² + … + b₆ h⁷        x(h) = x + v h dt + dt² ∬ a        v(h) = v + dt ∫ a
//
// The seven b follow from the forces at seven Radau nodes, where the polynomial itself predicts the positions:
// predictor and corrector iterate until the last divided difference converges. The nodes make the end of the step
// exact to order 15, also for forces that depend on velocity. Step control: b₆, the last term of the series, stays
// below `tolerance` times the largest acceleration at the nodes (not at the start, where an oscillator that passes
// its equilibrium has none); the error itself is about its square. Rounding errors are
// compensated (Kahan), so the energy error is a random walk near 1e-16 √steps. Not symplectic, but more accurate than
// every symplectic scheme here. About 15 to 22 force evaluations per sub-step; an orbit takes about 30 to 60
// sub-steps. For f64; in f32 the energy of an orbit is kept to six or seven digits, with an eccentricity of 0.99 to four,
// of 0.999 to three. For smooth forces: a kink, as of a cord that goes slack, costs
// many short sub-steps, and is not noticed at all after the last node. In an equilibrium, as of a hanging mass or at
// terminal speed, the accelerations are rounding errors of forces that cancel, and no sub-step is short enough for a
// tolerance relative to them: those errors are measured, and b₆ need not be smaller. Not for stiff forces: the iteration
// converges only if h times the rate of damping is about 1 or less, so a drag of 10⁴ /s takes all evaluations of a step of
// 0.1 s. The rest of the step is then stable, and of first order (support/gauss-radau-fallback.ts).
//
// Everhart, in: Dynamics of Comets (1985), p. 185; Rein and Spiegel, MNRAS 446, 1424 (2015), sections 2.2 to 2.5.
import { checkKeys, checkNumber } from '../errors/validate.ts';
import { powInPlace } from '../math/elementary.ts';
import type { EvaluateForces, Integrator, PhysicsWorld, Ranges } from '../world/types.ts';
import { forceRounding } from './support/force-rounding.ts';
import { endUnconverged } from './support/gauss-radau-fallback.ts';
import {
  CHANGE,
  clearRemovedBodies,
  EVALUATIONS,
  LARGEST,
  LAST_TERM,
  LENGTH,
  NEXT,
  NODES,
  NOISE,
  PASSED,
  RADAU_COLUMNS,
  type Radau,
  radauOf,
  START_ACCELERATION,
  STEP,
  SUGGESTED,
  WAIT,
} from './support/gauss-radau-table.ts';
import {
  checkEvaluations,
  defaultEvaluations,
  fallbackStepCount,
  MIN_SUB_STEP,
  reportUnderflow,
  subStep,
} from './support/sub-steps.ts';

/** Error control. */
export interface GaussRadauOptions {
  /** Maximum last term of the series, relative to the acceleration, 1e-12 to 1e9; default 1e-9. Below 1e-11 rounding may exceed it, E_STEP. */
  readonly tolerance?: number;
  /**
   * Maximum number of force evaluations per step; default 4·10⁶ divided by the number of bodies, at most 50 000, and
   * fewer if forces sum over pairs of bodies, so that a step takes some 0.2 s at most. If it is exceeded, the fault E_STEP names the body, and the rest of the step runs without error control.
   */
  readonly maxEvaluations?: number;
}

/** Maximum number of iterations; a sub-step that needs more is too long. */
const MAX_ITERATIONS = 12;

/** The polynomial has converged if its last term changes by less than this fraction of the acceleration. */
const CONVERGED = { f32: 1e-7, f64: 1e-16 };

/** Changes that no longer decrease count as rounding below this fraction. */
const ROUNDING = { f32: 0.01, f64: 1e-9 };

/**
 * The least tolerance: in f32, b₆ has rounding errors of up to 7·10⁻⁴ of the acceleration (see AMPLIFICATION), and
 * sub-steps for a b₆ of ten times this one jump over a close encounter.
 */
const MIN_TOLERANCE = { f32: 0.003, f64: 0 };

/**
 * In b₆, the divided difference Σ w_j a(h_j) of the accelerations at the nodes, with w_j = Π_{k≠j} 1/(h_j - h_k),
 * errors of the accelerations add up to this many times their size at most: Σ |w_j|.
 */
const AMPLIFICATION = 11525;

/** Number of shortened sub-steps per measurement of rounding errors, unless the last found that they are why. */
const MEASURE_EVERY = 8;

/** A sub-step is repeated if its optimal length is below this fraction of its length. */
const MIN_RATIO = 0.25;

/** Maximum growth factor from one sub-step to the next. */
const MAX_GROWTH = 4;

/**
 * The Gauss-Radau scheme of order 15 with sub-steps of its own: reference accuracy for orbits, close encounters and
 * tests of other schemes, with forces that are smooth.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function gaussRadau(options: GaussRadauOptions = {}): Integrator {
  checkKeys(options, 'gaussRadau', ['tolerance', 'maxEvaluations']);
  const tolerance = checkNumber(options.tolerance ?? 1e-9, 'tolerance', { min: 1e-12, max: 1e9 });
  const maxEvaluations = checkEvaluations(options.maxEvaluations);
  return {
    name: 'Gauss-Radau 15',
    order: 15,
    symplectic: false,
    evaluations: 22,
    columns: RADAU_COLUMNS,
    wholeWorld: true,
    isStable: () => true,
    prepare(world) {
      clearRemovedBodies(world, radauOf(world));
    },
    advance(world, ranges, dt, evaluateForces) {
      advanceInterval(world, ranges, dt, evaluateForces, tolerance, maxEvaluations ?? defaultEvaluations(world, 2));
    },
  };
}

function advanceInterval(
  world: PhysicsWorld,
  ranges: Ranges,
  dt: number,
  evaluate: EvaluateForces,
  tolerance: number,
  budget: number,
): void {
  const radau = radauOf(world);
  const { scalars } = radau;
  // A copy of `dt` that V8 keeps unboxed; variables assigned from `dt` or from results would be heap numbers.
  const stepLength = 1 * dt;
  let suggested = scalars[SUGGESTED] > 0 ? scalars[SUGGESTED] : stepLength;
  let passed = 0;
  let isNew = true;
  scalars[EVALUATIONS] = 0;
  while (passed < dt) {
    const remaining = dt - passed;
    if (suggested < MIN_SUB_STEP * dt || scalars[EVALUATIONS] > budget) {
      reportUnderflow(world, worstRow(ranges, radau), suggested);
      scalars[PASSED] = passed;
      fallbackSteps(world, ranges, radau, dt, evaluate, fallbackStepCount(budget, 7 * MAX_ITERATIONS));
      return;
    }
    const h = subStep(suggested, remaining);
    scalars[PASSED] = passed;
    scalars[STEP] = h;
    if (isNew) begin(world, ranges, radau, evaluate);
    predict(ranges, radau, isNew);
    const converged = iterate(world, ranges, radau, evaluate);
    scalars[NEXT] = 0;
    if (converged) findNextLength(world, ranges, radau, evaluate, tolerance);
    const next = scalars[NEXT];
    isNew = next >= MIN_RATIO * h;
    if (isNew) {
      end(ranges, radau);
      passed = h === remaining ? stepLength : passed + h;
      // A sub-step shortened by the end of the step does not limit the next one.
      suggested = next < MAX_GROWTH * h ? next : Math.max(suggested, next);
    } else {
      // The next prediction clears what diverged; until then it tells which body is the worst.
      if (!converged) scalars[LENGTH] = 0;
      suggested = converged ? next : h / MAX_GROWTH;
    }
  }
  scalars[SUGGESTED] = suggested;
}

function begin(world: PhysicsWorld, ranges: Ranges, { table, kernels, scalars }: Radau, evaluate: EvaluateForces) {
  evaluate(world, ranges, world.time + scalars[PASSED]);
  for (let r = 0; r < ranges.count; r++) kernels.radauBegin(table, ranges.bounds[2 * r], ranges.bounds[2 * r + 1]);
}

/** Extrapolates the polynomial of the last sub-step, or of the last attempt, to the length of this one. */
function predict(ranges: Ranges, radau: Radau, continues: boolean): void {
  const { table, kernels, scalars } = radau;
  const h = scalars[STEP];
  const ratio = h / scalars[LENGTH];
  if (scalars[LENGTH] === 0) clearPolynomial(ranges, radau);
  else {
    const shift = continues ? 1 : 0;
    for (let r = 0; r < ranges.count; r++) {
      kernels.radauPredict(table, ratio, shift, ranges.bounds[2 * r], ranges.bounds[2 * r + 1]);
    }
  }
  scalars[LENGTH] = h;
}

function clearPolynomial(ranges: Ranges, { table, kernels, scalars }: Radau): void {
  for (let r = 0; r < ranges.count; r++) kernels.radauReset(table, ranges.bounds[2 * r], ranges.bounds[2 * r + 1]);
  scalars[LENGTH] = 0;
}

/** Iterates the polynomial; returns whether it converged. */
function iterate(world: PhysicsWorld, ranges: Ranges, radau: Radau, evaluate: EvaluateForces): boolean {
  const tolerance = CONVERGED[world.precision];
  const { scalars } = radau;
  let previous = Number.POSITIVE_INFINITY;
  scalars[NOISE] = -1;
  for (let i = 0; i < MAX_ITERATIONS; i++) {
    sweepNodes(world, ranges, radau, evaluate);
    const change = scalars[CHANGE];
    if (change <= tolerance) return true;
    if (!(change < previous)) {
      if (previous < ROUNDING[world.precision]) return true;
      measureRounding(world, ranges, radau, evaluate);
      return previous * scalars[LARGEST] <= 2 * scalars[NOISE];
    }
    // Convergence is linear, so the change of the next sweep is predictable.
    if (i > 0 && change * (change / previous) <= tolerance) return true;
    previous = change;
  }
  return false;
}

/** One sweep over the seven nodes. The results are in CHANGE and LARGEST, since a returned number would be garbage. */
function sweepNodes(
  world: PhysicsWorld,
  ranges: Ranges,
  { table, kernels, scalars }: Radau,
  evaluate: EvaluateForces,
): void {
  const { bounds, count } = ranges;
  const h = scalars[STEP];
  let change = 0;
  let largest = 0;
  world.internal.isTrial = true;
  for (let s = 1; s < NODES.length; s++) {
    for (let r = 0; r < count; r++) kernels.radauState(table, s, NODES[s], h, bounds[2 * r], bounds[2 * r + 1]);
    evaluate(world, ranges, world.time + scalars[PASSED] + NODES[s] * h);
    scalars[EVALUATIONS]++;
    change = 0;
    for (let r = 0; r < count; r++) {
      change = Math.max(change, kernels.radauRefine(table, s, bounds[2 * r], bounds[2 * r + 1]));
      largest = Math.max(largest, kernels.radauLargest());
    }
  }
  world.internal.isTrial = false;
  scalars[CHANGE] = change === 0 ? 0 : change / largest;
  scalars[LARGEST] = largest;
}

/** Writes the length that would have met the tolerance to NEXT. */
function findNextLength(
  world: PhysicsWorld,
  ranges: Ranges,
  radau: Radau,
  evaluate: EvaluateForces,
  tolerance: number,
): void {
  const { bounds, count } = ranges;
  const { table, kernels, scalars } = radau;
  const target = Math.max(tolerance, MIN_TOLERANCE[world.precision]) * scalars[LARGEST];
  let term = 0;
  for (let r = 0; r < count; r++) {
    term = Math.max(term, kernels.radauLargestOf(table, LAST_TERM, bounds[2 * r], bounds[2 * r + 1]));
  }
  setNextLength(scalars, target, term);
  if (scalars[NEXT] >= scalars[STEP] || (scalars[NOISE] < 0 && --scalars[WAIT] > 0)) return;
  if (scalars[NOISE] < 0) measureRounding(world, ranges, radau, evaluate);
  const isNoise = term <= scalars[NOISE];
  scalars[WAIT] = isNoise ? 0 : MEASURE_EVERY;
  if (isNoise) setNextLength(scalars, scalars[NOISE], term);
}

/** Writes the rounding error of b₆ to NOISE. */
function measureRounding(world: PhysicsWorld, ranges: Ranges, radau: Radau, evaluate: EvaluateForces): void {
  const { table, kernels, scalars, blocks, stride } = radau;
  for (let r = 0; r < ranges.count; r++) {
    kernels.radauState(table, 0, 0, 0, ranges.bounds[2 * r], ranges.bounds[2 * r + 1]);
  }
  const [x, y, z = 0] = blocks.map((block) => block + START_ACCELERATION * stride);
  const time = world.time + scalars[PASSED];
  scalars[NOISE] = AMPLIFICATION * forceRounding(world, ranges, evaluate, time, { x, y, z });
  scalars[EVALUATIONS]++;
}

/** Sets NEXT to the length for which the last term, now `term`, would be `target`. */
function setNextLength(scalars: Float64Array, target: number, term: number): void {
  const h = scalars[STEP];
  if (term <= target * 4 ** -7) {
    scalars[NEXT] = MAX_GROWTH * h;
    return;
  }
  scalars[NEXT] = target / term;
  powInPlace(scalars, NEXT, 1 / 7);
  scalars[NEXT] = Math.min(MAX_GROWTH * h, h * scalars[NEXT]);
}

function end(ranges: Ranges, { table, kernels, scalars }: Radau): void {
  const h = scalars[STEP];
  for (let r = 0; r < ranges.count; r++) kernels.radauEnd(table, h, ranges.bounds[2 * r], ranges.bounds[2 * r + 1]);
}

function worstRow(ranges: Ranges, { table, kernels }: Radau): number {
  return kernels.radauWorstRow(table, 0, ranges.bounds[2 * ranges.count - 1]);
}

/** Completes a step whose error cannot be controlled. */
function fallbackSteps(
  world: PhysicsWorld,
  ranges: Ranges,
  radau: Radau,
  dt: number,
  evaluate: EvaluateForces,
  count: number,
): void {
  const { kernels, table, scalars } = radau;
  const passed = scalars[PASSED];
  const h = (dt - passed) / count;
  for (let r = 0; r < ranges.count; r++) {
    kernels.radauState(table, 0, 0, h, ranges.bounds[2 * r], ranges.bounds[2 * r + 1]);
  }
  for (let i = 0; i < count; i++) {
    scalars[PASSED] = passed + i * h;
    scalars[STEP] = h;
    clearPolynomial(ranges, radau);
    begin(world, ranges, radau, evaluate);
    if (iterate(world, ranges, radau, evaluate)) end(ranges, radau);
    else endUnconverged(world, ranges, radau, evaluate);
  }
  clearPolynomial(ranges, radau);
  scalars.fill(0);
}
