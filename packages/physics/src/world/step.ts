import { prepareForces } from '../dynamics/evaluate-forces.ts';
import { prepareLoops } from '../dynamics/fused-step.ts';
import { assertIdle } from '../ecs/guards.ts';
import { refreshSpans } from '../ecs/ranges.ts';
import { collectThrown } from '../errors/collect-thrown.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { checkNumber } from '../errors/validate.ts';
import { destroyWorld } from './create-world.ts';
import { currentPlan } from './execution-plan.ts';
import { runPlan } from './run-plan.ts';
import type { PhysicsWorld, Plan } from './types.ts';

/** Longest step, s: thirty thousand years. The sum of 2⁵³ of them is still a finite time. */
export const MAX_DT = 1e12;

/** Shortest step, s. Below, the quotients of a step leave the range of f32. */
export const MIN_DT = 1e-20;

/**
 * Moves the world by `dt` seconds: every phase once, in the order of `PHASES`. In steady state it makes no object;
 * of numbers, JavaScript boxes a few per tile.
 *
 * Whatever a user's force, system or handler throws is collected; the step completes, edits made during it take
 * effect, and then one AggregateError carries what was thrown. `step(world, 0)` does nothing.
 * @throws PhysicsError E_TYPE (also for a force, system or integrator that is none), E_NONFINITE, E_RANGE (dt),
 *   E_REENTRANT, E_DESTROYED: the world unchanged
 * @throws AggregateError of what users' code threw, and of faults where `world.onFault` is 'throw'
 */
export function step(world: PhysicsWorld, dt: number): void {
  assertIdle(world, 'step');
  if (dt === 0) return;
  const isFit = typeof dt === 'number' && dt >= MIN_DT && dt <= MAX_DT;
  if (!isFit || !Number.isFinite(world.time)) refuse(world, dt);
  const plan = currentPlan(world);
  const { internal } = world;
  if (internal.stepFaults.length > 0) internal.stepFaults.length = 0;
  prepareLoops(world);
  prepareForces(world, dt);
  world.integrator.prepare?.(world, dt);
  refreshSpans(world);
  internal.sweptRows = Math.ceil((world.lastId + 1) / 16) * 16;
  world.state = 'stepping';
  run(world, plan, dt);
  world.time += dt;
  world.tick++;
  world.versions.pose++;
  settle(world);
  if (internal.ending) destroyWorld(world);
  if (internal.thrownCount > 0 || internal.stepFaults.length > 0) rethrow(world);
}

/** Says what is wrong; apart from `step`, which makes no object and boxes no number on its way. */
function refuse(world: PhysicsWorld, dt: number): void {
  checkNumber(dt, 'dt', { min: MIN_DT, max: MAX_DT });
  checkNumber(world.time, 'world.time');
}

/** Whatever happens in it, even to the clock of a profile, the step comes to its end. */
function run(world: PhysicsWorld, plan: Plan, dt: number): void {
  try {
    runPlan(world, plan, dt);
  } catch (error) {
    collectThrown(world, error);
  }
}

/** Edits made during the step, in the order they were made. One that fails does not stop the others. */
function settle(world: PhysicsWorld): void {
  const { commands, leaving } = world.internal;
  world.state = 'settling';
  for (let c = 0; c < commands.length; c++) {
    try {
      commands[c]();
    } catch (error) {
      collectThrown(world, error);
    }
  }
  if (commands.length > 0) {
    commands.length = 0;
    leaving.clear();
  }
  world.state = 'idle';
}

function rethrow(world: PhysicsWorld): void {
  const { internal, tick } = world;
  const errors = internal.thrown.splice(0);
  let count = internal.thrownCount;
  internal.thrownCount = 0;
  if (world.onFault === 'throw') {
    for (const { code, entity, field, value, step, phase, hint } of internal.stepFaults) {
      const problem = `${field} of body ${entity} was ${value} ${phase === 'begin' ? 'before' : 'in'} step ${step}.`;
      errors.push(new PhysicsError(code, problem, { entity, field, value, hint }));
      count++;
    }
  }
  if (count === 0) return;
  const said = errors.slice(0, 3).map(String).join('; ');
  throw new AggregateError(errors, `${count} error(s) during step ${tick}: ${said}${count > 3 ? '; …' : ''}`);
}
