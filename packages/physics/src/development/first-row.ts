import type { ComponentName } from '../components/all.ts';
import { bitInWord, isInFirstWord } from '../components/membership.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** The first row that has what is asked for, 0 if there is none. */
export function firstRow({ lastId }: PhysicsWorld, has: (id: number) => boolean): number {
  for (let id = 1; id <= lastId; id++) if (has(id)) return id;
  return 0;
}

/** Whether an entity has a component. */
export function has({ internal: { members, moreMembers } }: PhysicsWorld, id: number, name: ComponentName): boolean {
  return ((isInFirstWord(name) ? members : moreMembers)[id] & bitInWord(name)) !== 0;
}

/** Whether a body moves by its velocity, whatever its mass. */
export function isKinematic(world: PhysicsWorld, id: number): boolean {
  return has(world, id, 'Kinematic');
}
