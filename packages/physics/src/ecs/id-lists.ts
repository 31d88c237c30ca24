// Lists of entity ids that the library made remember their world: in another world the same ids name other entities.
import { PhysicsError } from '../errors/physics-error.ts';

const worlds = new WeakMap<object, object>();

/** Notes the world of a list of ids, and returns the list. */
export function belongsTo<List extends object>(world: object, ids: List): List {
  worlds.set(ids, world);
  return ids;
}

/** @throws PhysicsError E_TYPE if the list was made for another world; lists of other origin are accepted */
export function assertBelongs(world: object, ids: object, field: string): void {
  const owner = worlds.get(ids);
  if (owner === undefined || owner === world) return;
  throw new PhysicsError('E_TYPE', `${field} are entities of another world.`, {
    field,
    hint: 'Ids belong to one world: pass ids that functions of this world returned.',
  });
}
