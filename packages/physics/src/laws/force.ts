import { COMPONENT_NAMES, type ComponentName } from '../components/all.ts';
import { checkFlag, checkFunction, checkHas, checkKeys, checkList, unknownName } from '../errors/validate.ts';
import type { Force, PhysicsWorld } from '../world/types.ts';

/** The description of a custom force in plain TypeScript. */
export interface CustomForce {
  readonly name: string;
  /** The equation, to be shown. Default none. */
  readonly equation?: string;
  /** Components whose columns it reads. Default none. */
  readonly reads?: readonly ComponentName[];
  /** Default true: the force on a body depends on that body only. */
  readonly local?: boolean;
  /** If not local: components of other bodies that it reads beside position and velocity. Default all. */
  readonly readsOfOthers?: readonly ComponentName[];
  /** Default false: the force also adds to `world.scratch.torque`. */
  readonly appliesTorque?: boolean;
  prepare?(world: PhysicsWorld, dt: number): void;
  accumulate(world: PhysicsWorld, first: number, last: number, time: number): void;
  potential?(world: PhysicsWorld): number;
  /** For sums over pairs of bodies: as `Force.evaluationWork`. */
  evaluationWork?(world: PhysicsWorld): number;
}

const KEYS = [
  'name',
  'equation',
  'reads',
  'local',
  'readsOfOthers',
  'appliesTorque',
  'prepare',
  'accumulate',
  'potential',
  'evaluationWork',
];

/**
 * Defines a custom force in plain TypeScript. `accumulate` adds newtons to `world.scratch.force.x[eid]` for each row in
 * [first, last); rows without a body hold zeros and need no test.
 * @throws PhysicsError E_TYPE, E_UNKNOWN
 */
export function defineForce(force: CustomForce): Force {
  checkHas(force, 'accumulate', 'defineForce: force', 'Give { name, accumulate(world, first, last, time) { … } }.');
  checkKeys(force, 'defineForce', KEYS);
  const {
    name,
    equation = '',
    reads = [],
    local = true,
    readsOfOthers,
    appliesTorque = false,
    accumulate,
    prepare,
    potential,
    evaluationWork,
  } = force;
  checkList(reads, 'defineForce: reads');
  checkList(readsOfOthers, 'defineForce: readsOfOthers');
  checkFlag(local, 'defineForce: local');
  checkFlag(appliesTorque, 'defineForce: appliesTorque');
  for (const [key, value] of Object.entries({ prepare, potential, evaluationWork })) {
    if (value !== undefined) checkFunction(value, `defineForce: ${key}`);
  }
  for (const name of [...reads, ...(readsOfOthers ?? [])]) {
    if (!COMPONENT_NAMES.includes(name)) throw unknownName('defineForce', 'component', name, COMPONENT_NAMES);
  }
  return {
    name,
    equation,
    reads,
    local,
    appliesTorque,
    accumulate,
    ...(readsOfOthers && { readsOfOthers }),
    ...(prepare && { prepare }),
    ...(potential && { potential }),
    ...(evaluationWork && { evaluationWork }),
  };
}
