// Our direct summation on the stars of `nbody-tree`, which shows the gain of the tree.
import { bodies, createPhysicsWorld, mutualGravity, spawnMany, step } from '@principia/physics';
import type { ClusterRun, SceneRun } from '@principia/scenes';
import { denseColumn } from './columns.ts';
import type { Peer } from './peer.ts';

export function nBodyDirect(run: SceneRun): Peer {
  const { world, dt } = run;
  const { dimensions, precision, capacity, components } = world;
  const { gravity: theirs, law } = run as ClusterRun;
  const { softening, G } = theirs.parameters as Record<string, { value: number }>;
  const gravity = mutualGravity({ G: G.value, softening: softening.value, method: 'direct', law });
  const copy = createPhysicsWorld({ dimensions, precision, capacity, integrator: world.integrator, forces: [gravity] });
  const { ids, count } = bodies(world);
  const dense = (column: Float32Array | Float64Array) => denseColumn(precision, column, ids.slice(0, count));
  const three = ({ x, y, z }: typeof components.Position) => ({
    x: dense(x),
    y: dense(y),
    ...(dimensions === 3 ? { z: dense(z) } : {}),
  });
  spawnMany(copy, count, {
    position: three(components.Position),
    velocity: three(components.Velocity),
    mass: dense(components.Mass.value),
  });
  return {
    name: 'direct sum of ours',
    step: () => step(copy, dt),
    positions: (axis) => copy.components.Position[axis].subarray(1, count + 1),
  };
}
