import type { EntityRef } from '../ecs/entity-ref.ts';
import type { PhysicsWorld } from '../world/types.ts';
import type { EmitterParameters } from './options.ts';
import type { Block } from './pool.ts';

/** A source of particles and the pool of entities they live in. */
export interface Emitter {
  readonly world: PhysicsWorld;
  readonly capacity: number;
  /** The entities of the pool, ascending: living particles and inert ones alike. */
  readonly ids: Uint32Array;
  /** Not for users. */
  readonly internal: EmitterInternals;
}

export interface EmitterInternals {
  readonly block: Block;
  /** The body it follows, and its id. */
  readonly followed: EntityRef | undefined;
  readonly entity: number;
  parameters: EmitterParameters;
  /** Where bursts wait for the next step, twelve numbers each. */
  readonly bursts: Float64Array;
  /** What was reported last, once somebody asked; the same object every time. */
  endings: { count: number; readonly ids: Uint32Array; readonly states: Float64Array } | undefined;
  /** The world's version of membership when the pool was last found complete. */
  membership: number;
  destroyed: boolean;
  /** How often the world had been restored when it was last seen to have this emitter. */
  timeline: number;
}
