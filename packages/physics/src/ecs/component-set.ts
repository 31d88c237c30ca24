// The components of one entity, as bitECS lists them in a `Set` of its own for each. A `Set` takes 150 bytes, and 250
// from the fifth component on; a million of them are most of what a million bodies weigh. Here an entity has one word
// of bits, and a `Set` only once it gets a component that is not the engine's.
import type { ComponentRef } from 'bitecs';
import { bitOf, COMPONENT_NAMES } from '../components/all.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { bitIn } from './bitecs-adapter.ts';

/** Does what bitECS asks of the set: add, delete, iterate; and what a reader of it would expect besides. */
export class ComponentSet implements Iterable<ComponentRef> {
  readonly #world: PhysicsWorld;
  #bits: number;
  #others: Set<ComponentRef> | undefined = undefined;

  constructor(world: PhysicsWorld, bits: number) {
    this.#world = world;
    this.#bits = bits;
  }

  add(component: ComponentRef): this {
    const bit = bitIn(this.#world, component);
    this.#bits |= bit;
    if (bit === 0) {
      this.#others ??= new Set();
      this.#others.add(component);
    }
    return this;
  }

  delete(component: ComponentRef): boolean {
    const had = this.has(component);
    this.#bits &= ~bitIn(this.#world, component);
    this.#others?.delete(component);
    return had;
  }

  has(component: ComponentRef): boolean {
    return (this.#bits & bitIn(this.#world, component)) !== 0 || this.#others?.has(component) === true;
  }

  get size(): number {
    return [...this].length;
  }

  *[Symbol.iterator](): Iterator<ComponentRef> {
    const { components } = this.#world;
    for (const name of COMPONENT_NAMES) if ((this.#bits & bitOf(name)) !== 0) yield components[name];
    if (this.#others !== undefined) yield* this.#others;
  }
}
