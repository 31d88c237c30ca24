/** A program for `node --expose-gc`: prints as JSON how many bytes per step are allocated and kept on the JavaScript heap. */
import { getHeapStatistics } from 'node:v8';
import { bodies, step } from '@principia/physics';
import { chaoticWorld } from '../support/chaos.ts';

declare const gc: () => void;

const STEPS = 5000;
const world = chaoticWorld(2, 'f64');
const heap = () => getHeapStatistics().used_heap_size;

function round(): { allocated: number; kept: number } {
  gc();
  const start = heap();
  for (let i = 0; i < STEPS; i++) step(world, 1 / 60);
  const allocated = heap() - start;
  gc();
  return { allocated: allocated / STEPS, kept: (heap() - start) / STEPS };
}

// A leak shows in every round, allocations of the compiler only in some.
const rounds = [round(), round(), round(), round(), round()];
const minimum = (key: 'allocated' | 'kept') => Math.min(...rounds.map((each) => each[key]));
process.stdout.write(
  JSON.stringify({ bodies: bodies(world).count, allocated: minimum('allocated'), kept: minimum('kept') }),
);
