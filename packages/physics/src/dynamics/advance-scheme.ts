// Runs a fixed-stage scheme if some force is not a law. The scheme is split at each force evaluation: each segment is a
// loop that moves the bodies to the state of the next evaluation, and stores intermediate values for later segments in
// scratch columns.
import type { CompiledLoop, Loop } from '../laws/compile.ts';
import type { LoopSource, Store } from '../laws/emit-loop.ts';
import { Lowering } from '../laws/lower.ts';
import type { Node } from '../laws/node.ts';
import type { StageData } from '../laws/scheme.ts';
import { type Axes, eachAxis, zeroVector } from '../laws/vector-algebra.ts';
import { realColumn } from '../memory/columns.ts';
import { resource } from '../memory/resource.ts';
import { cachedWithPlan } from '../world/execution-plan.ts';
import type { PhysicsWorld, Ranges, Scheme } from '../world/types.ts';
import { evaluateForces } from './evaluate-forces.ts';
import { layoutOf } from './layout.ts';
import { notesOf } from './notes.ts';
import { ParameterBlock, variantOf } from './parameter-block.ts';
import { lastStepOf, type SchemeMemory, schemeMemory } from './scheme-memory.ts';
import { velocityChange } from './sum-of-laws.ts';
import { WorldColumns } from './world-columns.ts';
import { makeWorldLoop } from './world-loop.ts';

interface SchemeLoops {
  readonly compiled: readonly CompiledLoop[];
  readonly block: ParameterBlock;
  /** The segments: one more than the evaluations. */
  readonly segments: readonly Loop[];
}

/** Columns for intermediate values: those of the scratch first, then additional ones, which later schemes reuse. */
const intermediateColumns = resource(({ scratch: { at } }): number[] =>
  [at.stage1, at.stage2].flatMap(({ x, y, z }) => [x, y, z]),
);

/** The loops of a world whose integrator has fixed stages and whose forces are not all laws. */
export const schemeLoops = cachedWithPlan((world): SchemeLoops => {
  const scheme = world.integrator.scheme as Scheme;
  const block = new ParameterBlock(world, [scheme], scheme.stages);
  const memory = schemeMemory(world, scheme);
  const sources = cutScheme(new WorldColumns(world, block, () => scheme), scheme, memory);
  const key = JSON.stringify([
    'pieces',
    layoutOf(world, block),
    intermediateColumns(world),
    memory.columns,
    scheme.structure,
  ]);
  const variant = JSON.stringify(variantOf(scheme));
  const loops = sources.map((source, i) => makeWorldLoop(world, `${key} ${i} ${variant}`, () => source));
  return { block, compiled: loops.map(({ compiled }) => compiled), segments: loops.map(({ run }) => run) };
});

/** Advances all bodies by one step. */
export function advanceScheme(world: PhysicsWorld, ranges: Ranges, dt: number): void {
  const { block, segments } = schemeLoops(world);
  const { stages } = world.integrator.scheme as Scheme;
  block.write(dt, world.time, lastStepOf(world, world.integrator.scheme as Scheme, dt));
  for (let p = 0; p < segments.length; p++) {
    for (let r = 0; r < ranges.count; r++) segments[p](ranges.bounds[2 * r], ranges.bounds[2 * r + 1], 0);
    if (p < stages.length) evaluateForces(world, ranges, world.time + stages[p] * dt);
  }
}

/** Builds the arithmetic of the segments of a scheme. */
function cutScheme(columns: WorldColumns, scheme: Scheme, memory: SchemeMemory): LoopSource[] {
  const { graph, world } = columns;
  const { addresses, previousAddresses, scratch } = world;
  const stages: { readonly position: Axes; readonly velocity: Axes }[] = [];
  const forces: Node[][] = [];
  const none = zeroVector(graph);
  const vectors: Record<string, Axes> = {
    position: columns.axes(previousAddresses.Position),
    velocity: columns.axes(scratch.at.startVelocity),
  };
  memory.columns.forEach((at, i) => {
    vectors[`memory${i}`] = columns.axes(at);
  });
  const lowering = new Lowering(graph, {
    ...columns.environment(scheme, vectors, columns.timeAt(0), 0),
    scalars: {
      mass: columns.mass,
      charge: graph.make('real', [], addresses.Charge.value),
      lastDt: columns.load(columns.block.lastDt),
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
  const memoryValues = scheme.memory.map((vector) => lowering.vector(vector));
  const storesTo = (to: Readonly<Record<'x' | 'y' | 'z', number>>, values: Axes): Store[] =>
    columns.axisNames.map((axis, i) => ({ address: to[axis], node: values[i] }));
  const roots = [...stages, end].map(({ position, velocity }, p) => [
    ...storesTo(addresses.Position, position),
    ...storesTo(addresses.Velocity, velocity),
    ...(p < stages.length ? [] : memoryValues.flatMap((vector, i) => storesTo(memory.columns[i], vector))),
  ]);
  return cut(
    columns,
    roots,
    forces.map((nodes) => new Set(nodes)),
  );
}

/** A symbolic address for the force column after evaluation `stage`; it differs between stages. */
function forceColumn({ scratch }: PhysicsWorld, stage: number, axis: number): number {
  return scratch.at.force['xyz'[axis] as 'x'] + stage / 1024;
}

/** Assigns each node to the first segment that can compute it, and stores its value if a later segment needs it. */
function cut(
  { graph, world, block }: WorldColumns,
  roots: readonly Store[][],
  forces: readonly ReadonlySet<Node>[],
): LoopSource[] {
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
  const columns = intermediateColumns(world);
  const indices = new Map<Node, number>();
  const extra: Store[][] = roots.map(() => []);
  // Replaces a value of an earlier segment by the column that stores it.
  const storeForLater = (node: Node): Node => {
    let index = indices.get(node);
    if (index === undefined) {
      index = indices.size;
      indices.set(node, index);
      columns[index] ??= realColumn(world.internal.arena, world.precision, world.rows, 'a stage of the integrator')[1];
      extra[levelOf(node)].push({ address: columns[index], node });
    }
    return graph.make('real', [], columns[index]);
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
      if (node.args.length === 0 && !isForce) return node;
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
    stores: [...stores, ...memoryValues[segment]],
    noteOf: notesOf(world, block),
  }));
}
