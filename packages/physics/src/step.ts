import { PhysicsError } from './faults/physics-error';
import { checkNumber } from './faults/validate';
import { runPlan } from './schedule/run-plan';
import { assertUsable } from './store/guards';
import { refreshSpans } from './store/spans';
import type { PhysicsWorld } from './world';

/**
 * Moves the world by `dt` seconds: every phase once, in the order of `PHASES`. Nothing is allocated in steady state.
 *
 * Whatever a user's force, system or handler throws is collected; the step completes, edits made during it take
 * effect, and then one AggregateError carries what was thrown. `step(world, 0)` does nothing.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE (dt, the world unchanged), E_REENTRANT, E_DESTROYED
 * @throws AggregateError of what users' code threw, and of faults where `world.onFault` is 'throw'
 */
export function step(world: PhysicsWorld, dt: number): void {
  assertUsable(world);
  checkNumber(dt, 'dt', { min: 0 });
  if (world.state === 'stepping') {
    throw new PhysicsError('E_REENTRANT', 'step was called inside a step.', {
      hint: 'Let the running step end; from a handler, set a flag and step afterwards.',
    });
  }
  if (dt === 0) return;
  const { internal, versions } = world;
  internal.newFaults = 0;
  refreshSpans(world);
  internal.sweptRows = Math.ceil((world.lastId + 1) / 16) * 16;
  world.state = 'stepping';
  runPlan(world, dt);
  world.time += dt;
  world.tick++;
  versions.pose++;
  world.state = 'idle';
  applyCommands(world);
  rethrow(world);
}

/** Edits made during the step, in the order they were made. One that fails does not stop the others. */
function applyCommands(world: PhysicsWorld): void {
  const { commands, thrown } = world.internal;
  for (let c = 0; c < commands.length; c++) {
    try {
      (commands[c] as () => void)();
    } catch (error) {
      thrown.push(error);
    }
  }
  commands.length = 0;
}

function rethrow(world: PhysicsWorld): void {
  const { thrown, newFaults } = world.internal;
  if (newFaults > 0 && world.onFault === 'throw') {
    for (const { code, entity, field, value, step: tick, phase } of world.faults.faults.slice(-newFaults)) {
      const when = phase === 'begin' ? 'before' : 'in';
      thrown.push(
        new PhysicsError(code, `${field} of body ${entity} was ${value} ${when} step ${tick}.`, {
          entity,
          field,
          value,
        }),
      );
    }
  }
  if (thrown.length === 0) return;
  const errors = thrown.splice(0);
  throw new AggregateError(
    errors,
    `${errors.length} error(s) during step ${world.tick}: ${errors.map(String).join('; ')}`,
  );
}
