import type { PhysicsWorld } from '../world/types.ts';

/** The first row that has what is asked for, 0 if there is none. */
export function firstRow({ lastId }: PhysicsWorld, has: (id: number) => boolean): number {
  for (let id = 1; id <= lastId; id++) if (has(id)) return id;
  return 0;
}
