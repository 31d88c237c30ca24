/** Scenes: pure functions that build a world from a seed and parameters. */
export { attractors } from './attractors';
export { type BlackHole, blackHole } from './black-hole';
export { findCorridor, isClear } from './black-hole-corridor';
export { BLACK_HOLE, drawHoles, type Hole, holeMu, holePlace } from './black-hole-layout';
export { type BouncingBalls, ballDrag, bouncingBalls } from './bouncing-balls';
export { circles } from './circles';
export { cloth } from './cloth';
export { emitters, type Sparks } from './emitters';
export { type GasRun, gas } from './gas';
export { InputLog, type LoggedInput } from './input-log';
export { type ClusterRun, nbodyDirect, nbodyTree } from './n-body/cluster';
export { galaxy } from './n-body/galaxy';
export { particles } from './particles';
export { findScene, SCENES } from './registry';
export { rope } from './rope';
export type { Scene, SceneOptions, SceneParameter, SceneRun } from './scene';
export { springs } from './springs';
