// What all networks share: nodes that are bodies, springs between them, and how they are made.
import type { ManyInput } from '../bodies/many.ts';
import { spawnMany } from '../bodies/spawn-many.ts';
import { ensureCapacity } from '../ecs/entity-capacity.ts';
import { assertUsable } from '../ecs/guards.ts';
import { type Bounds, checkNumber, checkObject } from '../errors/validate.ts';
import type { PhysicsWorld } from '../world/types.ts';

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
}

/**
 * Makes the bodies and the springs between them, or nothing: springs name bodies by their index.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN, E_CAPACITY, E_REENTRANT, E_DESTROYED
 */
export function spawnNetwork(
  world: PhysicsWorld,
  count: number,
  bodies: Pick<ManyInput, 'position' | 'mass'>,
  list: SpringList,
  { damping = 0, breakForce = 0, components }: SpringOptions,
): Network {
  assertUsable(world);
  checkNumber(damping, 'damping', { min: 0, max: 1e30 });
  checkNumber(breakForce, 'breakForce', { min: 0, max: 1e30 });
  if (components !== undefined) checkObject(components, 'components');
  const springs = list.a.length;
  ensureCapacity(world, count + springs);
  const nodes = spawnMany(world, count, { ...components, velocity: {}, ...bodies });
  const end = (ends: readonly number[]) => Uint32Array.from(ends, (node) => nodes[node]);
  const { stiffness, length, cord } = list;
  const spring = { a: end(list.a), b: end(list.b), stiffness, length, cord, damping, breakForce };
  return { nodes, springs: spawnMany(world, springs, { spring }) };
}
