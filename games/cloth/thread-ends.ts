import { query } from 'bitecs';
import type { ClothRun } from './sim.ts';

/**
 * The two nodes, from 0, of every thread that holds, one pair after the other.
 * @param time in steps, of a film; now if undefined
 */
export function threadEnds({ world, cloth, tears }: ClothRun, time: number | undefined): readonly number[] {
  const { Spring } = world.components;
  const [first] = cloth.nodes;
  if (time === undefined) {
    return [...query(world, [Spring])].flatMap((thread) => [Spring.a[thread] - first, Spring.b[thread] - first]);
  }
  return [...tears.ends].filter((_, i) => tears.endTicks[i >> 1] > time);
}
