import { PhysicsError } from '../errors/physics-error.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { identityOf } from './bitecs/context.ts';

/**
 * @throws PhysicsError E_DESTROYED, or E_TYPE if the argument is not a world
 */
export function assertUsable(world: PhysicsWorld): void {
  if (world?.internal?.arena === undefined) {
    throw new PhysicsError('E_TYPE', 'the first argument must be a world made by createPhysicsWorld.');
  }
  if (world.state === 'destroyed') throw new PhysicsError('E_DESTROYED', 'this world was destroyed.');
  if (identityOf(world) !== world.internal.bitecsIdentity) {
    throw new PhysicsError('E_DESTROYED', 'this world was deleted or reset through bitECS.', {
      hint: 'Use destroyWorld(world), and create a new world instead of resetting one.',
    });
  }
}

/**
 * `assertUsable` for a preset, which a world calls: in `preset: standard()` there is none yet.
 * @throws PhysicsError E_DESTROYED, or E_TYPE if the argument is not a world
 */
export function assertPresetWorld(world: PhysicsWorld, preset: string): void {
  if (world === undefined) {
    throw new PhysicsError('E_TYPE', `the preset ${preset} was called without a world.`, {
      field: 'preset',
      hint: `Pass it, do not call it: createPhysicsWorld({ preset: ${preset} }).`,
    });
  }
  assertUsable(world);
}

/** Applies an edit now or, during a step, at the end of the step, so that rows do not change while systems run. */
export function whenIdle({ state, internal }: PhysicsWorld, edit: () => void): void {
  if (state === 'stepping') internal.edits.deferred.push(edit);
  else edit();
}

/**
 * Rejects a world whose rows must not change now; unlike most edits, `what` is not deferred to the end of the step.
 * @param hint what to do instead
 * @throws PhysicsError E_REENTRANT
 */
export function assertOutsideStep({ state }: PhysicsWorld, what: string, hint: string): void {
  if (state === 'stepping') throw new PhysicsError('E_REENTRANT', `${what} cannot run inside a step.`, { hint });
}

/**
 * Rejects a destroyed world and a world that is in a step.
 * @throws PhysicsError E_REENTRANT, E_DESTROYED, E_TYPE
 */
export function assertIdle(world: PhysicsWorld, what: string): void {
  assertUsable(world);
  if (world.state === 'idle') return;
  throw new PhysicsError('E_REENTRANT', `${what} must not be called inside a step.`, {
    hint: 'Call it after the step; a handler can set a flag for this.',
  });
}
