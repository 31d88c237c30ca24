// The components of one entity. bitECS keeps a `Set` per entity, which takes 150 bytes, and 250 from the fifth
// component on: most of the memory of a million bodies. Here an entity has two words of bits, and a `Set` only once it
// has a component that is not the engine's.
import type { ComponentRef } from 'bitecs';
import { COMPONENT_NAMES, type ComponentName } from '../../components/all.ts';
import { bitInWord, isInFirstWord, type MemberBits } from '../../components/membership.ts';
import type { PhysicsWorld } from '../../world/types.ts';
import { nameIn } from './guard-tables.ts';

/** Implements the methods that bitECS calls (add, delete, iterate), and the others that readers expect of a `Set`. */
export class ComponentSet implements Iterable<ComponentRef> {
  readonly #world: PhysicsWorld;
  #first: number;
  #second: number;
  #others: Set<ComponentRef> | undefined = undefined;

  constructor(world: PhysicsWorld, { first, second }: MemberBits) {
    this.#world = world;
    this.#first = first;
    this.#second = second;
  }

  add(component: ComponentRef): this {
    const name = nameIn(this.#world, component);
    if (name === undefined) {
      this.#others ??= new Set();
      this.#others.add(component);
    } else if (!this.#hasBit(name)) {
      this.#toggle(name);
    }
    return this;
  }

  delete(component: ComponentRef): boolean {
    const name = nameIn(this.#world, component);
    if (name === undefined) return this.#others?.delete(component) === true;
    const had = this.#hasBit(name);
    if (had) this.#toggle(name);
    return had;
  }

  has(component: ComponentRef): boolean {
    const name = nameIn(this.#world, component);
    return name === undefined ? this.#others?.has(component) === true : this.#hasBit(name);
  }

  #hasBit(name: ComponentName): boolean {
    return ((isInFirstWord(name) ? this.#first : this.#second) & bitInWord(name)) !== 0;
  }

  #toggle(name: ComponentName): void {
    if (isInFirstWord(name)) this.#first ^= bitInWord(name);
    else this.#second ^= bitInWord(name);
  }

  get size(): number {
    return [...this].length;
  }

  *[Symbol.iterator](): Iterator<ComponentRef> {
    const { components } = this.#world;
    for (const name of COMPONENT_NAMES) if (this.#hasBit(name)) yield components[name];
    if (this.#others !== undefined) yield* this.#others;
  }
}
