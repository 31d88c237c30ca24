import { warnAboutColumns, warnAboutDuration, warnAboutFaults, warnAboutWorld } from '#warnings';
import { prepareForces } from '../dynamics/evaluate-forces.ts';
import { prepareLoops } from '../dynamics/fused-step.ts';
import { validateCoefficients } from '../dynamics/validate-coefficients.ts';
import { holdQuarantined } from '../dynamics/validate-state.ts';
import { applyDeferredEdits } from '../ecs/deferred.ts';
import { assertIdle } from '../ecs/guards.ts';
import { findRows } from '../ecs/ranges.ts';
import { collectThrown } from '../errors/collect-thrown.ts';
import { checkNumber } from '../errors/validate.ts';
import { destroyWorld } from './create-world.ts';
import { hasHandlers, ignoredEvents } from './event-handlers.ts';
import { currentPlan } from './execution-plan.ts';
import { runPhase } from './run-phase.ts';
import { clearStepErrors, throwStepErrors } from './step-errors.ts';
import type { PhysicsWorld, Plan } from './types.ts';

/** Longest step, s: thirty thousand years. The sum of 2⁵³ such steps is still a finite time. */
export const MAX_DT = 1e12;

/** Shortest step, s. Below it the quotients of a step leave the range of f32. */
export const MIN_DT = 1e-20;

const DT_BOUNDS = { min: MIN_DT, max: MAX_DT };

/**
 * Advances the world by `dt` seconds: every phase once, in the order of `PHASES`. In steady state it allocates no
 * object per body, contact or particle.
 *
 * Exceptions of a user's force, system or handler are collected; the step completes, edits made during it take effect,
 * and then one AggregateError carries the exceptions. `step(world, 0)` does nothing.
 * @throws PhysicsError E_TYPE (also for an invalid force, system or integrator), E_NONFINITE, E_RANGE (dt),
 *   E_REENTRANT, E_DESTROYED: the world is unchanged, but joints and springs that had lost a body may be gone
 * @throws AggregateError of the exceptions of user code, and of faults if `world.onFault` is 'throw'
 */
export function step(world: PhysicsWorld, dt: number): void {
  assertIdle(world, 'step');
  if (dt === 0) return;
  checkNumber(dt, 'dt', DT_BOUNDS);
  if (!Number.isFinite(world.time)) checkNumber(world.time, 'world.time');
  const plan = currentPlan(world);
  clearStepErrors(world);
  prepare(world, dt);
  findRows(world);
  validateCoefficients(world);

  world.state = 'stepping';
  runPhase(world, plan, 'input', dt);
  runPhase(world, plan, 'emit', dt);
  runPhase(world, plan, 'begin', dt);
  runPhase(world, plan, 'integrate', dt);
  holdQuarantined(world);
  runPhase(world, plan, 'walls', dt);
  runPhase(world, plan, 'collide', dt);
  runPhase(world, plan, 'finish', dt);
  holdQuarantined(world);
  runPhase(world, plan, 'events', dt);
  world.time += dt;
  world.tick++;
  world.versions.pose++;

  world.state = 'settling';
  applyDeferredEdits(world);
  world.state = 'idle';
  warn(world, plan, dt);
  if (world.internal.ending) destroyWorld(world);
  throwStepErrors(world);
}

/** `onWarning` is user code: what it throws belongs to this step, which ends as it would otherwise. */
function warn(world: PhysicsWorld, plan: Plan, dt: number): void {
  try {
    review(world, plan, dt);
    warnAboutColumns(world);
    warnAboutFaults(world, hasHandlers(world, 'fault'));
  } catch (error) {
    collectThrown(world, error);
  }
}

/** Reviews go through all rows. Where bodies come and go in every step, they look at this many rows a step on average. */
const REVIEWED_ROWS = 1000;

/** Warns about probable mistakes whenever the plan, the handlers or the set of components has changed. */
function review(world: PhysicsWorld, plan: Plan, dt: number): void {
  const { reviewed } = world.internal;
  reviewed.stepsAgo++;
  if (reviewed.plan === plan) {
    if (reviewed.membership === world.versions.membership) return;
    if (REVIEWED_ROWS * reviewed.stepsAgo < world.lastId) return;
  }
  reviewed.stepsAgo = 0;
  reviewed.plan = plan;
  reviewed.membership = world.versions.membership;
  warnAboutDuration(world, dt, 'step');
  warnAboutWorld(world, plan, dt, ignoredEvents(world));
}

/**
 * Runs the preparations before anything moves; an error rejects the step. Forces that consume a column come last, so
 * that a rejected step has consumed nothing.
 */
function prepare(world: PhysicsWorld, dt: number): void {
  world.state = 'preparing';
  try {
    prepareLoops(world);
    world.integrator.prepare?.(world, dt);
    prepareForces(world, dt);
  } catch (error) {
    world.state = 'idle';
    if (world.internal.ending) destroyWorld(world);
    throw error;
  }
}
