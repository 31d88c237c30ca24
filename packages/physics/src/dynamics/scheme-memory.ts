// State that a scheme keeps between steps: vectors of each body, and the length of the step.
import { allocateTogether } from '../memory/arena.ts';
import { type AxisAddresses, axisColumns } from '../memory/columns.ts';
import { namedResource } from '../memory/resource.ts';
import type { PhysicsWorld, Scheme } from '../world/types.ts';

/** Columns that a scheme keeps between steps, and the length of the last step. */
export interface SchemeMemory {
  readonly columns: Readonly<AxisAddresses>[];
  tick: number;
  dt: number;
  last: number;
}

const memories = namedResource('scheme memories', (): Map<string, SchemeMemory> => new Map());

export function schemeMemory(world: PhysicsWorld, scheme: Scheme): SchemeMemory {
  const existing = memories(world).get(scheme.structure);
  if (existing !== undefined) return existing;
  const { internal, kernels, precision, rows } = world;
  const columns = allocateTogether(internal.arena, kernels.findPage, () =>
    scheme.memory.map((_, i) => axisColumns(internal.arena, precision, rows, `memory ${i}`)[1]),
  );
  const made = { columns, tick: -1, dt: 0, last: 0 };
  memories(world).set(scheme.structure, made);
  return made;
}

/** Returns the length of the previous step if it was the world's last and of this scheme, otherwise 0. */
export function lastStepOf(world: PhysicsWorld, scheme: Scheme, dt: number): number {
  if (scheme.memory.length === 0) return 0;
  const memory = schemeMemory(world, scheme);
  if (memory.tick !== world.tick) {
    memory.last = memory.tick === world.tick - 1 ? memory.dt : 0;
    memory.tick = world.tick;
    memory.dt = dt;
  }
  return memory.last;
}
