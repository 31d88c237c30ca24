// Splits the arithmetic of a scheme at its force evaluations into loops that run one after the other.
import type { LoopSource, Store } from '../laws/loop-source.ts';
import { Lowering } from '../laws/lower.ts';
import type { Node } from '../laws/node.ts';
import type { StageData } from '../laws/scheme.ts';
import { type Axes, eachAxis, zeroVector } from '../laws/vector-algebra.ts';
import { realColumn } from '../memory/columns.ts';
import { namedResource } from '../memory/resource.ts';
import type { PhysicsWorld, Scheme } from '../world/types.ts';
import { rangeTests } from './loop-checks.ts';
import { notesOf } from './notes.ts';
import { type KeptColumns, keptStores, lowerLastStep } from './scheme-memory.ts';
import { velocityChange } from './sum-of-laws.ts';
import type { WorldColumns } from './world-columns.ts';

/** Columns for intermediate values: those of the scratch first, then additional ones, which later schemes reuse. */
export const intermediateColumns = namedResource('intermediate columns', ({ scratch: { at } }): number[] =>
  [at.stage1, at.stage2].flatMap(({ x, y, z }) => [x, y, z]),
);

/** Builds the arithmetic of the segments of a scheme. */
export function cutScheme(columns: WorldColumns, scheme: Scheme, memory: KeptColumns): LoopSource[] {
  const { graph, world } = columns;
  const { addresses, previousAddresses, scratch } = world;
  const stages: { readonly position: Axes; readonly velocity: Axes }[] = [];
  const forces: Node[][] = [];
  const none = zeroVector(graph);
  const start = { position: columns.axes(addresses.Position), velocity: columns.axes(addresses.Velocity) };
  const vectors: Record<string, Axes> = { ...start };
  const last = lowerLastStep(columns, scheme, memory);
  last.memory.forEach((vector, i) => {
    vectors[`memory${i}`] = vector;
  });
  const lowering = new Lowering(graph, {
    ...columns.environment(scheme, vectors, columns.timeAt(0), 0),
    scalars: {
      mass: columns.mass,
      charge: graph.make('real', [], addresses.Charge.value),
      lastDt: last.lastDt,
    },
    kick(position, velocity, duration, { stage }: StageData) {
      stages[stage] = { position, velocity };
      // The graph treats the force columns of each evaluation as distinct columns, because their values differ.
      const force = eachAxis((i) => graph.make('real', [], forceColumn(world, stage, i)));
      forces[stage] = [...force];
      // User code may write any value to the force columns, so the force is masked to the bodies that forces move.
      const maskedForce = eachAxis((i) => graph.make('keep', [columns.isMovable, force[i]]));
      const flat: Axes = world.dimensions === 2 ? [maskedForce[0], maskedForce[1], graph.zero] : maskedForce;
      return velocityChange(columns, { force: flat, acceleration: none, torque: none }, duration);
    },
  });
  const end = { position: lowering.vector(scheme.position), velocity: lowering.vector(scheme.velocity) };
  const memoryVectors = scheme.memory.map((vector) => lowering.vector(vector));
  const storesTo = (to: Readonly<Record<'x' | 'y' | 'z', number>>, values: Axes): Store[] =>
    columns.axisNames.map((axis, i) => ({ address: to[axis], node: values[i] }));
  const saved = [
    ...storesTo(previousAddresses.Position, start.position),
    ...storesTo(scratch.at.startVelocity, start.velocity),
  ];
  const roots = [...stages, end].map(({ position, velocity }, p) => [
    ...storesTo(addresses.Position, position),
    ...storesTo(addresses.Velocity, velocity),
    ...(p > 0 ? [] : saved),
    ...(p < stages.length ? [] : keptStores(columns, memory, last.body, memoryVectors)),
  ]);
  return cut(
    columns,
    roots,
    forces.map((nodes) => new Set(nodes)),
    new Map(saved.map(({ address, node }) => [node, graph.make('real', [], address)])),
  );
}

/** A symbolic address for the force column after evaluation `stage`; it differs between stages. */
function forceColumn({ scratch }: PhysicsWorld, stage: number, axis: number): number {
  return scratch.at.force['xyz'[axis] as 'x'] + stage / 1024;
}

/**
 * Assigns each node to the first segment that can compute it, and stores its value if a later segment needs it.
 * @param saved for the state at the start of the step, where the first segment saves it
 */
function cut(
  columns: WorldColumns,
  roots: readonly Store[][],
  forces: readonly ReadonlySet<Node>[],
  saved: ReadonlyMap<Node, Node>,
): LoopSource[] {
  const { graph, world, block } = columns;
  const levelOf = levelsAfter(forces);
  const intermediate = intermediateColumns(world);
  const indices = new Map<Node, number>();
  const extra: Store[][] = roots.map(() => []);
  // Replaces a value of an earlier segment by the column that stores it.
  const storeForLater = (node: Node): Node => {
    let index = indices.get(node);
    if (index === undefined) {
      index = indices.size;
      indices.set(node, index);
      intermediate[index] ??= realColumn(
        world.internal.arena,
        world.precision,
        world.rows,
        'a stage of the integrator',
      )[1];
      extra[levelOf(node)].push({ address: intermediate[index], node });
    }
    return graph.make('real', [], intermediate[index]);
  };
  const segments = roots.map((stores, segment) => {
    const done = new Map<Node, Node>();
    const rewrite = (node: Node): Node => {
      let rewritten = done.get(node);
      if (rewritten === undefined) {
        rewritten = rewriteNode(node);
        done.set(node, rewritten);
      }
      return rewritten;
    };
    const rewriteNode = (node: Node): Node => {
      const isForce = forces.some((nodes) => nodes.has(node));
      if (isForce && levelOf(node) === segment) return graph.make('real', [], Math.floor(node.value));
      if (node.args.length === 0 && !isForce) return (segment > 0 && saved.get(node)) || node;
      if (levelOf(node) < segment && levelOf(node) > 0 && !node.isUniform) {
        // The state of the evaluation is in the bodies' own columns.
        const existing = roots[segment - 1].find((store) => store.node === node);
        return existing === undefined ? storeForLater(node) : graph.make('real', [], existing.address);
      }
      return graph.make(node.op, node.args.map(rewrite), node.value, node.over ?? node.scope);
    };
    return { rewrite, stores: stores.map(({ address, node }) => ({ address, node: rewrite(node) })) };
  });
  // Segments are processed from last to first, because a stored value may depend on values stored earlier.
  const memoryValues: Store[][] = [];
  for (let segment = roots.length - 1; segment >= 0; segment--) {
    memoryValues[segment] = extra[segment].map(({ address, node }) => ({
      address,
      node: segments[segment].rewrite(node),
    }));
  }
  const { precision } = world;
  return segments.map(({ stores }, segment) => ({
    name: 'piece',
    types: { stored: precision, computed: precision },
    stores: [...stores, ...memoryValues[segment]].filter((store) => !leavesUnchanged(store)),
    noteOf: notesOf(world, block),
    ...testsOf(columns, segment === 0 ? [...saved.keys()] : stores.map(({ node }) => node)),
  }));
}

/** Tests positions and velocities, which are the first of the values: the state before the first segment, and after the others. */
function testsOf(columns: WorldColumns, values: readonly Node[]): ReturnType<typeof rangeTests> {
  const axes = columns.axisNames.length;
  return rangeTests(columns, { position: values.slice(0, axes), velocity: values.slice(axes, 2 * axes) });
}

/** Returns a function that finds the first segment that can compute a node: the one after the last force it depends on. */
function levelsAfter(forces: readonly ReadonlySet<Node>[]): (node: Node) => number {
  const levels = new Map<Node, number>();
  const levelOf = (node: Node): number => {
    let level = levels.get(node);
    if (level === undefined) {
      const stage = forces.findIndex((nodes) => nodes.has(node));
      level = node.args.reduce((max, arg) => Math.max(max, levelOf(arg)), stage + 1);
      levels.set(node, level);
    }
    return level;
  };
  return levelOf;
}

function leavesUnchanged({ address, node }: Store): boolean {
  return node.op === 'real' && node.value === address;
}
