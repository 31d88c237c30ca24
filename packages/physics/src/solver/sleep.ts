// Which rigid bodies sleep. They neither move nor cost much until something touches them, other forces act on them, or
// someone changes their columns.
import { bodyOf } from '../bodies/parts.ts';
import { assertUsable } from '../ecs/guards.ts';
import { RigidTableNumber as Value, RigidTableWord as Word } from '../memory/layouts.gen.ts';
import { namedResource } from '../memory/resource.ts';
import { isSoftStep } from '../world/is-soft-step.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { rigidTable } from './rigid-table.ts';
import { ASLEEP, PART, TO_SLEEP, WAKES } from './row-flags.ts';

function flagsOf(world: PhysicsWorld): Uint32Array {
  if (!isSoftStep(world.integrator)) return new Uint32Array(0);
  return new Uint32Array(world.memory.buffer, rigidTable(world).words[Word.flags], world.lastId + 1);
}

/** Returns whether a body, or that of a part, sleeps; false in worlds without rigid bodies. @throws PhysicsError E_STALE, E_DESTROYED */
export function isAsleep(world: PhysicsWorld, body: number): boolean {
  const row = bodyOf(world, body);
  return (flagsOf(world)[row] & ASLEEP) !== 0;
}

/** Returns the number of bodies that sleep. @throws PhysicsError E_DESTROYED */
export function asleepCount(world: PhysicsWorld): number {
  assertUsable(world);
  let count = 0;
  for (const flags of flagsOf(world)) if ((flags & (ASLEEP | PART)) === ASLEEP) count++;
  return count;
}

/**
 * Wakes a body, and with it all that it touches, in the next step. Not needed after an impulse, a change of position or of
 * forces. @throws PhysicsError E_STALE, E_DESTROYED
 */
export function wake(world: PhysicsWorld, body: number): void {
  if (!isAsleep(world, body)) return;
  flagsOf(world)[bodyOf(world, body)] |= WAKES;
}

/** Bodies that are put to sleep in the next step, and their generations. */
const bodiesToSleep = namedResource('bodies to sleep', () => ({ ids: [] as number[], generations: [] as number[] }));

/**
 * Puts a body to sleep at the end of the next step, with all that it touches or that is joined to it, even if they move: their
 * velocities become zero. They wake as other bodies do. A body with NeverSleep wakes at once; no body sleeps in worlds without
 * rigid bodies, or if `sleepTime` is 0. @throws PhysicsError E_STALE, E_DESTROYED
 */
export function putToSleep(world: PhysicsWorld, body: number): void {
  const row = bodyOf(world, body);
  if (!isSoftStep(world.integrator)) return;
  const { ids, generations } = bodiesToSleep(world);
  ids.push(row);
  generations.push(world.internal.generations[row]);
}

/** Tells the step which bodies are put to sleep. */
export function markBodiesToSleep(world: PhysicsWorld): void {
  const { ids, generations } = bodiesToSleep(world);
  if (ids.length === 0) return;
  const flags = flagsOf(world);
  for (let i = 0; i < ids.length; i++) {
    const isSame = world.internal.generations[ids[i]] === generations[i];
    if (isSame && rigidTable(world).numbers[Value.sleepTime] > 0) flags[ids[i]] |= TO_SLEEP;
  }
  ids.length = 0;
  generations.length = 0;
}
