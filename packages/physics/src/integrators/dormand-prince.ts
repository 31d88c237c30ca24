// Dormand and Prince's embedded Runge-Kutta pair of orders 5 and 4, with adaptive sub-steps within the world's step.
//
//   k_i = f(t + c_i h, y + h Σ a_ij k_j)        y' = y + h Σ b_i k_i        error ≈ h Σ e_i k_i
//
// Fifth order for any smooth force, including forces that depend on velocity and time. Seven stages, the last of
// which is the first of the next sub-step. The length h keeps the error of a sub-step, in position and velocity of
// every body, below `tolerance` times their magnitude (or the floors, near the origin or at rest, or the rounding of
// forces that cancel, which is measured); a
// proportional-integral controller (Gustafsson, ACM Trans. Math. Softw. 17, 533, 1991) chooses it. Not symplectic:
// the energy drifts by about the tolerance per sub-step. If the force is singular or discontinuous, the step is
// completed without error control and an E_STEP that names the body is reported. Sources: dormand-prince-tableau.ts.
import { checkKeys, checkNumber, type Vector } from '../errors/validate.ts';
import { powInPlace } from '../math/elementary.ts';
import { AXES } from '../memory/axes.ts';
import { EmbeddedErrorWord } from '../memory/layouts.gen.ts';
import type { EvaluateForces, Integrator, PhysicsWorld, Ranges } from '../world/types.ts';
import {
  begin,
  END,
  ERROR,
  findWorstRatio,
  GROWTH,
  LENGTH,
  measureRounding,
  NOISE,
  PASSED,
  POSITION_FLOOR,
  POWER,
  RATIO,
  restore,
  STEP,
  type Stages,
  SUGGESTED,
  stagesOf,
  startOf,
  TOLERANCE,
  takeSubStep,
  VELOCITY_FLOOR,
  WAIT,
} from './support/dormand-prince-stages.ts';
import { denseWeights, positionWeightsOf } from './support/dormand-prince-tableau.ts';
import {
  checkEvaluations,
  defaultEvaluations,
  fallbackStepCount,
  MIN_SUB_STEP,
  reportUnderflow,
  subStep,
} from './support/sub-steps.ts';

/** Number of rejected attempts per measurement of rounding errors, unless the last found that they are why. */
const MEASURE_EVERY = 8;

/** Error control. */
export interface DormandPrinceOptions {
  /** Relative error of position and velocity per sub-step, 1e-15 to 1e9; default 1e-9, in f32 at least 1e-6. */
  readonly tolerance?: number;
  /** Minimum magnitude of a position for the relative error, m; default 0. */
  readonly positionFloor?: number;
  /** Minimum magnitude of a velocity for the relative error, m/s; default 0. */
  readonly velocityFloor?: number;
  /**
   * Maximum number of force evaluations per step; default 8·10⁶ divided by the number of bodies, at most 100 000, and
   * fewer if forces sum over pairs of bodies, so that a step takes some 0.2 s at most. If it is exceeded, the fault E_STEP names the body, and the rest of the step runs without error control.
   */
  readonly maxEvaluations?: number;
}

interface Limits {
  readonly tolerance: number;
  readonly positionFloor: number;
  readonly velocityFloor: number;
  readonly maxEvaluations: number | undefined;
}

/**
 * Dormand and Prince's Runge-Kutta pair of orders 5 and 4, which takes sub-steps within each step until their error is
 * below `tolerance`. For forces whose time scale varies, also those that depend on velocity.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function dormandPrince(options: DormandPrinceOptions = {}): Integrator {
  checkKeys(options, 'dormandPrince', ['tolerance', 'positionFloor', 'velocityFloor', 'maxEvaluations']);
  const { tolerance = 1e-9, positionFloor = 0, velocityFloor = 0 } = options;
  const limits = {
    tolerance: checkNumber(tolerance, 'tolerance', { min: 1e-15, max: 1e9 }),
    positionFloor: checkNumber(positionFloor, 'positionFloor', { min: 0 }),
    velocityFloor: checkNumber(velocityFloor, 'velocityFloor', { min: 0 }),
    maxEvaluations: checkEvaluations(options.maxEvaluations),
  };
  return {
    name: 'Dormand-Prince 5(4)',
    order: 5,
    symplectic: false,
    evaluations: 7,
    columns: 27,
    wholeWorld: true,
    isStable: () => true,
    prepare(world) {
      stagesOf(world);
    },
    advance(world, ranges, dt, evaluateForces) {
      advanceInterval(world, ranges, dt, evaluateForces, limits);
    },
  };
}

function advanceInterval(
  world: PhysicsWorld,
  ranges: Ranges,
  dt: number,
  evaluateForces: EvaluateForces,
  limits: Limits,
): void {
  const stages = stagesOf(world);
  const { scalars } = stages;
  const tolerance = Math.max(limits.tolerance, world.precision === 'f32' ? 1e-6 : 0);
  scalars[TOLERANCE] = tolerance;
  scalars[NOISE] = 0;
  scalars[POSITION_FLOOR] = limits.positionFloor;
  scalars[VELOCITY_FLOOR] = limits.velocityFloor;
  let passed = 0;
  // A copy of `dt` that V8 keeps unboxed; variables assigned from `dt` or from results would be heap numbers.
  const stepLength = 1 * dt;
  let suggested = scalars[SUGGESTED] > 0 ? scalars[SUGGESTED] : stepLength;
  evaluateForces(world, ranges, world.time);
  begin(world, ranges, stages);
  const budget = limits.maxEvaluations ?? defaultEvaluations(world, 1);
  for (let evaluations = 1; passed < dt; evaluations += 6) {
    if (suggested < MIN_SUB_STEP * dt || evaluations > budget) {
      reportUnderflow(world, stages.error.words[EmbeddedErrorWord.worstRow], suggested);
      fallbackSteps(world, ranges, passed, dt, evaluateForces, fallbackStepCount(budget, 7));
      return;
    }
    const remaining = dt - passed;
    const h = subStep(suggested, remaining);
    scalars[PASSED] = passed;
    scalars[STEP] = h;
    takeSubStep(world, ranges, stages, evaluateForces);
    findWorstRatio(world, ranges, stages);
    scalars[ERROR] /= tolerance;
    const error = scalars[ERROR];
    if (error <= 1) {
      passed = h === remaining ? stepLength : passed + h;
      findGrowth(scalars);
      const longer = scalars[GROWTH];
      // A sub-step shortened by the end of the step does not limit the next one.
      suggested = longer < 5 ? h * longer : Math.max(suggested, h * longer);
      scalars[RATIO] = Math.max(error, 1e-4);
      scalars[LENGTH] = h;
      scalars[END] = world.time + passed;
      if (passed < dt) begin(world, ranges, stages);
    } else {
      scalars[POWER] = error;
      if (error < Infinity) powInPlace(scalars, POWER, 0.17);
      suggested = error < Infinity ? h / Math.min(5, scalars[POWER] / 0.9) : h / 5;
      if (isNoise(world, ranges, stages, evaluateForces)) suggested = h;
    }
  }
  scalars[SUGGESTED] = suggested;
}

/** After a rejected attempt: returns whether its error is that of rounded forces, which then sets the floors. */
function isNoise(world: PhysicsWorld, ranges: Ranges, stages: Stages, evaluate: EvaluateForces): boolean {
  const { scalars } = stages;
  if (--scalars[WAIT] > 0 || scalars[NOISE] > 0) return false;
  measureRounding(world, ranges, stages, evaluate);
  findWorstRatio(world, ranges, stages);
  const isWithin = scalars[ERROR] <= scalars[TOLERANCE];
  scalars[WAIT] = isWithin ? 0 : MEASURE_EVERY;
  if (!isWithin) scalars[NOISE] = 0;
  return isWithin;
}

/** Computes the growth factor of the next sub-step from ERROR, in units of the tolerance. */
function findGrowth(scalars: Float64Array): void {
  if (scalars[ERROR] === 0) {
    scalars[GROWTH] = 5;
    return;
  }
  scalars[GROWTH] = scalars[RATIO] > 0 ? scalars[RATIO] : 1e-4;
  powInPlace(scalars, GROWTH, 0.04);
  scalars[POWER] = scalars[ERROR];
  powInPlace(scalars, POWER, 0.17);
  scalars[GROWTH] = Math.min(5, Math.max(0.2, (0.9 * scalars[GROWTH]) / scalars[POWER]));
}

/** Completes a step whose error cannot be controlled. */
function fallbackSteps(
  world: PhysicsWorld,
  ranges: Ranges,
  passed: number,
  dt: number,
  evaluate: EvaluateForces,
  count: number,
): void {
  const stages = stagesOf(world);
  const h = (dt - passed) / count;
  restore(world, ranges, stages);
  for (let i = 0; i < count; i++) {
    stages.scalars[PASSED] = passed + i * h;
    stages.scalars[STEP] = h;
    takeSubStep(world, ranges, stages, evaluate);
    begin(world, ranges, stages);
  }
  stages.scalars.fill(0);
}

/** A body's state at a time within the last sub-step, from `denseState`. */
export interface DenseState {
  position: Vector;
  velocity: Vector;
}

/**
 * Returns a body's state at `time` within the last sub-step of `dormandPrince`, to fourth order: for locating events
 * after the step. `denseInterval` returns the valid times.
 * @throws PhysicsError E_RANGE for a time outside
 */
export function denseState(world: PhysicsWorld, entity: number, time: number): DenseState {
  const [start, end] = denseInterval(world);
  checkNumber(time, 'time', { min: start, max: end });
  const stages = stagesOf(world);
  const length = stages.scalars[LENGTH];
  const fraction = length > 0 ? 1 - (end - time) / length : 0;
  const weights = denseWeights(fraction);
  const positionWeights = positionWeightsOf(weights);
  const position = { x: 0, y: 0, z: 0 };
  const velocity = { x: 0, y: 0, z: 0 };
  for (const axis of AXES[world.dimensions]) {
    const { x, v, a } = startOf(stages, axis, entity);
    position[axis] = x + fraction * length * v + length * length * dot(positionWeights, a);
    velocity[axis] = v + length * dot(weights, a);
  }
  return { position, velocity };
}

/**
 * Returns start and end, s, of the last sub-step of `dormandPrince`, the valid times of `denseState`. Both 0 before
 * the first.
 */
export function denseInterval(world: PhysicsWorld): readonly [start: number, end: number] {
  const { scalars } = stagesOf(world);
  return [scalars[END] - scalars[LENGTH], scalars[END]];
}

function dot(a: readonly number[], b: readonly number[]): number {
  return a.reduce((sum, value, i) => sum + value * b[i], 0);
}
