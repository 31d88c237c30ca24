// A whole step as one loop: the integrator with all laws in its stages, the saved pose for interpolation, the checks of
// the result and the test for box walls.
import type { LoopSource, Store } from '../laws/loop-source.ts';
import { Lowering } from '../laws/lower.ts';
import type { Node } from '../laws/node.ts';
import { type Axes, zeroVector } from '../laws/vector-algebra.ts';
import type { AxisAddresses } from '../memory/columns.ts';
import type { Scheme } from '../world/types.ts';
import { checksOf } from './loop-checks.ts';
import { notesOf } from './notes.ts';
import type { ParameterBlock, ParameterOwner } from './parameter-block.ts';
import { keptStores, lowerLastStep } from './scheme-memory.ts';
import type { Result, StepFeatures } from './step-features.ts';
import { type LawForce, ownerOf, type Sum, sumLaws, velocityChange } from './sum-of-laws.ts';
import { WorldColumns } from './world-columns.ts';

/** Owners of parameters: the scheme first, then the laws. */
export function ownersOf(scheme: Scheme, laws: readonly LawForce[]): Map<object, ParameterOwner> {
  const owners = new Map<object, ParameterOwner>([[scheme, scheme]]);
  for (const force of laws) owners.set(force, ownerOf(force));
  return owners;
}

/** Builds the loop of a step. */
export function stepLoopSource(
  block: ParameterBlock,
  scheme: Scheme,
  laws: readonly LawForce[],
  owners: ReadonlyMap<object, ParameterOwner>,
  features: StepFeatures,
): LoopSource {
  const { world } = block;
  const columns = new WorldColumns(world, block, (owner) => owners.get(owner) as ParameterOwner);
  const { addresses, previousAddresses, scratch } = world;
  const position = columns.axes(addresses.Position);
  const velocity = columns.axes(addresses.Velocity);
  const { result, torque } = lowerScheme(columns, scheme, laws, features.memory, { position, velocity });
  const stores: Store[] = [];
  const put = (to: Readonly<AxisAddresses>, values: Axes) => {
    stores.push(...columns.axisNames.map((axis, i) => ({ address: to[axis], node: values[i] })));
  };
  if (features.savesPose) put(previousAddresses.Position, position);
  if (features.savesVelocity) put(scratch.at.startVelocity, velocity);
  put(addresses.Position, result.position);
  put(addresses.Velocity, result.velocity);
  stores.push(...result.kept);
  if (features.hasTorque) stores.push(...columns.torqueStores(torque));
  const { precision } = world;
  return {
    name: 'step',
    types: { stored: precision, computed: precision },
    stores,
    vectors: scheme.stages.length > 1 ? 2 : 1,
    ...checksOf(columns, { position, velocity }, result, features),
    noteOf: notesOf(world, block),
  };
}

/**
 * The state from which a scheme starts, and the length of its step, which is that of the world's by default: of each body, and as
 * a number with which the time at its stages is computed.
 */
interface Start {
  readonly position: Axes;
  readonly velocity: Axes;
  readonly duration?: Node;
  readonly length?: Node;
}

/** Lowers the state at the end of a step, with the torques there. */
export function lowerScheme(
  columns: WorldColumns,
  scheme: Scheme,
  laws: readonly LawForce[],
  memory: StepFeatures['memory'],
  { position, velocity, duration = columns.dt, length }: Start,
): { readonly result: Result; readonly torque: Axes } {
  const { graph, world } = columns;
  const none = zeroVector(graph);
  const sums: Sum[] = [];
  const vectors: Record<string, Axes> = { position, velocity };
  const last = lowerLastStep(columns, scheme, memory);
  last.memory.forEach((vector, i) => {
    vectors[`memory${i}`] = vector;
  });
  const lowering = new Lowering(graph, {
    ...columns.environment(scheme, vectors, columns.timeAt(0), 0),
    dt: duration,
    scalars: {
      mass: columns.mass,
      charge: graph.make('real', [], world.addresses.Charge.value),
      lastDt: last.lastDt,
    },
    kick(at, moving, during, { stage, fraction }) {
      const time = columns.timeAt(fraction, length);
      const evaluation = {
        position: at,
        velocity: moving,
        startVelocity: velocity,
        force: none,
        torque: none,
        stage,
        time,
      };
      sums[stage] = sumLaws(columns, laws, evaluation);
      return velocityChange(columns, sums[stage], during);
    },
  });
  const result = {
    position: lowering.vector(scheme.position),
    velocity: lowering.vector(scheme.velocity),
    kept: keptStores(
      columns,
      memory,
      last.body,
      scheme.memory.map((vector) => lowering.vector(vector)),
    ),
  };
  return { result, torque: sums.at(-1)?.torque ?? none };
}
