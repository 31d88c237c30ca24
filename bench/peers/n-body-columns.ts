// A star cluster as dense f64 arrays, and the parts of a velocity Verlet step with one force evaluation.
import { bodies } from '@principia/physics';
import type { ClusterRun, SceneRun } from '@principia/scenes';
import { denseColumn } from './columns.ts';

export type NBodyState = ReturnType<typeof nBodyState>;

export function nBodyState(run: SceneRun) {
  const { world, dt } = run;
  const { ids, count } = bodies(world);
  const dense = (column: Float32Array | Float64Array) => denseColumn('f64', column, ids.slice(0, count));
  const three = (c: {
    x: Float32Array | Float64Array;
    y: Float32Array | Float64Array;
    z: Float32Array | Float64Array;
  }) => ({
    x: dense(c.x),
    y: dense(c.y),
    z: dense(c.z),
  });
  const nothing = () => new Float64Array(count);
  const { G, softening } = (run as ClusterRun).gravity.parameters as Record<string, { value: number }>;
  return {
    count,
    dt,
    dimensions: world.dimensions,
    G: G.value,
    softening: softening.value,
    x: three(world.components.Position),
    v: three(world.components.Velocity),
    mass: dense(world.components.Mass.value),
    a: { x: nothing(), y: nothing(), z: nothing() },
  };
}

const AXES = { 2: ['x', 'y'], 3: ['x', 'y', 'z'] } as const;

/** The half kick and the drift before the force evaluation. */
export function kickDrift({ count, dt, dimensions, x, v, a }: NBodyState): void {
  for (const axis of AXES[dimensions]) {
    const [position, velocity, pull] = [x[axis], v[axis], a[axis]];
    for (let i = 0; i < count; i++) {
      velocity[i] += 0.5 * dt * pull[i];
      position[i] += dt * velocity[i];
    }
  }
}

/** The half kick after the force evaluation. */
export function kick({ count, dt, dimensions, v, a }: NBodyState): void {
  for (const axis of AXES[dimensions]) {
    const [velocity, pull] = [v[axis], a[axis]];
    for (let i = 0; i < count; i++) velocity[i] += 0.5 * dt * pull[i];
  }
}
