// State that a scheme keeps between steps: vectors of each body, whose they are, and the length of the step.
//
// A row keeps its vectors when its body is removed. So that no later body of the row starts with them, the row also keeps the
// number of its body: the generation, plus 1, or 0 if it had no body that forces move.

import type { Store } from '../laws/loop-source.ts';
import type { Node } from '../laws/node.ts';
import { type Axes, eachAxis } from '../laws/vector-algebra.ts';
import { allocateTogether } from '../memory/arena.ts';
import { type AxisAddresses, axisColumns, realColumn } from '../memory/columns.ts';
import { namedResource } from '../memory/resource.ts';
import type { PhysicsWorld, Scheme } from '../world/types.ts';
import type { WorldColumns } from './world-columns.ts';

/** Columns that a scheme keeps between steps. */
export interface MemoryColumns {
  readonly vectors: readonly Readonly<AxisAddresses>[];
  /** The number of the body whose vectors they are, unless the scheme finds out by itself. */
  readonly body: number | undefined;
}

/** Columns that a scheme keeps between steps, and the length of the last step. */
export interface SchemeMemory {
  readonly columns: MemoryColumns | undefined;
  tick: number;
  dt: number;
  last: number;
}

const memories = namedResource('scheme memories', (): Map<string, SchemeMemory> => new Map());

export function schemeMemory(world: PhysicsWorld, scheme: Scheme): SchemeMemory {
  const existing = memories(world).get(scheme.structure);
  if (existing !== undefined) return existing;
  const { internal, kernels, precision, rows } = world;
  const { arena } = internal;
  const allocateColumns = (): MemoryColumns => ({
    vectors: scheme.memory.map((_, i) => axisColumns(arena, precision, rows, `memory ${i}`)[1]),
    body: scheme.findsNewBodies ? undefined : realColumn(arena, precision, rows, 'bodies of the memory')[1],
  });
  const columns = scheme.memory.length === 0 ? undefined : allocateTogether(arena, kernels.findPage, allocateColumns);
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

/** What a scheme knows of the last step of a body. */
export interface LastStep {
  /** Its length, or 0 if forces did not move the body in the world's last step with this scheme. */
  readonly lastDt: Node;
  /** The vectors that it left, or zeros. */
  readonly memory: readonly Axes[];
  /** What the row keeps beside them. */
  readonly body: Node | undefined;
}

/** Lowers the last step of a body. */
export function lastStepNodes(columns: WorldColumns, { vectors, body }: MemoryColumns): LastStep {
  const { graph, world, block } = columns;
  if (body === undefined) {
    return { lastDt: columns.load(block.lastDt), memory: vectors.map((at) => columns.axes(at)), body: undefined };
  }
  const generation = graph.make('word', [], world.internal.generations.byteOffset);
  const present = graph.make('add', [generation, graph.constant(1)]);
  const isSame = graph.make('equal', [graph.make('real', [], body), present]);
  const lastDt = graph.make('keep', [isSame, columns.load(block.lastDt)]);
  const hasLast = graph.make('less', [graph.constant(0), lastDt]);
  const memory = vectors.map((at) => {
    const kept = columns.axes(at);
    return eachAxis((i) => graph.make('keep', [hasLast, kept[i]]));
  });
  return { lastDt, memory, body: graph.make('keep', [columns.isMovable, present]) };
}

/** What a loop stores for the next step. */
export function keptStores(
  columns: WorldColumns,
  at: MemoryColumns,
  body: LastStep['body'],
  vectors: readonly Axes[],
): Store[] {
  const stores = vectors.flatMap((vector, v) =>
    columns.axisNames.map((axis, i) => ({ address: at.vectors[v][axis], node: vector[i] })),
  );
  return at.body === undefined || body === undefined ? stores : [...stores, { address: at.body, node: body }];
}
