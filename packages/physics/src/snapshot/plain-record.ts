// Copies of plain objects that are written again and again: a world put aside every few steps leaves no garbage.

import { isKept } from './keep-state.ts';

/** Copies one object; made for it once. */
interface Copy {
  readonly target: object;
  /** Copies the contents, and visits what they are. */
  take(visit: (value: unknown) => void): void;
  putBack(): void;
}

/** When an object was last visited: a traversal meets each once. */
const visits = new WeakMap<object, number>();
let traversals = 0;

/**
 * Saves plain objects, arrays, maps, sets and typed arrays, and all of those they hold, as often as it is told to, and
 * puts the last copy back in place: the objects stay the same, their contents are those of then. Functions, objects of
 * classes, and what `isForeign` names are kept by reference: whoever holds state in them has to save it.
 */
export class PlainRecord {
  readonly #isForeign: (value: object) => boolean;
  /** Those of the last traversal, in the order they were met. */
  readonly #copies: Copy[] = [];
  /** Those there ever were, of objects that live. */
  readonly #known = new WeakMap<object, Copy>();
  #count = 0;
  #traversal = 0;

  constructor(isForeign: (value: object) => boolean) {
    this.#isForeign = isForeign;
  }

  /** Forgets the copy there was; `add` makes the next. */
  begin(): void {
    this.#count = 0;
    this.#traversal = ++traversals;
  }

  /** Copies what `value` holds, all of it, unless it was met before. */
  readonly add = (value: unknown): void => {
    if (typeof value !== 'object' || value === null) return;
    if (visits.get(value) === this.#traversal || this.#isForeign(value)) return;
    visits.set(value, this.#traversal);
    let copy = this.#known.get(value);
    if (copy === undefined) {
      copy = copyOf(value);
      if (copy === undefined) return;
      this.#known.set(value, copy);
    }
    this.#copies[this.#count++] = copy;
    copy.take(this.add);
  };

  /** Lets go of copies that the last traversal had no use for. */
  end(): void {
    this.#copies.length = this.#count;
  }

  /** An object that was frozen since, whose contents cannot be put back. */
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

/** Freezing leaves the entries of maps and sets as they are. */
function hasContents(value: object): boolean {
  return !(value instanceof Map) && !(value instanceof Set) && Object.keys(value).length > 0;
}

function copyOf(value: object): Copy | undefined {
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

class NumbersCopy implements Copy {
  readonly target: Float64Array;
  readonly #numbers: Float64Array;

  constructor(target: Float64Array) {
    this.target = target;
    this.#numbers = target.slice();
  }

  take(): void {
    this.#numbers.set(this.target);
  }

  putBack(): void {
    this.target.set(this.#numbers);
  }
}

class ArrayCopy implements Copy {
  readonly target: unknown[];
  readonly #items: unknown[] = [];

  constructor(target: unknown[]) {
    this.target = target;
  }

  take(visit: (value: unknown) => void): void {
    const items = this.#items;
    const { target } = this;
    if (items.length !== target.length) items.length = target.length;
    for (let i = 0; i < target.length; i++) {
      items[i] = target[i];
      visit(target[i]);
    }
  }

  putBack(): void {
    const { target } = this;
    const items = this.#items;
    if (target.length !== items.length) target.length = items.length;
    for (let i = 0; i < items.length; i++) if (!Object.is(target[i], items[i])) target[i] = items[i];
  }
}

class MapCopy implements Copy {
  readonly target: Map<unknown, unknown>;
  readonly #keys: unknown[] = [];
  readonly #values: unknown[] = [];
  #count = 0;

  constructor(target: Map<unknown, unknown>) {
    this.target = target;
  }

  take(visit: (value: unknown) => void): void {
    this.#count = 0;
    this.target.forEach(this.#note);
    this.#keys.length = this.#count;
    this.#values.length = this.#count;
    for (let i = 0; i < this.#count; i++) {
      visit(this.#keys[i]);
      visit(this.#values[i]);
    }
  }

  readonly #note = (value: unknown, key: unknown): void => {
    this.#keys[this.#count] = key;
    this.#values[this.#count++] = value;
  };

  putBack(): void {
    this.target.clear();
    for (let i = 0; i < this.#count; i++) this.target.set(this.#keys[i], this.#values[i]);
  }
}

class SetCopy implements Copy {
  readonly target: Set<unknown>;
  readonly #members: unknown[] = [];
  #count = 0;

  constructor(target: Set<unknown>) {
    this.target = target;
  }

  take(visit: (value: unknown) => void): void {
    this.#count = 0;
    this.target.forEach(this.#note);
    this.#members.length = this.#count;
    for (let i = 0; i < this.#count; i++) visit(this.#members[i]);
  }

  readonly #note = (member: unknown): void => {
    this.#members[this.#count++] = member;
  };

  putBack(): void {
    this.target.clear();
    for (let i = 0; i < this.#count; i++) this.target.add(this.#members[i]);
  }
}

class ObjectCopy implements Copy {
  readonly target: Record<string, unknown>;
  /** All names, and which of them are fields rather than getters. */
  #names: string[] = [];
  #isField: boolean[] = [];
  readonly #values: unknown[] = [];

  constructor(target: object) {
    this.target = target as Record<string, unknown>;
  }

  take(visit: (value: unknown) => void): void {
    if (!this.#hasSameNames()) this.#learnNames();
    const { target } = this;
    const names = this.#names;
    for (let i = 0; i < names.length; i++) {
      if (!this.#isField[i]) continue;
      const value = target[names[i]];
      if (!Object.is(this.#values[i], value)) this.#values[i] = value;
      visit(value);
    }
  }

  /** Without a list of the present names, which would be garbage. */
  #hasSameNames(): boolean {
    let count = 0;
    for (const name in this.target) if (this.#names[count++] !== name) return false;
    return count === this.#names.length;
  }

  #learnNames(): void {
    const { target } = this;
    this.#names = Object.keys(target);
    this.#isField = this.#names.map((name) => Object.getOwnPropertyDescriptor(target, name)?.get === undefined);
    this.#values.length = 0;
  }

  putBack(): void {
    const { target } = this;
    // What never changes may be frozen: it is not written to.
    for (const name of Object.keys(target)) {
      const isNew = !this.#names.includes(name) && Object.getOwnPropertyDescriptor(target, name)?.get === undefined;
      if (isNew) delete target[name];
    }
    for (let i = 0; i < this.#names.length; i++) {
      const [name, value] = [this.#names[i], this.#values[i]];
      if (this.#isField[i] && !Object.is(target[name], value)) target[name] = value;
    }
  }
}
