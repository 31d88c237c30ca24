// What copies of objects contain, apart from the objects: this is what an encoded snapshot consists of.
import {
  ArrayCopy,
  type Copy,
  copyOf,
  DateCopy,
  MapCopy,
  NumbersCopy,
  type ObjectCopy,
  SetCopy,
} from './object-copies.ts';
import type { NumberArray } from './packed-bytes.ts';

/** In the place of an element that an array does not have. */
export const HOLE = Symbol('hole');

/** What an object contained. */
export interface Contents {
  readonly kind: 'array' | 'map' | 'set' | 'object' | 'numbers' | 'buffer' | 'view' | 'date';
  /** Items, fields or members; keys and values of a map in turn; the time of a date. */
  readonly values: readonly unknown[];
  /** The names of the fields of an object. */
  readonly names?: readonly string[];
  /** The elements of a typed array, or the bytes of a buffer or of a view. */
  readonly numbers?: NumberArray;
}

/** Returns what the object of a copy contained. */
export function contentsOf(copy: Copy): Contents {
  if (copy instanceof NumbersCopy) return { kind: kindOfNumbers(copy.target), values: [], numbers: copy.numbers };
  if (copy instanceof ArrayCopy) {
    return { kind: 'array', values: Array.from(copy.items, (item, i) => (i in copy.items ? item : HOLE)) };
  }
  if (copy instanceof DateCopy) return { kind: 'date', values: [copy.time] };
  if (copy instanceof SetCopy) return { kind: 'set', values: copy.members };
  if (copy instanceof MapCopy) return { kind: 'map', values: copy.keys.flatMap((key, i) => [key, copy.values[i]]) };
  const { names, values, isField } = copy as ObjectCopy;
  // By the names, because a list has holes where fields are undefined.
  const fields = names
    .map((name, i) => ({ name, value: values[i], isField: isField[i] }))
    .filter((each) => each.isField);
  return { kind: 'object', names: fields.map(({ name }) => name), values: fields.map(({ value }) => value) };
}

function kindOfNumbers(target: object): 'numbers' | 'buffer' | 'view' {
  if (target instanceof ArrayBuffer) return 'buffer';
  return target instanceof DataView ? 'view' : 'numbers';
}

/** Makes a copy with these contents, which `putBack` will write to an object. */
export function copyWith(target: object, { values, names = [], numbers }: Contents): Copy {
  const copy = copyOf(target) as Copy;
  if (copy instanceof NumbersCopy) copy.numbers.set(numbers as NumberArray);
  else if (copy instanceof DateCopy) copy.time = values[0] as number;
  else if (copy instanceof ArrayCopy) {
    copy.items.length = values.length;
    for (const [i, value] of values.entries()) if (value !== HOLE) copy.items[i] = value;
  } else if (copy instanceof SetCopy) copy.count = fill(copy.members, values);
  else if (copy instanceof MapCopy) {
    copy.count = fill(
      copy.keys,
      values.filter((_, i) => i % 2 === 0),
    );
    fill(
      copy.values,
      values.filter((_, i) => i % 2 === 1),
    );
  } else {
    const object = copy as ObjectCopy;
    object.names = [...names];
    object.isField = names.map(() => true);
    fill(object.values, values);
  }
  return copy;
}

function fill(list: unknown[], values: readonly unknown[]): number {
  for (const value of values) list.push(value);
  return values.length;
}
