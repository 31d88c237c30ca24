// The scheme of a world with all laws as a loop whose steps are of another length for each body: the way of a body to its
// impact and from there to the end of the step.
//
// It starts from the scratch columns `stage1` (position) and `stage2` (velocity), lasts what the column `force.x` says, and
// leaves its result where it started. Schemes that are one loop with all laws use none of these columns. Forces that change
// with time are those of the time in the parameter block, which is one body's: where there are such, bodies are run one by
// one. `dt` in a law is the whole step, because noise is drawn once for that.
import type { RealColumn } from '../components/define.ts';
import type { Loop } from '../laws/compile.ts';
import type { LoopSource, Store } from '../laws/loop-source.ts';
import { readsMotion, readsTime } from '../laws/structure.ts';
import { AXES } from '../memory/axes.ts';
import { cachedWithPlan } from '../world/execution-plan.ts';
import type { Scheme } from '../world/types.ts';
import { layoutOf } from './layout.ts';
import { notesOf } from './notes.ts';
import { ParameterBlock, type ParameterOwner, variantOf } from './parameter-block.ts';
import { lowerScheme, ownersOf } from './step-loop.ts';
import { type LawForce, lawsOf } from './sum-of-laws.ts';
import { WorldColumns } from './world-columns.ts';
import { makeWorldLoop } from './world-loop.ts';

/** The loop, and views of the columns from which it starts. */
export interface ImpactLoop {
  readonly run: Loop;
  readonly block: ParameterBlock;
  readonly position: readonly RealColumn[];
  readonly velocity: readonly RealColumn[];
  readonly duration: RealColumn;
  /** Whether forces change with time, so that the block must have the time of the body. */
  readonly isTimed: boolean;
}

/**
 * The loop of a world's bodies at walls; undefined where the acceleration of the step is that of before and after an impact,
 * as under uniform gravity, or where the scheme has no higher order than that comes to.
 */
export const impactLoop = cachedWithPlan((world): ImpactLoop | undefined => {
  const { integrator, internal, scratch, dimensions, memory, precision, rows } = world;
  const scheme = integrator.scheme as Scheme;
  const laws = lawsOf(world.forces);
  // The way begins at the saved pose.
  if (internal.plan?.isStartCurrent !== true || !internal.plan.isOneLoop) return undefined;
  if (integrator.order < 2 || (integrator.velocityLag ?? 0) !== 0 || scheme.memory.length > 0) return undefined;
  const isTimed = [scheme, ...laws].some(changesInStep) || laws.some(({ law }) => readsTime(law));
  // A scheme with parameters, as Boris's, has forces of its own. The mean of a force of time alone is of second order.
  const isUneven = scheme.parameters.length > 0 || laws.some(({ law }) => readsMotion(law));
  if (!isUneven && !(isTimed && integrator.order > 2)) return undefined;
  const owners = ownersOf(scheme, laws);
  const block = new ParameterBlock(world, [...owners.values()], scheme.stages);
  const sources = [...owners.values()].map(variantOf);
  const structures = laws.map(({ law }) => law.structure);
  const key = JSON.stringify(['impact', layoutOf(world, block), scheme.structure, structures, sources]);
  const { run } = makeWorldLoop(world, key, () => impactLoopSource(block, scheme, laws, owners));
  const Column = precision === 'f32' ? Float32Array : Float64Array;
  const view = (address: number) => new Column(memory.buffer, address, rows);
  return {
    run,
    block,
    position: AXES[dimensions].map((axis) => view(scratch.at.stage1[axis])),
    velocity: AXES[dimensions].map((axis) => view(scratch.at.stage2[axis])),
    duration: view(scratch.at.force.x),
    isTimed,
  };
});

function changesInStep({ sources }: Pick<ParameterOwner, 'sources'>): boolean {
  return sources.some(({ when }) => when === 'stage');
}

function impactLoopSource(
  block: ParameterBlock,
  scheme: Scheme,
  laws: readonly LawForce[],
  owners: ReadonlyMap<object, ParameterOwner>,
): LoopSource {
  const { world } = block;
  const { stage1, stage2, force } = world.scratch.at;
  const columns = new WorldColumns(world, block, (owner) => owners.get(owner) as ParameterOwner);
  const start = {
    position: columns.axes(stage1),
    velocity: columns.axes(stage2),
    duration: columns.graph.make('real', [], force.x),
    length: columns.load(block.part),
  };
  const { position, velocity } = lowerScheme(columns, scheme, laws, { vectors: [], body: undefined }, start).result;
  const stores = columns.axisNames.flatMap((axis, i): Store[] => [
    { address: stage1[axis], node: position[i] },
    { address: stage2[axis], node: velocity[i] },
  ]);
  const { precision } = world;
  return { name: 'impact', types: { stored: precision, computed: precision }, stores, noteOf: notesOf(world, block) };
}
