// Immutable data, as Immer and similar libraries make it: a snapshot needs no copy, since a reference restores it.

const known = new WeakSet<object>();

/** Returns whether an object is a frozen plain object or array, and all that it contains is too, or no object. */
export function isDeeplyFrozen(value: object): boolean {
  if (!Object.isFrozen(value)) return false;
  // The set grows while it is visited.
  const found = new Set([value]);
  for (const each of found) {
    if (known.has(each)) continue;
    if (!Object.isFrozen(each) || !isPlain(each) || Object.getOwnPropertySymbols(each).length > 0) return false;
    for (const item of Object.values(each)) {
      if (typeof item === 'function') return false;
      if (typeof item === 'object' && item !== null) found.add(item);
    }
  }
  for (const each of found) known.add(each);
  return true;
}

function isPlain(value: object): boolean {
  const prototype = Object.getPrototypeOf(value);
  return prototype === Object.prototype || prototype === null || Array.isArray(value);
}
