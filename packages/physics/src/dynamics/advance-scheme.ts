// Steps of a scheme where some force is no law: the scheme is cut at each evaluation of the forces into pieces. A piece
// is a loop that moves the bodies to the state at which the forces are asked for next, and keeps in scratch columns what
// later pieces need.
import type { CompiledLoop, Loop } from '../laws/compile.ts';
import type { LoopSource, Store } from '../laws/emit-loop.ts';
import { Lowering } from '../laws/lower.ts';
import type { Node } from '../laws/node.ts';
import type { StageData } from '../laws/scheme.ts';
import { type Axes, eachAxis, zeroVector } from '../laws/vector-algebra.ts';
import { realColumn } from '../memory/columns.ts';
import { resource } from '../memory/resource.ts';
import { keptWithPlan } from '../world/execution-plan.ts';
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
  /** The pieces: one more than there are evaluations. */
  readonly pieces: readonly Loop[];
}

/** Columns for what pieces hand on: those of the scratch first, then others, which the next scheme uses again. */
const handedOn = resource(({ scratch: { at } }): number[] =>
  [at.stage1, at.stage2].flatMap(({ x, y, z }) => [x, y, z]),
);

/** The loops of a world whose integrator has fixed stages and whose forces are not all laws. */
export const schemeLoops = keptWithPlan((world): SchemeLoops => {
  const scheme = world.integrator.scheme as Scheme;
  const block = new ParameterBlock(world, [scheme], scheme.stages);
  const memory = schemeMemory(world, scheme);
  const sources = cutScheme(new WorldColumns(world, block, () => scheme), scheme, memory);
  const key = JSON.stringify(['pieces', layoutOf(world, block), handedOn(world), memory.columns, scheme.structure]);
  const variant = JSON.stringify(variantOf(scheme));
  const loops = sources.map((source, i) => makeWorldLoop(world, `${key} ${i} ${variant}`, () => source));
  return { block, compiled: loops.map(({ compiled }) => compiled), pieces: loops.map(({ run }) => run) };
});

/** Moves all bodies by one step. */
export function advanceScheme(world: PhysicsWorld, ranges: Ranges, dt: number): void {
  const { block, pieces } = schemeLoops(world);
  const { stages } = world.integrator.scheme as Scheme;
  block.write(dt, world.time, lastStepOf(world, world.integrator.scheme as Scheme, dt));
  for (let p = 0; p < pieces.length; p++) {
    for (let r = 0; r < ranges.count; r++) pieces[p](ranges.bounds[2 * r], ranges.bounds[2 * r + 1], 0);
    if (p < stages.length) evaluateForces(world, ranges, world.time + stages[p] * dt);
  }
}

/** The pieces of a scheme as arithmetic. */
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
      // A column of its own for each evaluation, as far as the graph knows: the forces there are others each time.
      const force = eachAxis((i) => graph.make('real', [], forceColumn(world, stage, i)));
      forces[stage] = [...force];
      // What stands in the force columns comes from anybody: only bodies that forces move must feel it.
      const felt = eachAxis((i) => graph.make('keep', [columns.isMovable, force[i]]));
      const flat: Axes = world.dimensions === 2 ? [felt[0], felt[1], graph.zero] : felt;
      return velocityChange(columns, { force: flat, acceleration: none, torque: none }, duration);
    },
  });
  const end = { position: lowering.vector(scheme.position), velocity: lowering.vector(scheme.velocity) };
  const kept = scheme.memory.map((vector) => lowering.vector(vector));
  const put = (to: Readonly<Record<'x' | 'y' | 'z', number>>, values: Axes): Store[] =>
    columns.axisNames.map((axis, i) => ({ address: to[axis], node: values[i] }));
  const roots = [...stages, end].map(({ position, velocity }, p) => [
    ...put(addresses.Position, position),
    ...put(addresses.Velocity, velocity),
    ...(p < stages.length ? [] : kept.flatMap((vector, i) => put(memory.columns[i], vector))),
  ]);
  return cut(
    columns,
    roots,
    forces.map((nodes) => new Set(nodes)),
  );
}

/** The force column as the evaluation `stage` leaves it: an address that differs from stage to stage. */
function forceColumn({ scratch }: PhysicsWorld, stage: number, axis: number): number {
  return scratch.at.force['xyz'[axis] as 'x'] + stage / 1024;
}

/** Divides the work among the pieces: each node is computed in the first piece that can, and handed on if it is needed later. */
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
      level = node.args.reduce((most, arg) => Math.max(most, levelOf(arg)), stage + 1);
      levels.set(node, level);
    }
    return level;
  };
  const columns = handedOn(world);
  const places = new Map<Node, number>();
  const extra: Store[][] = roots.map(() => []);
  // What a later piece reads of an earlier one: a column where the earlier one left it.
  const handOn = (node: Node): Node => {
    let place = places.get(node);
    if (place === undefined) {
      place = places.size;
      places.set(node, place);
      columns[place] ??= realColumn(world.internal.arena, world.precision, world.rows, 'a stage of the integrator')[1];
      extra[levelOf(node)].push({ address: columns[place], node });
    }
    return graph.make('real', [], columns[place]);
  };
  const moved = roots.map((stores, piece) => {
    const done = new Map<Node, Node>();
    const rewrite = (node: Node): Node => {
      let made = done.get(node);
      if (made === undefined) {
        made = rewriteNode(node);
        done.set(node, made);
      }
      return made;
    };
    const rewriteNode = (node: Node): Node => {
      const isForce = forces.some((nodes) => nodes.has(node));
      if (isForce && levelOf(node) === piece) return graph.make('real', [], Math.floor(node.value));
      if (node.args.length === 0 && !isForce) return node;
      if (levelOf(node) < piece && levelOf(node) > 0 && !node.isUniform) {
        // The state at which the forces were asked for stands in the columns of the bodies.
        const left = roots[piece - 1].find((store) => store.node === node);
        return left === undefined ? handOn(node) : graph.make('real', [], left.address);
      }
      return graph.make(node.op, node.args.map(rewrite), node.value, node.over ?? node.scope);
    };
    return { rewrite, stores: stores.map(({ address, node }) => ({ address, node: rewrite(node) })) };
  });
  // From the last piece to the first: what is handed on may need what was handed on before.
  const kept: Store[][] = [];
  for (let piece = roots.length - 1; piece >= 0; piece--) {
    kept[piece] = extra[piece].map(({ address, node }) => ({ address, node: moved[piece].rewrite(node) }));
  }
  const { precision } = world;
  return moved.map(({ stores }, piece) => ({
    name: 'piece',
    types: { stored: precision, computed: precision },
    stores: [...stores, ...kept[piece]],
    noteOf: notesOf(world, block),
  }));
}
