import type { PhysicsWorld } from '../world';

/** Fills a new world's phases: which systems run, in which order. */
export type Preset = (world: PhysicsWorld) => void;
