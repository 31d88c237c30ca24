// Fields that name a body, as the ends of a spring do.
//
// An id is given again when its body is gone; a name kept in a column must not pass to the heir. So a component that
// names bodies keeps beside each id the generation of the body it meant, and whoever follows the id compares.
import { hasComponent } from 'bitecs';
import type { ComponentSpec } from '../components/define.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import type { FieldValues, PhysicsWorld } from '../world/types.ts';

/** What checking needs to know of the world. */
export type WorldView = Pick<PhysicsWorld, 'dimensions' | 'capacity' | 'components' | 'internal'>;

/**
 * Asks bitECS rather than the rows, so that bodies made in the running step count.
 * @throws PhysicsError E_STALE when no body has this id
 */
export function checkBodyId(space: WorldView, name: string, id: number, entity: number | undefined): void {
  const world = space as PhysicsWorld;
  if (id <= space.capacity && hasComponent(world, id, space.components.Position)) return;
  throw new PhysicsError('E_STALE', `${name} names body ${id}, which is not in this world.`, {
    entity,
    field: name,
    value: id,
    hint: 'Make both bodies first.',
  });
}

/** Writes the life of every body that `given` names to `values`. */
export function recordGenerations(
  space: WorldView,
  spec: ComponentSpec,
  given: FieldValues,
  values: FieldValues,
): void {
  for (const field of Object.keys(spec.fields)) {
    const { life } = spec.fields[field];
    if (life !== undefined && given[field] !== undefined) values[life] = space.internal.generations[given[field]] ?? 0;
  }
}
