// What copies of objects contain, apart from the objects: this is what an encoded snapshot consists of.
import { ArrayCopy, type Copy, copyOf, MapCopy, NumbersCopy, ObjectCopy, SetCopy } from './plain-record.ts';

/** What an object contained. */
export interface Contents {
  readonly kind: 'array' | 'map' | 'set' | 'object' | 'numbers';
  /** Items, fields or members; keys and values of a map in turn. */
  readonly values: readonly unknown[];
  /** The names of the fields of an object. */
  readonly names?: readonly string[];
  /** The elements of a typed array. */
  readonly numbers?: Float64Array;
}

/** Returns what the object of a copy contained. */
export function contentsOf(copy: Copy): Contents {
  if (copy instanceof NumbersCopy) return { kind: 'numbers', values: [], numbers: copy.numbers };
  if (copy instanceof ArrayCopy) return { kind: 'array', values: copy.items };
  if (copy instanceof SetCopy) return { kind: 'set', values: copy.members };
  if (copy instanceof MapCopy) return { kind: 'map', values: copy.keys.flatMap((key, i) => [key, copy.values[i]]) };
  const { names, values, isField } = copy as ObjectCopy;
  // By the names, because a list has holes where fields are undefined.
  const fields = names
    .map((name, i) => ({ name, value: values[i], isField: isField[i] }))
    .filter((each) => each.isField);
  return { kind: 'object', names: fields.map(({ name }) => name), values: fields.map(({ value }) => value) };
}

/** Makes a copy with these contents, which `putBack` will write to an object. */
export function copyWith(target: object, { values, names = [], numbers }: Contents): Copy {
  const copy = copyOf(target) as Copy;
  if (copy instanceof NumbersCopy) copy.numbers.set(numbers as Float64Array);
  else if (copy instanceof ArrayCopy) fill(copy.items, values);
  else if (copy instanceof SetCopy) copy.count = fill(copy.members, values);
  else if (copy instanceof MapCopy) {
    copy.count = fill(
      copy.keys,
      values.filter((_, i) => i % 2 === 0),
    );
    fill(
      copy.values,
      values.filter((_, i) => i % 2 === 1),
    );
  } else if (copy instanceof ObjectCopy) {
    copy.names = [...names];
    copy.isField = names.map(() => true);
    fill(copy.values, values);
  }
  return copy;
}

function fill(list: unknown[], values: readonly unknown[]): number {
  for (const value of values) list.push(value);
  return values.length;
}
