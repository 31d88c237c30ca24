import { attractors } from './attractors';
import { blackHole } from './black-hole';
import { bouncingBalls } from './bouncing-balls';
import { circles } from './circles';
import { cloth } from './cloth';
import { emitters } from './emitters';
import { fireworks } from './fireworks';
import { gas } from './gas';
import { nbodyDirect, nbodyTree } from './n-body/cluster';
import { galaxy } from './n-body/galaxy';
import { plasma } from './n-body/plasma';
import { particles } from './particles';
import { rope } from './rope';
import type { Scene } from './scene';
import { solarSystem } from './solar-system';
import { springs } from './springs';

/** Every scene, in the order they are listed. */
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
  bouncingBalls,
  blackHole,
  fireworks,
  solarSystem,
];

/** The scene of a name, if there is one. */
export function findScene(name: string): Scene | undefined {
  return SCENES.find((scene) => scene.name === name);
}
