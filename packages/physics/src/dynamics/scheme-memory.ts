// State that a scheme keeps between steps: vectors of each body, and the length of the step.

import type { LastStep, LastStepOf } from '../laws/last-step.ts';
import type { Store } from '../laws/loop-source.ts';
import type { Node } from '../laws/node.ts';
import type { Axes } from '../laws/vector-algebra.ts';
import { allocateTogether } from '../memory/arena.ts';
import { type AxisAddresses, axisColumns, realColumn } from '../memory/columns.ts';
import { namedResource } from '../memory/resource.ts';
import type { PhysicsWorld, Scheme } from '../world/types.ts';
import type { WorldColumns } from './world-columns.ts';

/** Columns that a scheme keeps between steps, and the length of the last step. */
export interface SchemeMemory {
  readonly kept: KeptColumns;
  tick: number;
  dt: number;
  last: number;
}

/** The columns. */
export interface KeptColumns {
  readonly vectors: readonly Readonly<AxisAddresses>[];
  /** The column with the numbers of bodies, of a scheme that tells them apart. */
  readonly body: number | undefined;
}

const memories = namedResource('scheme memories', (): Map<string, SchemeMemory> => new Map());

export function schemeMemory(world: PhysicsWorld, scheme: Scheme): SchemeMemory {
  const existing = memories(world).get(scheme.structure);
  if (existing !== undefined) return existing;
  const { internal, kernels, precision, rows } = world;
  const { arena } = internal;
  const kept = allocateTogether(arena, kernels.findPage, () => ({
    vectors: scheme.memory.map((_, i) => axisColumns(arena, precision, rows, `memory ${i}`)[1]),
    body: scheme.lastStep && realColumn(arena, precision, rows, 'bodies of the memory')[1],
  }));
  const made = { kept, tick: -1, dt: 0, last: 0 };
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

/** Lowers what a scheme knows of the last step. */
export function lowerLastStep(columns: WorldColumns, { lastStep }: Scheme, memory: KeptColumns): LastStep {
  const { graph, world, block } = columns;
  const column = (address: number) => graph.make('real', [], address);
  const kept = { lastDt: columns.load(block.lastDt), memory: memory.vectors.map((at) => columns.axes(at)) };
  const body = column(memory.body ?? 0);
  if (lastStep === undefined) return { ...kept, body };
  const generation = graph.make('word', [], world.internal.generations.byteOffset);
  return (lastStep as LastStepOf)({ graph, ...kept, body, generation, isMovable: columns.isMovable });
}

/** What a loop stores for the next step. */
export function keptStores(
  { axisNames }: WorldColumns,
  at: KeptColumns,
  body: Node,
  vectors: readonly Axes[],
): Store[] {
  const stores = vectors.flatMap((vector, v) =>
    axisNames.map((axis, i) => ({ address: at.vectors[v][axis], node: vector[i] })),
  );
  return at.body === undefined ? stores : [...stores, { address: at.body, node: body }];
}
