// The components of one entity, as bitECS lists them in a `Set` of its own for each. A `Set` takes 150 bytes, and 250
// from the fifth component on; a million of them are most of what a million bodies weigh. Here an entity has one word
// of bits, and a `Set` only once it gets a component that is not the engine's.
import type { ComponentRef } from 'bitecs';
import { bitOf, COMPONENT_NAMES, type Components } from '../components/all';

/** The engine's components of a world by their bits, shared by the sets of all its bodies. */
export class ComponentBits {
  readonly components: readonly ComponentRef[];
  readonly #bits: Map<ComponentRef, number>;

  constructor(components: Components) {
    this.components = COMPONENT_NAMES.map((name) => components[name]);
    this.#bits = new Map(COMPONENT_NAMES.map((name) => [components[name], bitOf(name)]));
  }

  /** 0 for a component that is not the engine's. */
  bitOf(component: ComponentRef): number {
    return this.#bits.get(component) ?? 0;
  }
}

/** Does what bitECS asks of the set: add, delete, iterate; and what a reader of it would expect besides. */
export class ComponentSet implements Iterable<ComponentRef> {
  readonly #table: ComponentBits;
  #bits: number;
  #others: Set<ComponentRef> | undefined = undefined;

  constructor(table: ComponentBits, bits: number) {
    this.#table = table;
    this.#bits = bits;
  }

  add(component: ComponentRef): this {
    const bit = this.#table.bitOf(component);
    this.#bits |= bit;
    if (bit === 0) {
      this.#others ??= new Set();
      this.#others.add(component);
    }
    return this;
  }

  delete(component: ComponentRef): boolean {
    const had = this.has(component);
    this.#bits &= ~this.#table.bitOf(component);
    this.#others?.delete(component);
    return had;
  }

  has(component: ComponentRef): boolean {
    return (this.#bits & this.#table.bitOf(component)) !== 0 || this.#others?.has(component) === true;
  }

  get size(): number {
    return [...this].length;
  }

  *[Symbol.iterator](): Iterator<ComponentRef> {
    const { components } = this.#table;
    for (let c = 0; c < components.length; c++) if ((this.#bits & (1 << c)) !== 0) yield components[c];
    if (this.#others !== undefined) yield* this.#others;
  }
}
