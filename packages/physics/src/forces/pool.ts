// A fluid with a level surface, as the kernels of kernels/forces/immersion.ts see it.
import { checkKeys, checkNumber, checkVector, type VectorInput } from '../faults/validate';
import { allocate } from '../store/arena';
import { resource } from '../store/resource';
import type { PhysicsWorld } from '../world';
import { ANY, PLACES, POSITIVE, SPEEDS } from './bounds';
import type { ForceParameter } from './force';
import { unit } from './lift';
import { STANDARD_GRAVITY } from './uniform-gravity';

/** A body of water, or the air when there is no level. Give the same record to all forces of one pool. */
export interface Pool {
  /** Density ρ, kg/m³. */
  readonly density: number;
  /** Gravity, m/s²; default standard gravity downwards. It says where up is. */
  readonly gravity?: VectorInput;
  /** Height of the surface along up, m: y of the surface when gravity points down. Left out, the fluid is everywhere. */
  readonly level?: number;
  /** How the fluid moves, m/s; default not. */
  readonly flow?: VectorInput;
}

/** What a force of a pool needs. */
export interface PoolState {
  /** Address of the pool in a world's memory. */
  readonly at: (world: PhysicsWorld) => number;
  readonly parameters: Readonly<Record<string, ForceParameter>>;
}

/** Higher than any body can be. */
const EVERYWHERE = 1e16;

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function poolState(pool: Pool, caller: string): PoolState {
  checkKeys(pool, caller, ['density', 'gravity', 'level', 'flow']);
  const density = checkNumber(pool.density, `${caller}.density`, POSITIVE);
  const gravity = checkVector(pool.gravity ?? { y: -STANDARD_GRAVITY }, `${caller}.gravity`, ANY);
  const down = unit(gravity, `${caller}.gravity`);
  const size = gravity.x * down.x + gravity.y * down.y + gravity.z * down.z;
  const level = pool.level === undefined ? EVERYWHERE : checkNumber(pool.level, `${caller}.level`, PLACES);
  const flow = checkVector(pool.flow ?? {}, `${caller}.flow`, SPEEDS);
  const values = [density, size, -down.x, -down.y, -down.z, level, flow.x, flow.y, flow.z];
  return {
    at: resource((world) => {
      const at = allocate(world.internal.arena, 8 * values.length, 'a pool');
      new Float64Array(world.memory.buffer, at, values.length).set(values);
      return at;
    }),
    parameters: {
      density: { unit: 'kg/m³', value: density },
      gravity: { unit: 'm/s²', value: size },
      ...(pool.level === undefined ? {} : { level: { unit: 'm', value: level } }),
    },
  };
}

/** Addresses of the columns that say what a body displaces and how it drags: the same for every pool of a world. */
export const hullTable = resource((world) => {
  const { Hull, QuadraticDrag, LinearDrag } = world.addresses;
  const columns = [Hull.volume, Hull.halfHeight, Hull.shape, QuadraticDrag.coefficient, LinearDrag.coefficient];
  const at = allocate(world.internal.arena, 4 * columns.length, 'hulls');
  new Uint32Array(world.memory.buffer, at, columns.length).set(columns);
  return at;
});
