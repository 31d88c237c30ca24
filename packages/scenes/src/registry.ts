import { attractors } from './attractors.ts';
import { blackHole } from './black-hole.ts';
import { bouncingBalls } from './bouncing-balls.ts';
import { circles } from './circles.ts';
import { cloth } from './cloth.ts';
import { emitters } from './emitters.ts';
import { fireworks } from './fireworks.ts';
import { gas } from './gas.ts';
import { molecules } from './molecules.ts';
import { nbodyDirect, nbodyTree } from './n-body/cluster.ts';
import { galaxy } from './n-body/galaxy.ts';
import { plasma } from './n-body/plasma.ts';
import { particles } from './particles.ts';
import { chains } from './rigid/chains.ts';
import { crowd } from './rigid/crowd.ts';
import { discs } from './rigid/discs.ts';
import { elasticDiscs } from './rigid/elastic-discs.ts';
import { jointGrid } from './rigid/joint-grid.ts';
import { manyPyramids } from './rigid/many-pyramids.ts';
import { pyramid } from './rigid/pyramid.ts';
import { smash } from './rigid/smash.ts';
import { spinner } from './rigid/spinner.ts';
import { tumbler } from './rigid/tumbler.ts';
import { washer } from './rigid/washer.ts';
import { rope } from './rope.ts';
import type { Scene } from './scene.ts';
import { solarSystem } from './solar-system.ts';
import { springs } from './springs.ts';

/** All scenes, in the order in which they are listed. */
export const SCENES: readonly Scene[] = [
  particles,
  emitters,
  circles,
  gas,
  springs,
  rope,
  cloth,
  attractors,
  nbodyDirect,
  nbodyTree,
  galaxy,
  plasma,
  molecules,
  pyramid,
  manyPyramids,
  discs,
  smash,
  elasticDiscs,
  jointGrid,
  chains,
  tumbler,
  spinner,
  washer,
  crowd,
  bouncingBalls,
  blackHole,
  fireworks,
  solarSystem,
];

/** The scene with this name, if there is one. */
export function findScene(name: string): Scene | undefined {
  return SCENES.find((scene) => scene.name === name);
}
