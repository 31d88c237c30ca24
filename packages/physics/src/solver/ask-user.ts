// Pairs about which a function of the user decides.
import { rigidKernels } from '../collision/kernels.ts';
import { collectThrown } from '../errors/collect-thrown.ts';
import { RigidTableWord as Word } from '../memory/layouts.gen.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { rigidTable } from './rigid-table.ts';

/** Whether two entities with shapes may collide: false keeps them apart from each other's contacts until they part. */
export type ShouldCollide = (world: PhysicsWorld, a: number, b: number) => boolean;

/** Asks about the pairs that began in this step. A pair for which the function throws collides. */
export function askAboutPairs(world: PhysicsWorld, shouldCollide: ShouldCollide): void {
  const { at, words } = rigidTable(world);
  const kernels = rigidKernels(world);
  for (let i = 0; i < words[Word.newPairCount]; i++) {
    try {
      if (shouldCollide(world, kernels.newPair(at, i, 0), kernels.newPair(at, i, 1)) === false)
        kernels.ignorePair(at, i);
    } catch (error) {
      collectThrown(world, error);
    }
  }
}
