// The fifteenth-order Gauss-Radau scheme with steps of its own choosing inside the world's: reference accuracy.
//
//   a(h) = a₀ + b₀ h + b₁ h² + … + b₆ h⁷        x(h) = x + v h dt + dt² ∬ a        v(h) = v + dt ∫ a
//
// The seven b follow from the forces at seven Radau nodes, where the bodies are by the polynomial itself: predictor and
// corrector repeat until the last divided difference no longer changes. The nodes make the end of the step exact to
// order 15, for forces that depend on velocity as well. The length: b₆, the last term of the
// series, stays below `tolerance` times the largest acceleration; the error itself is about its square. Rounding is
// carried on (Kahan), so that energy errs by a random walk near 1e-16 √steps. Not symplectic, but more exact than any
// symplectic scheme of these. About 15 to 22 force evaluations a sub-step, of which an orbit takes some 30 to 60.
// For f64; in f32 it works, to seven digits.
//
// Everhart, in: Dynamics of Comets (1985), p. 185; Rein and Spiegel, MNRAS 446, 1424 (2015), sections 2.2 to 2.5.
import { checkKeys, checkNumber } from '../errors/validate.ts';
import { powInPlace } from '../math/elementary.ts';
import type { EvaluateForces, Integrator, PhysicsWorld, Ranges } from '../world/types.ts';
import {
  CHANGE,
  clearGoneBodies,
  EVALUATIONS,
  LAST_TERM,
  LENGTH,
  NEXT,
  NODES,
  PASSED,
  RADAU_COLUMNS,
  type Radau,
  radauOf,
  START,
  STEP,
  WANTED,
} from './support/gauss-radau-table.ts';
import {
  checkEvaluations,
  defaultEvaluations,
  LAST_RESORT,
  reportUnderflow,
  SHORTEST,
  subStep,
} from './support/sub-steps.ts';

/** How exact it is. */
export interface GaussRadauOptions {
  /** Largest last term of the series of the acceleration, in parts of the acceleration; default 1e-9. */
  readonly tolerance?: number;
  /**
   * Evaluations of the forces that a step may take; default 5·10⁶ divided by the number of bodies, at most 62 500. Beyond,
   * the fault E_STEP names the body, and the rest of the step is crossed without control of the error.
   */
  readonly maxEvaluations?: number;
}

/** Iterations of a sub-step; one that needs more is too long. */
const MOST_ITERATIONS = 12;

/** The polynomial has settled when its last term changes by less than this part of the acceleration. */
const SETTLED = { f32: 1e-7, f64: 1e-16 };

/** Changes that no longer shrink are rounding when they are below this. */
const STALLED = { f32: 0.1, f64: 1e-9 };

/** A sub-step that should have been shorter than this part of its length is done again. */
const TOO_LONG = 0.25;

/** A sub-step may be this much longer than the last. */
const GROWTH = 4;

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
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
      clearGoneBodies(world, radauOf(world));
    },
    advance(world, ranges, dt, evaluateForces) {
      cross(world, ranges, dt, evaluateForces, tolerance, maxEvaluations ?? defaultEvaluations(world) / 2);
    },
  };
}

function cross(
  world: PhysicsWorld,
  ranges: Ranges,
  dt: number,
  evaluate: EvaluateForces,
  tolerance: number,
  budget: number,
): void {
  const radau = radauOf(world);
  const { scalars } = radau;
  // Once more as a mere number: variables that are `dt` or a number worked out would be objects.
  const whole = 1 * dt;
  let wanted = scalars[WANTED] > 0 ? scalars[WANTED] : whole;
  let passed = 0;
  let isNew = true;
  scalars[EVALUATIONS] = 0;
  while (passed < dt) {
    const rest = dt - passed;
    if (wanted < SHORTEST * dt || scalars[EVALUATIONS] > budget) {
      reportUnderflow(world, worstRow(ranges, radau), wanted);
      scalars[PASSED] = passed;
      crossBlindly(world, ranges, radau, dt, evaluate);
      return;
    }
    const h = subStep(wanted, rest);
    scalars[PASSED] = passed;
    scalars[STEP] = h;
    if (isNew) begin(world, ranges, radau, evaluate);
    predict(ranges, radau, isNew);
    world.internal.isTrial = true;
    const converged = iterate(world, ranges, radau, evaluate);
    world.internal.isTrial = false;
    scalars[NEXT] = 0;
    if (converged) findNextLength(world, ranges, radau, tolerance);
    const next = scalars[NEXT];
    isNew = next >= TOO_LONG * h;
    if (isNew) {
      end(ranges, radau);
      passed = h === rest ? whole : passed + h;
      // A sub-step cut short by the end of the step says nothing against a longer one.
      wanted = next < GROWTH * h ? next : Math.max(wanted, next);
    } else {
      if (!converged) forget(ranges, radau);
      wanted = converged ? next : h / GROWTH;
    }
  }
  scalars[WANTED] = wanted;
}

function begin(world: PhysicsWorld, ranges: Ranges, { table, kernels, scalars }: Radau, evaluate: EvaluateForces) {
  evaluate(world, ranges, world.time + scalars[PASSED]);
  for (let r = 0; r < ranges.count; r++) kernels.radauBegin(table, ranges.bounds[2 * r], ranges.bounds[2 * r + 1]);
}

/** The polynomial of the last sub-step, or of the last try of this one, carried to the length of this one. */
function predict(ranges: Ranges, { table, kernels, scalars }: Radau, onwards: boolean): void {
  const h = scalars[STEP];
  const ratio = h / scalars[LENGTH];
  if (scalars[LENGTH] > 0) {
    const shift = onwards ? 1 : 0;
    for (let r = 0; r < ranges.count; r++) {
      kernels.radauPredict(table, ratio, shift, ranges.bounds[2 * r], ranges.bounds[2 * r + 1]);
    }
  }
  scalars[LENGTH] = h;
}

function forget(ranges: Ranges, { table, kernels, scalars }: Radau): void {
  for (let r = 0; r < ranges.count; r++) kernels.radauForget(table, ranges.bounds[2 * r], ranges.bounds[2 * r + 1]);
  scalars[LENGTH] = 0;
}

/** Improves the polynomial until it no longer changes; whether it came to that. */
function iterate(world: PhysicsWorld, ranges: Ranges, radau: Radau, evaluate: EvaluateForces): boolean {
  const settled = SETTLED[world.precision];
  let before = Number.POSITIVE_INFINITY;
  for (let i = 0; i < MOST_ITERATIONS; i++) {
    sweepNodes(world, ranges, radau, evaluate);
    const change = radau.scalars[CHANGE];
    if (change <= settled) return true;
    if (!(change < before)) return before < STALLED[world.precision];
    // Each sweep shortens the change by about the same factor: what the next one would bring is known.
    if (i > 0 && change * (change / before) <= settled) return true;
    before = change;
  }
  return false;
}

/** One sweep over the seven nodes. A number that is returned would be garbage: CHANGE has it. */
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
  scalars[CHANGE] = change === 0 ? 0 : change / largest;
}

/** Leaves the length that would have met the tolerance in NEXT. */
function findNextLength(
  world: PhysicsWorld,
  ranges: Ranges,
  { table, kernels, scalars }: Radau,
  tolerance: number,
): void {
  const { bounds, count } = ranges;
  const h = scalars[STEP];
  const wanted = Math.max(tolerance, world.precision === 'f32' ? 0.03 : 0);
  let term = 0;
  let largest = 0;
  for (let r = 0; r < count; r++) {
    term = Math.max(term, kernels.radauLargestOf(table, LAST_TERM, bounds[2 * r], bounds[2 * r + 1]));
    largest = Math.max(largest, kernels.radauLargestOf(table, START, bounds[2 * r], bounds[2 * r + 1]));
  }
  if (term <= largest * wanted * 4 ** -7) {
    scalars[NEXT] = GROWTH * h;
    return;
  }
  scalars[NEXT] = (wanted * largest) / term;
  powInPlace(scalars, NEXT, 1 / 7);
  scalars[NEXT] = Math.min(GROWTH * h, h * scalars[NEXT]);
}

function end(ranges: Ranges, { table, kernels, scalars }: Radau): void {
  const h = scalars[STEP];
  for (let r = 0; r < ranges.count; r++) kernels.radauEnd(table, h, ranges.bounds[2 * r], ranges.bounds[2 * r + 1]);
}

function worstRow(ranges: Ranges, { table, kernels }: Radau): number {
  return kernels.radauWorstRow(table, 0, ranges.bounds[2 * ranges.count - 1]);
}

/** The rest of a step whose error cannot be kept small. */
function crossBlindly(world: PhysicsWorld, ranges: Ranges, radau: Radau, dt: number, evaluate: EvaluateForces): void {
  const { kernels, table, scalars } = radau;
  const passed = scalars[PASSED];
  const h = (dt - passed) / LAST_RESORT;
  for (let r = 0; r < ranges.count; r++) {
    kernels.radauState(table, 0, 0, h, ranges.bounds[2 * r], ranges.bounds[2 * r + 1]);
  }
  for (let i = 0; i < LAST_RESORT; i++) {
    scalars[PASSED] = passed + i * h;
    scalars[STEP] = h;
    forget(ranges, radau);
    begin(world, ranges, radau, evaluate);
    iterate(world, ranges, radau, evaluate);
    end(ranges, radau);
  }
  forget(ranges, radau);
  scalars.fill(0);
}
