import type { Precision } from '../kernels/instantiate.ts';
import type { PhysicsWorld } from '../world/create-world.ts';

/** Fills a new world's phases: which systems run, in which order. */
export interface Preset {
  (world: PhysicsWorld): void;
  /** Memory its features need, bytes an entity: what a world then has by default in place of 256. */
  readonly bytesPerEntity?: (dimensions: 2 | 3, precision: Precision) => number;
}
