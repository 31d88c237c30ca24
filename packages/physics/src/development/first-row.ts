import { bitInWord, isInFirstWord } from '../components/membership.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** The first row that has what is asked for, 0 if there is none. */
export function firstRow({ lastId }: PhysicsWorld, has: (id: number) => boolean): number {
  for (let id = 1; id <= lastId; id++) if (has(id)) return id;
  return 0;
}

/** Whether a body moves by its velocity, whatever its mass. */
export function isKinematic({ internal }: PhysicsWorld, id: number): boolean {
  const words = isInFirstWord('Kinematic') ? internal.members : internal.moreMembers;
  return (words[id] & bitInWord('Kinematic')) !== 0;
}
