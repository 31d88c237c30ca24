/** Scenes: pure functions that build a world from a seed and parameters. */
export { attractors } from './attractors.ts';
export { type BlackHole, blackHole } from './black-hole.ts';
export { findCorridor, isClear } from './black-hole-corridor.ts';
export { BLACK_HOLE, drawHoles, holeMu, holePosition } from './black-hole-layout.ts';
export type { Hole } from './black-hole-types.ts';
export { type BouncingBalls, ballDrag, bouncingBalls } from './bouncing-balls.ts';
export type { BoxedRun } from './boxed-run.ts';
export { circles } from './circles.ts';
export { cloth } from './cloth.ts';
export { isOutside, type Region, type RegionCorner, relaunchOutside, removeOutside, wrapAround } from './edges.ts';
export { emitters, type Sparks } from './emitters.ts';
export { STAR_COLORS, STAR_RGB, type StarColor } from './fireworks/colors.ts';
export { MAX_TEXT_STARS, TEXT_STRIDE } from './fireworks/letters.ts';
export type { EventRing, FireworksEvent } from './fireworks/news.ts';
export type { ShellOrder } from './fireworks/rockets.ts';
export { heldStars, maxHoldSeconds, SHELL_NAMES, SHELLS, type ShellForm, type ShellKind } from './fireworks/shells.ts';
export { FIREWORKS_REACH, FIREWORKS_SKY, type Fireworks, fireworks } from './fireworks.ts';
export { gas } from './gas.ts';
export { InputLog, type LoggedInput } from './input-log.ts';
export { molecules } from './molecules.ts';
export { type ClusterRun, nbodyDirect, nbodyTree } from './n-body/cluster.ts';
export { galaxy } from './n-body/galaxy.ts';
export { type PlasmaRun, plasma } from './n-body/plasma.ts';
export { type Particles, particles } from './particles.ts';
export { findScene, SCENES } from './registry.ts';
export { chains } from './rigid/chains.ts';
export { crowd } from './rigid/crowd.ts';
export { discs } from './rigid/discs.ts';
export { elasticDiscs } from './rigid/elastic-discs.ts';
export { jointGrid } from './rigid/joint-grid.ts';
export { manyPyramids } from './rigid/many-pyramids.ts';
export { pyramid } from './rigid/pyramid.ts';
export type { RigidRun } from './rigid/rigid-scene.ts';
export { smash } from './rigid/smash.ts';
export { spinner } from './rigid/spinner.ts';
export { tumbler } from './rigid/tumbler.ts';
export { washer } from './rigid/washer.ts';
export { rope } from './rope.ts';
export type { ReferenceRuns, Scene, SceneOptions, SceneParameter, SceneRun, Stretch } from './scene.ts';
export {
  buildSolarSystem,
  type SolarEpoch,
  type SolarState,
  type SolarSystem,
  type SolarSystemOptions,
  solarState,
} from './solar-system/build.ts';
export { type Checkpoint, checkpoints } from './solar-system/checkpoints.ts';
export { advanceTo, type ErrorsKm, type ErrorTable, errorsAt, measureErrors } from './solar-system/errors.ts';
export { type SkyEvent, SkyEventFinder, type SkyEventKind } from './solar-system/sky-events.ts';
export {
  ASTRONOMICAL_UNIT,
  BODY_NAMES,
  type BodyName,
  EPOCH,
  SPEED_OF_LIGHT,
  STATES as SOLAR_STATES,
} from './solar-system/states.ts';
export { EPOCH_2012 } from './solar-system/states-2012.ts';
export { type SolarSystemRun, solarSystem } from './solar-system.ts';
export { springs } from './springs.ts';
export { teleport } from './teleport.ts';
