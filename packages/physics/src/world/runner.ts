import { warnAboutDuration } from '#warnings';
import { assertIdle, assertUsable } from '../ecs/guards.ts';
import { checkKeys, checkNumber } from '../errors/validate.ts';
import { MAX_DT, MIN_DT, step } from './step.ts';
import type { PhysicsWorld } from './types.ts';

/** How a runner paces a world. */
export interface RunnerOptions {
  /** Length of every step, s; default 1/60. */
  readonly dt?: number;
  /** Most simulated time of one call of `advance`, s; default 0.25. What is beyond is dropped and counted. */
  readonly maxFrame?: number;
}

/** Steps one frame may take: more would hang the program, as a dt mistaken for microseconds does. */
const MAX_STEPS = 1e6;

/** Time that waits for a step, and time that was not simulated, s. */
const [WAITING, DROPPED, LAST_FRAME] = [0, 1, 2];

const NOT_NEGATIVE = { min: 0 };

/** Turns frame times into steps of one fixed length. */
export interface Runner {
  readonly dt: number;
  /** How far the present frame is from the last step to the next, 0 to 1: what renderers interpolate by. */
  readonly alpha: number;
  /** Real time not simulated because a frame was too long, s. */
  readonly droppedTime: number;
  /**
   * Runs the steps that `elapsed` seconds of real time have room for. If users' code throws in one, the others of this
   * frame follow at the next call.
   * @returns how many
   * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE for a time that is negative or no number; and what `step` throws
   */
  advance(elapsed: number): number;
}

/**
 * A fixed-step runner: the same frame times give the same steps, and any frame times give the same trajectory.
 * After Fiedler, "Fix Your Timestep!" (2004). `alpha` and the columns `world.previous` make motion smooth between steps.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN, E_DESTROYED
 */
export function createRunner(world: PhysicsWorld, options: RunnerOptions = {}): Runner {
  assertUsable(world);
  const { dt, maxFrame } = checkOptions(options);
  // In cells: a variable that a function keeps would be a new number on the heap with every frame.
  const times = new Float64Array(3);
  warnAboutDuration(world, dt, 'createRunner: dt');
  return {
    dt,
    get alpha() {
      return Math.min(1, times[WAITING] / dt);
    },
    get droppedTime() {
      return times[DROPPED];
    },
    advance(elapsed) {
      assertIdle(world, 'advance');
      checkNumber(elapsed, 'elapsed', NOT_NEGATIVE);
      // One long frame is a page that was hidden; two in a row are not.
      if (times[LAST_FRAME] > 1 && dt < 1) warnAboutDuration(world, elapsed, 'advance');
      times[LAST_FRAME] = elapsed;
      const frame = Math.min(elapsed, maxFrame);
      const wanted = times[WAITING] + frame;
      // Steps that threw may have left time behind; a world that throws at every step must not save it up.
      times[WAITING] = Math.min(wanted, maxFrame + dt);
      times[DROPPED] += elapsed - frame + (wanted - times[WAITING]);
      let steps = 0;
      // A sum of frames such as 1/30 + 1/30 may fall short of 4/60 by rounding alone; that must not cost a step.
      const enough = dt * (1 - 1e-9);
      while (times[WAITING] >= enough && world.state === 'idle') {
        times[WAITING] = Math.max(0, times[WAITING] - dt);
        step(world, dt);
        steps++;
      }
      return steps;
    },
  };
}

function checkOptions(options: RunnerOptions): Required<RunnerOptions> {
  checkKeys(options, 'createRunner', ['dt', 'maxFrame']);
  const dt = checkNumber(options.dt ?? 1 / 60, 'dt', { min: MIN_DT, max: MAX_DT });
  const maxFrame = checkNumber(options.maxFrame ?? Math.max(0.25, dt), 'maxFrame', { min: dt });
  const hint = `A frame may take ${MAX_STEPS} steps: lower \`maxFrame\`, or raise \`dt\`.`;
  checkNumber(dt, 'dt', { min: maxFrame / MAX_STEPS }, undefined, hint);
  return { dt, maxFrame };
}
