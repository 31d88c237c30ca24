// Fields that refer to a body, such as the ends of a spring.
//
// An id is reused when its body is removed, and a reference stored in a column must not pass to the new body. So a
// component that refers to bodies stores the generation beside each id, and readers compare it.
import { hasComponent } from 'bitecs';
import type { ComponentSpec } from '../components/define.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import type { FieldValues, PhysicsWorld } from '../world/types.ts';

/** The parts of a world that validation needs. */
export type WorldView = Pick<PhysicsWorld, 'dimensions' | 'precision' | 'capacity' | 'components' | 'internal'>;

/**
 * Queries bitECS rather than the rows, so that bodies created in the running step count.
 * @throws PhysicsError E_STALE if no body has this id
 */
export function checkBodyId(space: WorldView, name: string, id: number, entity: number | undefined): void {
  const world = space as PhysicsWorld;
  if (id <= space.capacity && hasComponent(world, id, space.components.Position)) return;
  throw new PhysicsError('E_STALE', `${name} refers to body ${id}, which does not exist in this world.`, {
    entity,
    field: name,
    value: id,
    hint: 'Create both bodies first.',
  });
}

/**
 * Refuses a part of a compound body where a body is needed.
 * @throws PhysicsError E_RANGE
 */
export function checkNoPart(space: WorldView, name: string, id: number, entity: number | undefined): void {
  if (!hasComponent(space as PhysicsWorld, id, space.components.Attachment)) return;
  throw new PhysicsError('E_RANGE', `${name} refers to ${id}, which is a part of a compound body.`, {
    entity,
    field: name,
    value: id,
    hint: 'Name the body: bodyOf(world, part) is its id.',
  });
}

/** The error about a column with the id of a body that holds none: a step reads its row. */
export function noId(entity: number, field: string, value: number, capacity: number): PhysicsError {
  return new PhysicsError('E_RANGE', `${field} of entity ${entity} is ${value}, and ids end at ${capacity}.`, {
    entity,
    field,
    value,
    hint: 'Write ids of bodies to its column, or set the component, which checks them.',
  });
}

/** Writes to `values` the generation of every body that `given` refers to. */
export function recordGenerations(
  space: WorldView,
  spec: ComponentSpec,
  given: FieldValues,
  values: FieldValues,
): void {
  for (const field of Object.keys(spec.fields)) {
    const { generationField } = spec.fields[field];
    if (generationField !== undefined && given[field] !== undefined)
      values[generationField] = space.internal.generations[given[field]] ?? 0;
  }
}
