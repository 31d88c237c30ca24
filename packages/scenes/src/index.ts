/** Scenes: pure functions that build a world from a seed and parameters. */
export { attractors } from './attractors';
export { type BouncingBalls, ballDrag, bouncingBalls } from './bouncing-balls';
export { circles } from './circles';
export { cloth } from './cloth';
export { emitters, type Sparks } from './emitters';
export { type GasRun, gas } from './gas';
export { particles } from './particles';
export { findScene, SCENES } from './registry';
export { rope } from './rope';
export type { Scene, SceneOptions, SceneParameter, SceneRun } from './scene';
export { springs } from './springs';
