// Dormand and Prince's embedded Runge-Kutta pair of orders 5 and 4, with steps of its own choosing inside the world's.
//
//   k_i = f(t + c_i h, y + h Σ a_ij k_j)        y' = y + h Σ b_i k_i        error ≈ h Σ e_i k_i
//
// Fifth order for any smooth force, dependent on velocity and time as well. Seven stages, the last of which is the first
// of the next sub-step. The length h keeps the error of a sub-step, of every body and of positions as of velocities,
// below `tolerance` times their size (or the floors, near the origin or at rest); a proportional-integral controller
// (Gustafsson, ACM Trans. Math. Softw. 17, 533, 1991) chooses it. Not symplectic: the energy drifts by about the
// tolerance a sub-step. Where the force is singular or jumps, the step is crossed without error control and the log gets
// an E_STEP that names the body. Sources: dormand-prince-tableau.ts.
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
  PASSED,
  POSITION_FLOOR,
  POWER,
  RATIO,
  restore,
  STEP,
  stagesOf,
  startOf,
  takeSubStep,
  VELOCITY_FLOOR,
  WANTED,
} from './support/dormand-prince-stages.ts';
import { denseWeights, twice } from './support/dormand-prince-tableau.ts';
import {
  checkEvaluations,
  defaultEvaluations,
  LAST_RESORT,
  reportUnderflow,
  SHORTEST,
  subStep,
} from './support/sub-steps.ts';

/** How exact it is. */
export interface DormandPrinceOptions {
  /** Error of a sub-step in parts of the size of a body's position and velocity; default 1e-9, in f32 at least 1e-6. */
  readonly tolerance?: number;
  /** Size below which a position counts as this large, m; default 0. */
  readonly positionFloor?: number;
  /** Size below which a velocity counts as this large, m/s; default 0. */
  readonly velocityFloor?: number;
  /**
   * Evaluations of the forces that a step may take; default 10⁷ divided by the number of bodies, at most 125 000. Beyond,
   * the fault E_STEP names the body, and the rest of the step is crossed without control of the error.
   */
  readonly maxEvaluations?: number;
}

interface Limits {
  readonly tolerance: number;
  readonly positionFloor: number;
  readonly velocityFloor: number;
  readonly maxEvaluations: number | undefined;
}

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
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
      cross(world, ranges, dt, evaluateForces, limits);
    },
  };
}

function cross(world: PhysicsWorld, ranges: Ranges, dt: number, evaluateForces: EvaluateForces, limits: Limits): void {
  const stages = stagesOf(world);
  const { scalars } = stages;
  const tolerance = Math.max(limits.tolerance, world.precision === 'f32' ? 1e-6 : 0);
  scalars[POSITION_FLOOR] = limits.positionFloor;
  scalars[VELOCITY_FLOOR] = limits.velocityFloor;
  let passed = 0;
  // Once more as a mere number: variables that are `dt` or a number worked out would be objects.
  const whole = 1 * dt;
  let wanted = scalars[WANTED] > 0 ? scalars[WANTED] : whole;
  evaluateForces(world, ranges, world.time);
  begin(world, ranges, stages);
  const budget = limits.maxEvaluations ?? defaultEvaluations(world);
  for (let evaluations = 1; passed < dt; evaluations += 6) {
    if (wanted < SHORTEST * dt || evaluations > budget) {
      reportUnderflow(world, stages.error.words[EmbeddedErrorWord.worstRow], wanted);
      crossBlindly(world, ranges, passed, dt, evaluateForces);
      return;
    }
    const rest = dt - passed;
    const h = subStep(wanted, rest);
    scalars[PASSED] = passed;
    scalars[STEP] = h;
    takeSubStep(world, ranges, stages, evaluateForces);
    findWorstRatio(world, ranges, stages);
    scalars[ERROR] /= tolerance;
    const error = scalars[ERROR];
    if (error <= 1) {
      passed = h === rest ? whole : passed + h;
      findGrowth(scalars);
      const longer = scalars[GROWTH];
      // A sub-step cut short by the end of the step says nothing against a longer one.
      wanted = longer < 5 ? h * longer : Math.max(wanted, h * longer);
      scalars[RATIO] = Math.max(error, 1e-4);
      scalars[LENGTH] = h;
      scalars[END] = world.time + passed;
      if (passed < dt) begin(world, ranges, stages);
    } else {
      scalars[POWER] = error;
      if (error < Infinity) powInPlace(scalars, POWER, 0.17);
      wanted = error < Infinity ? h / Math.min(5, scalars[POWER] / 0.9) : h / 5;
    }
  }
  scalars[WANTED] = wanted;
}

/** By what the next sub-step may be longer, after one with ERROR in tolerances: the controller's answer. */
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

/** The rest of a step whose error cannot be kept small. */
function crossBlindly(world: PhysicsWorld, ranges: Ranges, passed: number, dt: number, evaluate: EvaluateForces): void {
  const stages = stagesOf(world);
  const h = (dt - passed) / LAST_RESORT;
  restore(world, ranges, stages);
  for (let i = 0; i < LAST_RESORT; i++) {
    stages.scalars[PASSED] = passed + i * h;
    stages.scalars[STEP] = h;
    takeSubStep(world, ranges, stages, evaluate);
    begin(world, ranges, stages);
  }
  stages.scalars.fill(0);
}

/** A body's state at a moment of the last sub-step, by `denseState`. */
export interface DenseState {
  position: Vector;
  velocity: Vector;
}

/**
 * Where a body was at `time` within the last sub-step of `dormandPrince`, to fourth order: for finding the instant of an
 * event after the step. `denseInterval` says which times there are.
 * @throws PhysicsError E_RANGE for a time outside
 */
export function denseState(world: PhysicsWorld, entity: number, time: number): DenseState {
  const [start, end] = denseInterval(world);
  checkNumber(time, 'time', { min: start, max: end });
  const stages = stagesOf(world);
  const length = stages.scalars[LENGTH];
  const moment = length > 0 ? 1 - (end - time) / length : 0;
  const weights = denseWeights(moment);
  const squares = twice(weights);
  const position = { x: 0, y: 0, z: 0 };
  const velocity = { x: 0, y: 0, z: 0 };
  for (const axis of AXES[world.dimensions]) {
    const { x, v, a } = startOf(stages, axis, entity);
    position[axis] = x + moment * length * v + length * length * dot(squares, a);
    velocity[axis] = v + length * dot(weights, a);
  }
  return { position, velocity };
}

/** Start and end, s, of the last sub-step of `dormandPrince`: what `denseState` can answer. Both 0 before the first. */
export function denseInterval(world: PhysicsWorld): readonly [start: number, end: number] {
  const { scalars } = stagesOf(world);
  return [scalars[END] - scalars[LENGTH], scalars[END]];
}

function dot(a: readonly number[], b: readonly number[]): number {
  return a.reduce((sum, value, i) => sum + value * b[i], 0);
}
