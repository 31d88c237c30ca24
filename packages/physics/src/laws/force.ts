import { checkHas } from '../errors/validate.ts';
import type { Force, PhysicsWorld } from '../world/types.ts';

/** What a user's own force in plain TypeScript needs to say. */
export interface CustomForce {
  readonly name: string;
  readonly equation?: string;
  readonly reads?: readonly string[];
  /** Default true: reads nothing but its own body. */
  readonly local?: boolean;
  /** Default false: adds to `world.scratch.torque` as well. */
  readonly appliesTorque?: boolean;
  prepare?(world: PhysicsWorld, dt: number): void;
  accumulate(world: PhysicsWorld, first: number, last: number, time: number): void;
  potential?(world: PhysicsWorld): number;
}

/**
 * A force of your own in plain TypeScript. In `accumulate`, add newtons to `world.scratch.force.x[eid]` for each row in
 * [first, last); rows of absent bodies hold zeros and need no test.
 */
export function defineForce(force: CustomForce): Force {
  checkHas(force, 'accumulate', 'defineForce: force', 'Give { name, accumulate(world, first, last, time) { … } }.');
  const {
    name,
    equation = '',
    reads = [],
    local = true,
    appliesTorque = false,
    accumulate,
    prepare,
    potential,
  } = force;
  return {
    name,
    equation,
    reads,
    local,
    appliesTorque,
    accumulate,
    ...(prepare && { prepare }),
    ...(potential && { potential }),
  };
}
