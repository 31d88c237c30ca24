import type { EntityRef } from '../ecs/entity-ref.ts';
import type { PhysicsWorld } from '../world/types.ts';
import type { EmitterParameters } from './options.ts';
import type { Block, PoolLists } from './pool.ts';

/** A source of particles and its pool of entities. */
export interface Emitter {
  readonly world: PhysicsWorld;
  readonly capacity: number;
  /** The entities of the pool, ascending, both living and inactive. */
  readonly ids: Uint32Array;
  /** For internal use. */
  readonly internal: EmitterInternals;
}

export interface EmitterInternals {
  readonly block: Block;
  /** A reference to the followed body, and its id. */
  readonly followed: EntityRef | undefined;
  readonly entity: number;
  parameters: EmitterParameters;
  /** The pending bursts, twelve numbers each. */
  readonly bursts: Float64Array;
  /** The result of `endings`, created on first use; the same object every time. */
  endings: { count: number; readonly ids: Uint32Array; readonly states: Float64Array } | undefined;
  /** The result of `births`, and the lists that it reads, created on first use. */
  births: { count: number; readonly ids: Uint32Array } | undefined;
  pool: PoolLists | undefined;
  /** The membership version of the world at the last check that the pool was complete. */
  membership: number;
  destroyed: boolean;
  /** The world's number of restores when the emitter's existence was last checked. */
  timeline: number;
}
