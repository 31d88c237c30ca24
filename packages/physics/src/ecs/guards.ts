import { PhysicsError } from '../errors/physics-error.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { contextOf } from './bitecs-adapter.ts';

/** @throws PhysicsError E_DESTROYED, or E_TYPE for something that is no world */
export function assertUsable(world: PhysicsWorld): void {
  if (world?.internal === undefined) {
    throw new PhysicsError('E_TYPE', 'the first argument must be a world made by createPhysicsWorld.');
  }
  if (world.state === 'destroyed') throw new PhysicsError('E_DESTROYED', 'this world was destroyed.');
  if (contextOf(world)?.componentMap !== world.internal.componentMap) {
    throw new PhysicsError('E_DESTROYED', 'bitECS was told to delete or reset this world behind its back.', {
      hint: 'Use destroyWorld(world), and make a new world instead of resetting one.',
    });
  }
}

/** Makes an edit now, or, while a step runs, when it ends: nothing changes under its feet. */
export function whenIdle({ state, internal }: PhysicsWorld, edit: () => void): void {
  if (state === 'stepping') internal.deferredEdits.push(edit);
  else edit();
}

/**
 * Also refuses a world in the middle of a step.
 * @throws PhysicsError E_REENTRANT, E_DESTROYED, E_TYPE
 */
export function assertIdle(world: PhysicsWorld, what: string): void {
  assertUsable(world);
  if (world.state === 'idle') return;
  throw new PhysicsError('E_REENTRANT', `${what} was called inside a step.`, {
    hint: 'Let the running step end; from a handler, set a flag and act on it afterwards.',
  });
}
