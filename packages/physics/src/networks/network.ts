// What all networks share: nodes that are bodies, springs between them, and how they are made.
import type { ManyInput } from '../bodies/many';
import { spawnMany } from '../bodies/spawn-many';
import { type Bounds, checkNumber } from '../faults/validate';
import type { PhysicsWorld } from '../world';

/** A network that was made: entity ids. */
export interface Network {
  /** Bodies. */
  readonly nodes: Uint32Array;
  /** Entities with Spring. */
  readonly springs: Uint32Array;
}

/** How the springs of a network behave. */
export interface SpringOptions {
  /** N s/m between neighbours; default 0. */
  readonly damping?: number;
  /** Pull at which springs break, N, where `breakSprings` runs; default 0: never. */
  readonly breakForce?: number;
  /** Further components of every node, such as `{ collider: { radius: 0.01 } }`. */
  readonly components?: Omit<ManyInput, 'position' | 'velocity' | 'mass'>;
}

export const SPRING_OPTIONS = ['damping', 'breakForce', 'components'] as const;

/** A stiffness: Infinity is taken. */
export function checkStiffness(value: number, field: string): number {
  return value === Infinity ? value : checkNumber(value, field, { min: 0, max: 1e30 });
}

export const COUNTS: Bounds = { min: 2, max: 1e6, integer: true };

/** Springs to be made, column by column. */
export class SpringList {
  readonly a: number[] = [];
  readonly b: number[] = [];
  readonly stiffness: number[] = [];
  readonly length: number[] = [];
  readonly cord: number[] = [];

  add(a: number, b: number, stiffness: number, length: number, cord = 0): void {
    this.a.push(a);
    this.b.push(b);
    this.stiffness.push(stiffness);
    this.length.push(length);
    this.cord.push(cord);
  }

  /** Makes them, between bodies whose index is given. */
  spawn(world: PhysicsWorld, nodes: Uint32Array, { damping = 0, breakForce = 0 }: SpringOptions): Uint32Array {
    const { stiffness, length, cord } = this;
    const end = (list: readonly number[]) => Uint32Array.from(list, (node) => nodes[node]);
    const spring = { a: end(this.a), b: end(this.b), stiffness, length, cord, damping, breakForce };
    return spawnMany(world, this.a.length, { spring });
  }
}
