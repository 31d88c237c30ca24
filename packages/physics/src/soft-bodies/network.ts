// Networks of springs: nodes that are bodies, springs between them, and the function that creates both.
import type { ManyInput } from '../bodies/many.ts';
import { spawnMany, undoSpawn } from '../bodies/spawn-many.ts';
import { ensureCapacity } from '../ecs/entity-capacity.ts';
import { assertOutsideStep, assertUsable } from '../ecs/guards.ts';
import { type Bounds, checkNumber, checkObject } from '../errors/validate.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** A network of springs: entity ids. */
export interface Network {
  /** The bodies. */
  readonly nodes: Uint32Array;
  /** The entities with Spring. */
  readonly springs: Uint32Array;
}

/** The options of the springs and nodes of a network. */
export interface SpringOptions {
  /** Damping of each spring, N s/m; default 0. */
  readonly damping?: number;
  /** Tension at which springs break, N, if the system `breakSprings` runs; default 0: never. */
  readonly breakForce?: number;
  /** Further components of every node, such as `{ collider: { radius: 0.01 } }`. Default none. */
  readonly components?: Omit<ManyInput, 'position' | 'velocity' | 'mass'>;
}

export const SPRING_OPTIONS = ['damping', 'breakForce', 'components'] as const;

/** Checks a stiffness, N/m; Infinity is allowed. */
export function checkStiffness(value: number, field: string): number {
  return value === Infinity ? value : checkNumber(value, field, { min: 0, max: 1e30 });
}

export const COUNT_BOUNDS: Bounds = { min: 2, max: 1e6, integer: true };

/** The springs to create, column by column. */
export class SpringList {
  readonly a: number[] = [];
  readonly b: number[] = [];
  readonly stiffness: number[] = [];
  readonly length: number[] = [];
  readonly tensionOnly: number[] = [];

  add(a: number, b: number, stiffness: number, length: number, tensionOnly = 0): void {
    this.a.push(a);
    this.b.push(b);
    this.stiffness.push(stiffness);
    this.length.push(length);
    this.tensionOnly.push(tensionOnly);
  }
}

/**
 * Creates the bodies and the springs between them, or nothing on failure. Springs refer to bodies by index.
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
  assertOutsideStep(world, 'createRope, createCloth and createSoftBody', 'Call it after the step.');
  checkNumber(damping, 'damping', { min: 0, max: 1e30 });
  checkNumber(breakForce, 'breakForce', { min: 0, max: 1e30 });
  if (components !== undefined) checkObject(components, 'components');
  const springs = list.a.length;
  ensureCapacity(world, count + springs);
  const nodes = spawnMany(world, count, { ...components, velocity: {}, ...bodies });
  const toIds = (ends: readonly number[]) => Uint32Array.from(ends, (node) => nodes[node]);
  const { stiffness, length, tensionOnly } = list;
  const spring = { a: toIds(list.a), b: toIds(list.b), stiffness, length, tensionOnly, damping, breakForce };
  try {
    return { nodes, springs: spawnMany(world, springs, { spring }) };
  } catch (error) {
    undoSpawn(world, nodes);
    throw error;
  }
}
