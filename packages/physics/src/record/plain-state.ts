/** Puts everything it saved back in place: the objects stay the same, their contents are those of then. */
export type PutBack = () => void;

/**
 * Saves plain objects, arrays, maps, sets and typed arrays, and all of those they hold. Functions, objects of classes,
 * and what `isForeign` names are kept by reference: whoever holds state in them has to save it.
 */
export function savePlain(root: unknown, isForeign: (value: object) => boolean): PutBack {
  const steps: PutBack[] = [];
  const seen = new Set<object>();
  const visit = (value: unknown): void => {
    if (typeof value !== 'object' || value === null || seen.has(value) || isForeign(value)) return;
    seen.add(value);
    const step = saveOne(value, visit);
    if (step !== undefined) steps.push(step);
  };
  visit(root);
  return () => {
    for (const step of steps) step();
  };
}

function saveOne(value: object, visit: (value: unknown) => void): PutBack | undefined {
  if (Array.isArray(value)) return saveArray(value, visit);
  if (ArrayBuffer.isView(value) && !(value instanceof DataView)) {
    const view = value as Float64Array;
    const copy = view.slice();
    return () => view.set(copy);
  }
  if (value instanceof Map) {
    const entries = [...value];
    for (const entry of entries) entry.forEach(visit);
    return () => {
      value.clear();
      for (const [key, held] of entries) value.set(key, held);
    };
  }
  if (value instanceof Set) {
    const members = [...value];
    members.forEach(visit);
    return () => {
      value.clear();
      for (const member of members) value.add(member);
    };
  }
  return Object.getPrototypeOf(value) === Object.prototype ? saveObject(value, visit) : undefined;
}

function saveArray(array: unknown[], visit: (value: unknown) => void): PutBack {
  const copy = [...array];
  for (const element of copy) visit(element);
  return () => {
    if (array.length !== copy.length) array.length = copy.length;
    for (let i = 0; i < copy.length; i++) if (!Object.is(array[i], copy[i])) array[i] = copy[i];
  };
}

function saveObject(object: object, visit: (value: unknown) => void): PutBack {
  const fields = Object.entries(Object.getOwnPropertyDescriptors(object)).filter(([, { get }]) => get === undefined);
  for (const [, { value }] of fields) visit(value);
  const target = object as Record<string, unknown>;
  const known = new Set(fields.map(([name]) => name));
  return () => {
    // What never changes may be frozen: it is not written to.
    for (const name of Object.keys(target)) {
      const isNew = !known.has(name) && Object.getOwnPropertyDescriptor(target, name)?.get === undefined;
      if (isNew) delete target[name];
    }
    for (const [name, { value }] of fields) if (!Object.is(target[name], value)) target[name] = value;
  };
}
