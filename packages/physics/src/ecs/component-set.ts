// The components of one entity. bitECS keeps a `Set` per entity, which takes 150 bytes, and 250 from the fifth
// component on: most of the memory of a million bodies. Here an entity has one word of bits, and a `Set` only once it
// has a component that is not the engine's.
import type { ComponentRef } from 'bitecs';
import { bitOf, COMPONENT_NAMES } from '../components/all.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { bitIn } from './bitecs-adapter.ts';

/** Implements the methods that bitECS calls (add, delete, iterate), and the others that readers expect of a `Set`. */
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
