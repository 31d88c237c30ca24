// Instances of classes inside the state that is kept: a snapshot has only a reference to them, so that their fields would
// not go back with the rest.
import { PhysicsError } from '../errors/physics-error.ts';
import { isKept } from './keep-state.ts';

/**
 * Refuses an instance inside kept objects, unless nothing of it can change from outside, or its class keeps its own state: one of
 * its fields was passed to `keepState`.
 * @throws PhysicsError E_TYPE
 */
export function refuseInstance(instance: object, kept: readonly object[]): void {
  if (Object.isFrozen(instance)) return;
  let hasFields = false;
  for (const name in instance) {
    const value = (instance as Record<string, unknown>)[name];
    if (typeof value === 'object' && value !== null && isKept(value)) return;
    hasFields = true;
  }
  if (!hasFields) return;
  const path = pathTo(instance, kept, new Set()) ?? '';
  throw new PhysicsError('E_TYPE', `keepState: object${path} is an instance of a class, whose fields are not saved.`, {
    field: `object${path}`,
    value: instance,
    hint: 'Pass it to keepState as well, use plain objects, or call markImmutable with what is no state.',
  });
}

/** How the instance is reached, as `[0].players[1]`. */
function pathTo(instance: object, at: object, seen: Set<object>): string | undefined {
  seen.add(at);
  for (const [name, value] of entriesOf(at)) {
    if (value === instance) return name;
    if (typeof value !== 'object' || value === null || seen.has(value) || ArrayBuffer.isView(value)) continue;
    const rest = pathTo(instance, value, seen);
    if (rest !== undefined) return name + rest;
  }
  return undefined;
}

function entriesOf(value: object): [string, unknown][] {
  if (value instanceof Set) return [...value].map((member, i) => [`.member ${i}`, member]);
  const entries = value instanceof Map ? [...value] : Object.entries(value);
  const isList = Array.isArray(value) || value instanceof Map;
  return entries.map(([name, item]) => [isList ? `[${String(name)}]` : `.${name}`, item]);
}
