import { warnAboutDuration } from '#warnings';
import { assertIdle, assertUsable } from '../ecs/guards.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { checkKeys, checkNumber, mustBe } from '../errors/validate.ts';
import { MAX_DT, MIN_DT, step } from './step.ts';
import type { PhysicsWorld } from './types.ts';

/** Options of a runner. */
export interface RunnerOptions {
  /** Length of every step, s; default 1/60. */
  readonly dt?: number;
  /** Maximum simulated time per call of `advance`, s; default 0.25. Time beyond is dropped and counted. */
  readonly maxFrame?: number;
  /**
   * Called after every step, also one whose user code threw. The events of rigid bodies belong to the last step, and a frame may have none or several: read
   * them here. Default none.
   */
  readonly afterStep?: (world: PhysicsWorld) => void;
}

/** Maximum steps per frame. More would freeze the program, for example when dt is given in microseconds. */
const MAX_STEPS = 1e6;

/** Indices of the accumulated time, of the dropped time and of the length of the last frame, s. */
const [ACCUMULATED, DROPPED, LAST_FRAME] = [0, 1, 2];

const NOT_NEGATIVE = { min: 0 };

/** Converts frame times into steps of fixed length. */
export interface Runner {
  readonly dt: number;
  /** Position of the present frame between the last step and the next, 0 to 1, for interpolation by renderers. */
  readonly alpha: number;
  /** Real time that was not simulated because a frame was too long, s. */
  readonly droppedTime: number;
  /**
   * Runs the steps that fit into `elapsed` seconds of real time; a part of them, as `0.2 * elapsed`, is slow motion. If user code throws in a step, the remaining steps of
   * this frame run at the next call.
   * @returns the number of steps
   * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE for an invalid or negative time; E_REENTRANT inside a step or
   *   `afterStep`; and whatever `step` throws
   */
  advance(elapsed: number): number;
}

/**
 * Creates a fixed-step runner: equal frame times give equal steps, and any frame times give the same trajectory.
 * Source: Fiedler, "Fix Your Timestep!" (2004). `alpha` and the columns `world.previous` serve to interpolate between
 * steps.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN, E_DESTROYED
 */
export function createRunner(world: PhysicsWorld, options: RunnerOptions = {}): Runner {
  assertUsable(world);
  const { dt, maxFrame, afterStep } = checkOptions(options);
  // The times are in a typed array, because a captured variable would allocate a heap number per frame.
  const times = new Float64Array(3);
  let isAdvancing = false;
  warnAboutDuration(world, dt, 'createRunner: dt');
  return {
    dt,
    get alpha() {
      return Math.min(1, times[ACCUMULATED] / dt);
    },
    get droppedTime() {
      return times[DROPPED];
    },
    advance(elapsed) {
      assertIdle(world, 'advance');
      if (isAdvancing) {
        throw new PhysicsError('E_REENTRANT', 'advance must not be called inside afterStep.', {
          hint: 'Call `step(world, dt)` there, or advance after this call.',
        });
      }
      checkNumber(elapsed, 'elapsed', NOT_NEGATIVE);
      // A single long frame means that the page was hidden; two in a row suggest times in milliseconds.
      if (times[LAST_FRAME] > 1 && dt < 1) warnAboutDuration(world, elapsed, 'advance');
      times[LAST_FRAME] = elapsed;
      const frame = Math.min(elapsed, maxFrame);
      const available = times[ACCUMULATED] + frame;
      // Steps that threw may leave time behind; a world that throws at every step must not accumulate it.
      times[ACCUMULATED] = Math.min(available, maxFrame + dt);
      times[DROPPED] += elapsed - frame + (available - times[ACCUMULATED]);
      let steps = 0;
      // A sum of frame times such as 1/30 + 1/30 may be below 4/60 by rounding, which must not lose a step.
      const threshold = dt * (1 - 1e-9);
      isAdvancing = true;
      try {
        while (times[ACCUMULATED] >= threshold && world.state === 'idle') {
          times[ACCUMULATED] = Math.max(0, times[ACCUMULATED] - dt);
          stepAndTell(world, dt, afterStep);
          steps++;
        }
      } finally {
        isAdvancing = false;
      }
      return steps;
    },
  };
}

/** A step whose user code threw is complete: `afterStep` hears of it before the exceptions go on. */
function stepAndTell(world: PhysicsWorld, dt: number, afterStep: RunnerOptions['afterStep']): void {
  const { tick } = world;
  try {
    step(world, dt);
  } catch (error) {
    if (world.tick !== tick && world.state === 'idle') tellOf(error, world, afterStep);
    throw error;
  }
  afterStep?.(world);
}

/** @throws AggregateError of the exceptions of the step and of `afterStep`, if that throws */
function tellOf(error: unknown, world: PhysicsWorld, afterStep: RunnerOptions['afterStep']): void {
  try {
    afterStep?.(world);
  } catch (further) {
    const errors = error instanceof AggregateError ? error.errors : [error];
    throw new AggregateError([...errors, further], `${String(error)}; and in afterStep: ${String(further)}`);
  }
}

function checkOptions(options: RunnerOptions) {
  checkKeys(options, 'createRunner', ['dt', 'maxFrame', 'afterStep']);
  const { afterStep } = options;
  if (afterStep !== undefined && typeof afterStep !== 'function') throw mustBe('a function', afterStep, 'afterStep');
  const dt = checkNumber(options.dt ?? 1 / 60, 'dt', { min: MIN_DT, max: MAX_DT });
  const maxFrame = checkNumber(options.maxFrame ?? Math.max(0.25, dt), 'maxFrame', { min: dt });
  const hint = `A frame can have at most ${MAX_STEPS} steps: lower \`maxFrame\`, or raise \`dt\`.`;
  checkNumber(dt, 'dt', { min: maxFrame / MAX_STEPS }, undefined, hint);
  return { dt, maxFrame, afterStep };
}
