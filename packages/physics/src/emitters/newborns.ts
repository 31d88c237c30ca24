// What forces did to particles between their birth and the step at which they appear (kernels/emitters/newborns.ts).
import { beginLocalForces, evaluateLocalForces } from '../dynamics/evaluate-local.ts';
import type { MemoryRecord } from '../memory/record.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { emitterKernels } from './kernels.ts';
import { W } from './record.ts';

/** Moves the particles that an emitter made in this step by the forces since their birth. */
export function advanceNewborns(world: PhysicsWorld, { at, words }: MemoryRecord): void {
  if (words[W.newborns] === 0) return;
  const kernels = emitterKernels(world);
  kernels.findNewborns(at);
  let first = kernels.nextNewborns(at);
  if (first < 0 || !beginLocalForces(world)) return;
  for (; first >= 0; first = kernels.nextNewborns(at)) evaluateLocalForces(world, first, words[W.newbornEnd]);
  const { x, y, z } = world.scratch.at.force;
  kernels.advanceNewborns(at, x, y, z);
}
