// Reusable copies of plain objects: repeated snapshots of a world create no garbage.

import { isKept } from './keep-state.ts';

/** A reusable copy of one object. */
export interface Copy {
  readonly target: object;
  /** Copies the contents and visits nested values. */
  take(visit: (value: unknown) => void): void;
  putBack(): void;
}

/** The traversal that last visited an object; a traversal visits each object once. */
const visits = new WeakMap<object, number>();
let traversals = 0;

/**
 * Saves plain objects, arrays, maps, sets and typed arrays, including nested ones, any number of times, and restores
 * the last copy in place: the objects keep their identity and get the saved contents. Functions, instances of classes,
 * and objects for which `isForeign` is true are kept by reference; their owner must save their state.
 */
export class PlainRecord {
  readonly #isForeign: (value: object) => boolean;
  /** Copies of the last traversal, in the order of visits. */
  readonly #copies: Copy[] = [];
  /** All copies ever made, of objects that are still referenced. */
  readonly #known = new WeakMap<object, Copy>();
  #count = 0;
  #traversal = 0;
  /** Called with instances of classes that are kept by reference; undefined where that is meant. */
  onInstance: ((instance: object) => void) | undefined;

  constructor(isForeign: (value: object) => boolean) {
    this.#isForeign = isForeign;
  }

  /** Clears the present copy; `add` builds the next. */
  begin(): void {
    this.#count = 0;
    this.#traversal = ++traversals;
  }

  /** Copies the contents of `value` recursively, unless it was visited before. */
  readonly add = (value: unknown): void => {
    if (typeof value !== 'object' || value === null) return;
    if (visits.get(value) === this.#traversal || this.#isForeign(value)) return;
    visits.set(value, this.#traversal);
    let copy = this.#known.get(value);
    if (copy === undefined) {
      copy = copyOf(value);
      if (copy === undefined) {
        this.onInstance?.(value);
        return;
      }
      this.#known.set(value, copy);
    }
    this.#copies[this.#count++] = copy;
    copy.take(this.add);
  };

  /** Releases copies that the last traversal did not use. */
  end(): void {
    this.#copies.length = this.#count;
  }

  /** The copies of the last traversal: an object comes before what it alone contains. */
  get copies(): readonly Copy[] {
    return this.#copies;
  }

  /** Adds a copy that was made elsewhere. */
  addCopy(copy: Copy): void {
    this.#known.set(copy.target, copy);
    this.#copies[this.#count++] = copy;
  }

  /** Returns an object that was frozen since the copy, so that its contents cannot be restored. */
  findFrozen(): object | undefined {
    for (let i = 0; i < this.#count; i++) {
      const { target } = this.#copies[i];
      if (!ArrayBuffer.isView(target) && Object.isFrozen(target) && hasContents(target)) return target;
    }
    return undefined;
  }

  putBack(): void {
    for (let i = 0; i < this.#count; i++) this.#copies[i].putBack();
  }
}

/** Freezing does not affect the entries of maps and sets. */
function hasContents(value: object): boolean {
  return !(value instanceof Map) && !(value instanceof Set) && Object.keys(value).length > 0;
}

/** Returns an empty copy of an object, undefined if it is kept by reference. */
export function copyOf(value: object): Copy | undefined {
  if (Array.isArray(value)) return new ArrayCopy(value);
  if (ArrayBuffer.isView(value)) return value instanceof DataView ? undefined : new NumbersCopy(value as Float64Array);
  if (value instanceof Map) return new MapCopy(value);
  if (value instanceof Set) return new SetCopy(value);
  const prototype = Object.getPrototypeOf(value);
  // A frozen object without a prototype is a module, such as the functions of kernels.
  const isDictionary = prototype === null && !Object.isFrozen(value);
  const isPlain = prototype === Object.prototype || isDictionary || isKept(value);
  return isPlain ? new ObjectCopy(value) : undefined;
}

/** The fields of copies are for `contents.ts`, too. */
export class NumbersCopy implements Copy {
  readonly target: Float64Array;
  numbers: Float64Array;

  constructor(target: Float64Array) {
    this.target = target;
    this.numbers = target.slice();
  }

  take(): void {
    this.numbers.set(this.target);
  }

  putBack(): void {
    this.target.set(this.numbers);
  }
}

export class ArrayCopy implements Copy {
  readonly target: unknown[];
  readonly items: unknown[] = [];

  constructor(target: unknown[]) {
    this.target = target;
  }

  take(visit: (value: unknown) => void): void {
    const items = this.items;
    const { target } = this;
    if (items.length !== target.length) items.length = target.length;
    for (let i = 0; i < target.length; i++) {
      items[i] = target[i];
      visit(target[i]);
    }
  }

  putBack(): void {
    const { target } = this;
    const items = this.items;
    if (target.length !== items.length) target.length = items.length;
    for (let i = 0; i < items.length; i++) if (!Object.is(target[i], items[i])) target[i] = items[i];
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
  /** All property names, and which of them are data fields rather than getters. */
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
    this.isField = this.names.map((name) => Object.getOwnPropertyDescriptor(target, name)?.get === undefined);
    this.values.length = 0;
  }

  putBack(): void {
    const { target } = this;
    // A frozen object never changes and is not written to.
    for (const name of Object.keys(target)) {
      const isNew = !this.names.includes(name) && Object.getOwnPropertyDescriptor(target, name)?.get === undefined;
      if (isNew) delete target[name];
    }
    for (let i = 0; i < this.names.length; i++) {
      const [name, value] = [this.names[i], this.values[i]];
      if (this.isField[i] && !Object.is(target[name], value)) target[name] = value;
    }
  }
}
