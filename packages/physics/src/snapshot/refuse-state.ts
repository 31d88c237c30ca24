// What a snapshot would lose of the state that is kept: instances of classes, of which it has only a reference, so that their
// fields would not go back with the rest, and properties that are no fields or elements.
import { PhysicsError } from '../errors/physics-error.ts';
import { isKept } from './keep-state.ts';

/**
 * Refuses an object of the state that is kept, if a snapshot would lose a part of it.
 * @param isCopied whether the snapshot copies its fields or elements
 * @throws PhysicsError E_TYPE
 */
export function refuseLoss(value: object, isCopied: boolean, kept: readonly object[]): void {
  const problem = isCopied ? problemOfCopied(value) : problemOfInstance(value);
  if (problem === undefined) return;
  const place = `object${pathTo(value, kept) ?? ''}`;
  throw new PhysicsError('E_TYPE', `keepState: ${place} ${problem}.`, {
    field: place,
    value,
    hint: isCopied
      ? 'Keep that in a field of a plain object, or in a Map.'
      : 'Pass it to keepState as well, use plain objects, or call markImmutable with what is no state.',
  });
}

/** Arrays whose names were looked through: there may be very many. */
const inspected = new WeakSet<object>();

function problemOfCopied(value: object): string | undefined {
  if (Array.isArray(value)) {
    if (inspected.has(value)) return undefined;
    // Elements come before other properties.
    const last = Object.keys(value).at(-1) ?? '0';
    if (String(Number(last) >>> 0) !== last) return `has the property "${last}", which is no element and not saved`;
    inspected.add(value);
    return undefined;
  }
  const symbol = Object.getOwnPropertySymbols(value).find((each) =>
    Object.prototype.propertyIsEnumerable.call(value, each),
  );
  return symbol && `has the property ${String(symbol)}, whose name is a symbol, and which is not saved`;
}

/**
 * No problem is an instance of which nothing can change from outside, or whose class keeps its own state: one of its fields was
 * passed to `keepState`.
 */
function problemOfInstance(instance: object): string | undefined {
  if (instance instanceof RegExp) {
    const isStateful = instance.global || instance.sticky;
    return isStateful ? 'is a regular expression that goes on from its lastIndex, which is not saved' : undefined;
  }
  if (instance instanceof WeakMap || instance instanceof WeakSet) return 'has weak references, which are not saved';
  if (Object.isFrozen(instance)) return undefined;
  let hasFields = false;
  for (const name in instance) {
    const value = (instance as Record<string, unknown>)[name];
    if (typeof value === 'object' && value !== null && isKept(value)) return undefined;
    hasFields = true;
  }
  return hasFields ? 'is an instance of a class, whose fields are not saved' : undefined;
}

/** Longest place in a message, in characters. */
const MAX_PLACE = 200;

/** How an object is reached from others, as `[0].players[1]`. */
export function pathTo(object: object, from: object): string | undefined {
  const paths = new Map<object, string>([[from, '']]);
  // The map grows while it is visited.
  for (const [at, path] of paths) {
    if (at === object)
      return path.length > MAX_PLACE ? `${path.slice(0, MAX_PLACE / 2)}…${path.slice(-MAX_PLACE / 2)}` : path;
    if (ArrayBuffer.isView(at)) continue;
    for (const [name, value] of entriesOf(at)) {
      if (typeof value === 'object' && value !== null && !paths.has(value)) paths.set(value, path + name);
    }
  }
  return undefined;
}

function entriesOf(value: object): [string, unknown][] {
  if (value instanceof Set) return [...value].map((member, i) => [`.member ${i}`, member]);
  const entries = value instanceof Map ? [...value] : Object.entries(value);
  const isList = Array.isArray(value) || value instanceof Map;
  return entries.map(([name, item]) => [isList ? `[${String(name)}]` : `.${name}`, item]);
}
