import { attractors } from './attractors';
import { bouncingBalls } from './bouncing-balls';
import { circles } from './circles';
import { emitters } from './emitters';
import { particles } from './particles';
import type { Scene } from './scene';
import { springs } from './springs';

/** Every scene, in the order they are listed. */
export const SCENES: readonly Scene[] = [particles, emitters, circles, springs, attractors, bouncingBalls];

/** The scene of a name, if there is one. */
export function findScene(name: string): Scene | undefined {
  return SCENES.find((scene) => scene.name === name);
}
