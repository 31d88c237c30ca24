// A sub-step of the Dormand-Prince pair over the columns: its stages and its error.
import type { RealColumn } from '../../components/define.ts';
import { allocate } from '../../memory/arena.ts';
import { AXES } from '../../memory/axes.ts';
import { realBytes, realColumn } from '../../memory/columns.ts';
import { EMBEDDED_ERROR_BYTES, EmbeddedErrorNumber, EmbeddedErrorWord as Word } from '../../memory/layouts.gen.ts';
import { allocateRecord, type MemoryRecord } from '../../memory/record.ts';
import { namedResource } from '../../memory/resource.ts';
import type { EvaluateForces, PhysicsWorld, Ranges } from '../../world/types.ts';
import { A, AA, C, E, EA } from './dormand-prince-tableau.ts';
import { forceRounding } from './force-rounding.ts';
import { integratorKernels } from './integrator-kernels.ts';

/** State kept between sub-steps: suggested length, last error, last length and end. */
export const SUGGESTED = 0;
export const RATIO = 1;
export const LENGTH = 2;
export const END = 3;
/** The error of the attempted sub-step, and the floors of its scale. */
export const ERROR = 4;
export const POSITION_FLOOR = 5;
export const VELOCITY_FLOOR = 6;
/** The attempted sub-step: its start within the step, and its length, s. */
export const PASSED = 7;
export const STEP = 8;
/** The growth factor of the next sub-step, and an intermediate power. */
export const GROWTH = 9;
export const POWER = 10;
/** The rounding error of the accelerations, m/s², if it limits the accuracy of this step; else 0. */
export const NOISE = 11;
/** The number of rejected attempts until rounding errors are measured again. */
export const WAIT = 12;
export const TOLERANCE = 13;
const SCALARS = 14;

/** The error contains no term of the start velocity. */
const NO_VELOCITY = [0];

const STAGES = 7;

/** Errors of the accelerations, times the step, add up to this many times their size in the error: Σ |e_i|. */
const AMPLIFICATION = E.reduce((sum, weight) => sum + Math.abs(weight), 0);

/** Nine columns per axis: the position at the start, then the velocity and the seven accelerations. */
const COLUMNS = 2 + STAGES;

export type Stages = ReturnType<typeof makeStages>;
type Axis = 'x' | 'y' | 'z';

export const stagesOf = namedResource('Dormand-Prince stages', makeStages);

function makeStages(world: PhysicsWorld) {
  const { precision, rows } = world;
  const { arena } = world.internal;
  const bytes = realBytes(precision);
  const stride = rows * bytes + 320;
  const at = { x: 0, y: 0, z: 0 };
  for (const axis of AXES[world.dimensions]) at[axis] = allocate(arena, COLUMNS * stride, 'Dormand-Prince');
  const [weights, weightsAt] = realColumn(arena, precision, 2 * (STAGES + 1), 'Dormand-Prince weights');
  const scalars = new Float64Array(arena.memory.buffer, allocate(arena, 8 * SCALARS, 'Dormand-Prince'), SCALARS);
  const Column = precision === 'f32' ? Float32Array : Float64Array;
  const column = (axis: Axis, index: number): RealColumn =>
    new Column(arena.memory.buffer, at[axis] + index * stride, rows);
  const error = writeError(world, stride, [weightsAt + bytes, weightsAt + (1 + STAGES) * bytes]);
  return { at, stride, column, weights, weightsAt, bytes, scalars, error, kernels: integratorKernels(world) };
}

function writeError(world: PhysicsWorld, stride: number, weights: readonly number[]): MemoryRecord {
  const error = allocateRecord(world.internal.arena, EMBEDDED_ERROR_BYTES, 'Dormand-Prince');
  const { x: errorX, y: errorV, z: sizeX } = world.scratch.at.stage1;
  error.words.set([errorX, errorV, sizeX, world.scratch.at.stage2.x], Word.errorX);
  error.words.set(weights, Word.weightsX);
  error.words[Word.stride] = stride;
  error.words[Word.count] = STAGES;
  return error;
}

/** Saves the state as the start of a sub-step; its acceleration comes from the last force evaluation. */
export function begin(world: PhysicsWorld, ranges: Ranges, { at, stride, kernels }: Stages): void {
  const { Position, Velocity, Mass } = world.addresses;
  for (const axis of AXES[world.dimensions]) {
    for (let r = 0; r < ranges.count; r++) {
      const first = ranges.bounds[2 * r];
      const last = ranges.bounds[2 * r + 1];
      world.kernels.copyColumn(at[axis], Position[axis], first, last);
      world.kernels.copyColumn(at[axis] + stride, Velocity[axis], first, last);
      const force = world.scratch.at.force[axis];
      kernels.accelerationAxis(at[axis] + 2 * stride, force, Mass.value, first, last);
    }
  }
}

/** Restores the start of the sub-step. */
export function restore(world: PhysicsWorld, ranges: Ranges, { at, stride }: Stages): void {
  const { Position, Velocity } = world.addresses;
  for (const axis of AXES[world.dimensions]) {
    for (let r = 0; r < ranges.count; r++) {
      const first = ranges.bounds[2 * r];
      const last = ranges.bounds[2 * r + 1];
      world.kernels.copyColumn(Position[axis], at[axis], first, last);
      world.kernels.copyColumn(Velocity[axis], at[axis] + stride, first, last);
    }
  }
}

/**
 * Attempts a sub-step of length STEP from PASSED seconds into the step: afterwards the bodies and forces are those
 * at its end.
 */
export function takeSubStep(world: PhysicsWorld, ranges: Ranges, stages: Stages, evaluateForces: EvaluateForces): void {
  const { scalars } = stages;
  for (let i = 1; i < STAGES; i++) {
    setWeights(stages, C, i, AA[i], A[i]);
    moveToStage(world, ranges, stages, i);
    world.internal.isTrial = true;
    evaluateForces(world, ranges, world.time + scalars[PASSED] + C[i] * scalars[STEP]);
    world.internal.isTrial = false;
    saveAcceleration(world, ranges, stages, i);
  }
}

/**
 * Sets the weights: first those of start velocity and accelerations in a position, then those of accelerations in a
 * velocity.
 */
function setWeights(
  { weights, scalars }: Stages,
  ofVelocity: readonly number[],
  i: number,
  inPosition: readonly number[],
  inVelocity: readonly number[],
): void {
  const h = scalars[STEP];
  weights[0] = h * ofVelocity[i];
  for (let j = 0; j < STAGES; j++) {
    weights[1 + j] = h * h * inPosition[j];
    weights[1 + STAGES + j] = h * inVelocity[j];
  }
}

function moveToStage(world: PhysicsWorld, ranges: Ranges, stages: Stages, i: number): void {
  const { at, stride, kernels, weightsAt, bytes } = stages;
  const { Position, Velocity } = world.addresses;
  const inVelocity = weightsAt + (1 + STAGES) * bytes;
  for (const axis of AXES[world.dimensions]) {
    const x = at[axis];
    const v = x + stride;
    const a = v + stride;
    for (let r = 0; r < ranges.count; r++) {
      const first = ranges.bounds[2 * r];
      const last = ranges.bounds[2 * r + 1];
      kernels.combineAxis(Position[axis], x, v, stride, weightsAt, i + 1, first, last);
      kernels.combineAxis(Velocity[axis], v, a, stride, inVelocity, i, first, last);
    }
  }
}

function saveAcceleration(world: PhysicsWorld, ranges: Ranges, stages: Stages, i: number): void {
  const { at, stride, kernels } = stages;
  for (const axis of AXES[world.dimensions]) {
    const force = world.scratch.at.force[axis];
    for (let r = 0; r < ranges.count; r++) {
      const first = ranges.bounds[2 * r];
      const last = ranges.bounds[2 * r + 1];
      kernels.accelerationAxis(at[axis] + (2 + i) * stride, force, world.addresses.Mass.value, first, last);
    }
  }
}

/**
 * Writes the largest relative error of the attempted sub-step to the scalar ERROR, since a returned number would be
 * garbage.
 */
export function findWorstRatio(world: PhysicsWorld, ranges: Ranges, stages: Stages): void {
  const { at, kernels, scalars, error } = stages;
  const { words, numbers } = error;
  const { Position, Velocity } = world.addresses;
  setWeights(stages, NO_VELOCITY, 0, EA, E);
  const floorV = (AMPLIFICATION * scalars[NOISE] * scalars[STEP]) / scalars[TOLERANCE];
  numbers[EmbeddedErrorNumber.worst] = 0;
  numbers[EmbeddedErrorNumber.floorX] = Math.max(scalars[POSITION_FLOOR], floorV * scalars[STEP]);
  numbers[EmbeddedErrorNumber.floorV] = Math.max(scalars[VELOCITY_FLOOR], floorV);
  for (let r = 0; r < ranges.count; r++) {
    const first = ranges.bounds[2 * r];
    const last = ranges.bounds[2 * r + 1];
    world.kernels.zeroColumn(words[Word.errorX], first, last);
    world.kernels.zeroColumn(words[Word.errorV], first, last);
    world.kernels.zeroColumn(words[Word.sizeX], first, last);
    world.kernels.zeroColumn(words[Word.sizeV], first, last);
    for (const axis of AXES[world.dimensions]) {
      kernels.embeddedErrorAxis(error.at, at[axis], Position[axis], Velocity[axis], first, last);
    }
    kernels.worstError(error.at, first, last);
  }
  scalars[ERROR] = numbers[EmbeddedErrorNumber.worst];
}

/** Writes the rounding error of the accelerations to NOISE; moves the bodies. */
export function measureRounding(world: PhysicsWorld, ranges: Ranges, stages: Stages, evaluate: EvaluateForces): void {
  const { at, stride, scalars } = stages;
  restore(world, ranges, stages);
  const accelerations = { x: at.x + 2 * stride, y: at.y + 2 * stride, z: at.z + 2 * stride };
  scalars[NOISE] = forceRounding(world, ranges, evaluate, world.time + scalars[PASSED], accelerations);
}

/** Returns the start of the last sub-step for a body and axis. */
export function startOf(stages: Stages, axis: Axis, entity: number): { x: number; v: number; a: number[] } {
  const value = (index: number) => stages.column(axis, index)[entity];
  return { x: value(0), v: value(1), a: C.map((_, j) => value(2 + j)) };
}
