// The potential energy of a law, summed in f64 over all bodies that forces move.
import type { Loop } from '../laws/compile.ts';
import type { LoopSource } from '../laws/loop-source.ts';
import { Lowering } from '../laws/lower.ts';
import { zeroVector } from '../laws/vector-algebra.ts';
import { cachedWithPlan } from '../world/execution-plan.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { layoutOf } from './layout.ts';
import { notesOf } from './notes.ts';
import { ParameterBlock, variantOf } from './parameter-block.ts';
import { type LawForce, ownerOf } from './sum-of-laws.ts';
import { WorldColumns } from './world-columns.ts';
import { makeWorldLoop } from './world-loop.ts';

interface EnergyLoop {
  readonly run: Loop;
  readonly block: ParameterBlock;
}

const energyLoops = cachedWithPlan(() => new Map<LawForce, EnergyLoop>());

/** Returns the potential energy of all bodies under a law with a potential, J. */
export function potentialEnergy(world: PhysicsWorld, force: LawForce): number {
  const loops = energyLoops(world);
  let loop = loops.get(force);
  if (loop === undefined) {
    loop = makeLoop(world, force);
    loops.set(force, loop);
  }
  loop.block.write(0, world.time, 0);
  return loop.run(0, 16 * Math.ceil((world.lastId + 1) / 16), 0);
}

function makeLoop(world: PhysicsWorld, force: LawForce): EnergyLoop {
  const owner = ownerOf(force);
  const block = new ParameterBlock(world, [owner], [0]);
  const key = JSON.stringify(['energy', layoutOf(world, block), force.law.structure, variantOf(owner)]);
  return {
    block,
    ...makeWorldLoop(world, key, () => energySource(new WorldColumns(world, block, () => owner), force)),
  };
}

function energySource(columns: WorldColumns, force: LawForce): LoopSource {
  const { graph, world } = columns;
  const position = columns.axes(world.addresses.Position);
  const velocity = columns.axes(world.addresses.Velocity);
  const none = zeroVector(graph);
  const vectors = { position, velocity, startVelocity: velocity, force: none, acceleration: none };
  const lowering = new Lowering(graph, columns.environment(force, vectors, columns.timeAt(0), 0));
  const energy = lowering.scalar(force.law.potential as NonNullable<typeof force.law.potential>);
  return {
    name: 'energy',
    types: { stored: world.precision, computed: 'f64' },
    stores: [],
    total: graph.make('keep', [columns.isMovable, energy]),
    noteOf: notesOf(world, columns.block),
  };
}
