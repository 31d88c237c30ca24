// Reusable copies of plain objects: repeated snapshots of a world create no garbage.
import { isDeeplyFrozen } from './deeply-frozen.ts';
import { type Copy, copyOf } from './object-copies.ts';

/** The traversal that last visited an object; a traversal visits each object once. */
const visits = new WeakMap<object, number>();
let traversals = 0;

/**
 * Saves plain objects, arrays, maps, sets, dates, buffers and typed arrays, including nested ones, any number of times, and
 * restores the last copy in place: the objects keep their identity and get the saved contents. Functions, instances of classes,
 * deeply frozen data and objects for which `isForeign` is true are kept by reference; the owner of an instance must save its state.
 */
export class PlainRecord {
  readonly #isForeign: (value: object) => boolean;
  /** Copies of the last traversal, in the order of visits. */
  readonly #copies: Copy[] = [];
  /** All copies ever made, of objects that are still referenced. */
  readonly #known = new WeakMap<object, Copy>();
  #count = 0;
  /** The first copy whose contents were not visited yet: there is no recursion, because a list may be long. */
  #next = 0;
  #traversal = 0;
  /** Called with each new object, and whether it has a copy, to refuse what would be lost; undefined where that is meant. */
  inspect: ((value: object, isCopied: boolean) => void) | undefined;

  constructor(isForeign: (value: object) => boolean) {
    this.#isForeign = isForeign;
  }

  /** Clears the present copy; `add` builds the next. */
  begin(): void {
    this.#count = 0;
    this.#next = 0;
    this.#traversal = ++traversals;
  }

  /** Copies the contents of `value` and of all objects in it, unless they were visited before. */
  readonly add = (value: unknown): void => {
    this.#note(value);
    while (this.#next < this.#count) this.#copies[this.#next++].take(this.#note);
  };

  readonly #note = (value: unknown): void => {
    if (typeof value !== 'object' || value === null) return;
    if (visits.get(value) === this.#traversal || this.#isForeign(value)) return;
    visits.set(value, this.#traversal);
    if (isDeeplyFrozen(value)) return;
    const copy = this.#known.get(value) ?? this.#makeCopy(value);
    if (copy !== undefined) this.#copies[this.#count++] = copy;
  };

  #makeCopy(value: object): Copy | undefined {
    const copy = copyOf(value);
    this.inspect?.(value, copy !== undefined);
    if (copy !== undefined) this.#known.set(value, copy);
    return copy;
  }

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

  /** Returns an object that cannot take its saved contents, because it was frozen or sealed. */
  findUnwritable(): object | undefined {
    return this.#copies.find((copy) => copy.isWritable?.() === false)?.target;
  }

  putBack(): void {
    for (let i = 0; i < this.#count; i++) this.#copies[i].putBack();
  }
}
