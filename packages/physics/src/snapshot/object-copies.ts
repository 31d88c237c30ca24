// Copies of the contents of single objects, which are made once and used again.
import { isKept } from './keep-state.ts';
import type { NumberArray } from './packed-bytes.ts';

/** A reusable copy of one object. Its fields are for `contents.ts`, too. */
export interface Copy {
  readonly target: object;
  /** Copies the contents and visits nested values. */
  take(visit: (value: unknown) => void): void;
  putBack(): void;
  /** Whether `putBack` can succeed: objects may have been frozen. Default true. */
  isWritable?(): boolean;
}

/** Returns an empty copy of an object, undefined if it is kept by reference. */
export function copyOf(value: object): Copy | undefined {
  if (Array.isArray(value)) return new ArrayCopy(value);
  const bytes = bytesOf(value);
  if (bytes !== undefined) return new NumbersCopy(value, bytes);
  if (value instanceof Map) return new MapCopy(value);
  if (value instanceof Set) return new SetCopy(value);
  if (value instanceof Date) return new DateCopy(value);
  const prototype = Object.getPrototypeOf(value);
  // A frozen object without a prototype is a module, such as the functions of kernels.
  const isDictionary = prototype === null && !Object.isFrozen(value);
  const isPlain = prototype === Object.prototype || isDictionary || isKept(value);
  return isPlain ? new ObjectCopy(value) : undefined;
}

/** The elements of a typed array, the bytes of a buffer or of a view of one. */
function bytesOf(value: object): NumberArray | undefined {
  if (value instanceof ArrayBuffer) return new Uint8Array(value);
  if (value instanceof DataView) return new Uint8Array(value.buffer, value.byteOffset, value.byteLength);
  return ArrayBuffer.isView(value) ? (value as Float64Array) : undefined;
}

export class NumbersCopy implements Copy {
  readonly target: object;
  readonly numbers: NumberArray;
  readonly #elements: NumberArray;

  constructor(target: object, elements: NumberArray) {
    this.target = target;
    this.#elements = elements;
    // The method of Node's Buffer makes a view.
    this.numbers = elements instanceof Uint8Array ? new Uint8Array(elements) : elements.slice();
  }

  take(): void {
    this.numbers.set(this.#elements);
  }

  putBack(): void {
    this.#elements.set(this.numbers);
  }
}

export class DateCopy implements Copy {
  readonly target: Date;
  time = 0;

  constructor(target: Date) {
    this.target = target;
  }

  take(): void {
    this.time = this.target.getTime();
  }

  putBack(): void {
    this.target.setTime(this.time);
  }
}

export class ArrayCopy implements Copy {
  readonly target: unknown[];
  /** It has holes where the array has. */
  readonly items: unknown[] = [];

  constructor(target: unknown[]) {
    this.target = target;
  }

  take(visit: (value: unknown) => void): void {
    assignItems(this.items, this.target);
    for (let i = 0; i < this.items.length; i++) visit(this.items[i]);
  }

  putBack(): void {
    assignItems(this.target, this.items);
  }

  isWritable(): boolean {
    const { target, items } = this;
    if (Object.isExtensible(target)) return true;
    return (
      target.length === items.length &&
      (!Object.isFrozen(target) || items.every((item, i) => Object.is(item, target[i])))
    );
  }
}

function assignItems(into: unknown[], from: readonly unknown[]): void {
  if (into.length !== from.length) into.length = from.length;
  for (let i = 0; i < from.length; i++) {
    const item = from[i];
    if (item === undefined && !(i in from)) {
      if (i in into) delete into[i];
    } else if (!Object.is(into[i], item) || (item === undefined && !(i in into))) into[i] = item;
  }
}

export class MapCopy implements Copy {
  readonly target: Map<unknown, unknown>;
  readonly keys: unknown[] = [];
  readonly values: unknown[] = [];
  count = 0;

  constructor(target: Map<unknown, unknown>) {
    this.target = target;
  }

  take(visit: (value: unknown) => void): void {
    this.count = 0;
    this.target.forEach(this.#note);
    this.keys.length = this.count;
    this.values.length = this.count;
    for (let i = 0; i < this.count; i++) {
      visit(this.keys[i]);
      visit(this.values[i]);
    }
  }

  readonly #note = (value: unknown, key: unknown): void => {
    this.keys[this.count] = key;
    this.values[this.count++] = value;
  };

  putBack(): void {
    this.target.clear();
    for (let i = 0; i < this.count; i++) this.target.set(this.keys[i], this.values[i]);
  }
}

export class SetCopy implements Copy {
  readonly target: Set<unknown>;
  readonly members: unknown[] = [];
  count = 0;

  constructor(target: Set<unknown>) {
    this.target = target;
  }

  take(visit: (value: unknown) => void): void {
    this.count = 0;
    this.target.forEach(this.#note);
    this.members.length = this.count;
    for (let i = 0; i < this.count; i++) visit(this.members[i]);
  }

  readonly #note = (member: unknown): void => {
    this.members[this.count++] = member;
  };

  putBack(): void {
    this.target.clear();
    for (let i = 0; i < this.count; i++) this.target.add(this.members[i]);
  }
}

export class ObjectCopy implements Copy {
  readonly target: Record<string, unknown>;
  /** All property names in their order, and which of them are data fields rather than getters. */
  names: string[] = [];
  isField: boolean[] = [];
  readonly values: unknown[] = [];

  constructor(target: object) {
    this.target = target as Record<string, unknown>;
  }

  take(visit: (value: unknown) => void): void {
    if (!this.#hasSameNames()) this.#learnNames();
    const { target } = this;
    const names = this.names;
    for (let i = 0; i < names.length; i++) {
      if (!this.isField[i]) continue;
      const value = target[names[i]];
      if (!Object.is(this.values[i], value)) this.values[i] = value;
      visit(value);
    }
  }

  /** Compares without a list of the present names, which would be garbage. */
  #hasSameNames(): boolean {
    let count = 0;
    for (const name in this.target) if (this.names[count++] !== name) return false;
    return count === this.names.length;
  }

  #learnNames(): void {
    const { target } = this;
    this.names = Object.keys(target);
    this.isField = this.names.map((name) => !isAccessor(target, name));
    this.values.length = 0;
  }

  putBack(): void {
    if (!this.#hasSameNames()) this.#makeNames();
    const { target } = this;
    for (let i = 0; i < this.names.length; i++) {
      const [name, value] = [this.names[i], this.values[i]];
      if (this.isField[i] && !Object.is(target[name], value)) target[name] = value;
    }
  }

  /** Gives the object its names again, in their order, which loops over them follow. */
  #makeNames(): void {
    const { target } = this;
    const accessors = Object.keys(target).filter((name) => isAccessor(target, name));
    const getters = new Map(
      accessors.map((name) => [name, Object.getOwnPropertyDescriptor(target, name) as PropertyDescriptor]),
    );
    for (const name of Object.keys(target)) delete target[name];
    this.names.forEach((name, i) => {
      const field = { value: this.values[i], writable: true, enumerable: true, configurable: true };
      const property = this.isField[i] ? field : getters.get(name);
      if (property !== undefined) Object.defineProperty(target, name, property);
    });
    for (const [name, getter] of getters) if (!Object.hasOwn(target, name)) Object.defineProperty(target, name, getter);
  }

  isWritable(): boolean {
    const { target } = this;
    if (Object.isExtensible(target)) return true;
    if (!this.#hasSameNames()) return false;
    return (
      !Object.isFrozen(target) ||
      this.names.every((name, i) => !this.isField[i] || Object.is(target[name], this.values[i]))
    );
  }
}

function isAccessor(target: object, name: string): boolean {
  return Object.getOwnPropertyDescriptor(target, name)?.get !== undefined;
}
