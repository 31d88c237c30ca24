// The physics of the scene `attractors` as plain loops over typed arrays: velocity Verlet, with every attractor for
// every body. The acceleration at the end of a step is reused at the start of the next, as in a loop written for one
// force.
import { bodies } from '@principia/physics';
import type { SceneRun } from '@principia/scenes';
import { type Column, denseColumn } from './columns.ts';
import type { Peer } from './peer.ts';

export function attractorsJs(run: SceneRun): Peer {
  const state = stateOf(run);
  const pull = run.world.dimensions === 2 ? pull2d : pull3d;
  pull(state);
  return {
    name: 'plain JavaScript',
    step() {
      drift(state, run.world.dimensions);
      pull(state);
      kick(state, run.world.dimensions);
    },
    positions: (axis) => state.x[axis],
  };
}

type State = ReturnType<typeof stateOf>;

function stateOf({ world, dt }: SceneRun) {
  const { Position, Velocity, Attractor, Mass } = world.components;
  const { ids, count } = bodies(world);
  const free = ids.slice(0, count).filter((id) => Mass.value[id] > 0);
  const fixed = ids.slice(0, count).filter((id) => Attractor.mu[id] !== 0);
  const dense = (column: Column, of: Uint32Array) => denseColumn(world.precision, column, of);
  const three = (columns: { x: Column; y: Column; z: Column }, of: Uint32Array) => ({
    x: dense(columns.x, of),
    y: dense(columns.y, of),
    z: dense(columns.z, of),
  });
  const nothing = { x: new Float64Array(world.rows), y: new Float64Array(world.rows), z: new Float64Array(world.rows) };
  return {
    dt,
    x: three(Position, free),
    v: three(Velocity, free),
    a: three(nothing, free),
    before: three(nothing, free),
    centre: three(Position, fixed),
    mu: dense(Attractor.mu, fixed),
    softening: dense(Attractor.softening, fixed),
  };
}

function axesOf(dimensions: 2 | 3): readonly ('x' | 'y' | 'z')[] {
  return dimensions === 2 ? ['x', 'y'] : ['x', 'y', 'z'];
}

function drift({ dt, x, v, a, before }: State, dimensions: 2 | 3): void {
  for (const axis of axesOf(dimensions)) {
    const [position, velocity, start, old] = [x[axis], v[axis], a[axis], before[axis]];
    for (let i = 0; i < position.length; i++) {
      position[i] += (velocity[i] + 0.5 * dt * start[i]) * dt;
      old[i] = start[i];
    }
  }
}

function kick({ dt, v, a, before }: State, dimensions: 2 | 3): void {
  for (const axis of axesOf(dimensions)) {
    const [velocity, end, old] = [v[axis], a[axis], before[axis]];
    for (let i = 0; i < velocity.length; i++) velocity[i] += 0.5 * dt * (old[i] + end[i]);
  }
}

function pull2d({ x, a, centre, mu, softening }: State): void {
  for (let i = 0; i < x.x.length; i++) {
    let ax = 0;
    let ay = 0;
    for (let c = 0; c < mu.length; c++) {
      const dx = centre.x[c] - x.x[i];
      const dy = centre.y[c] - x.y[i];
      const square = dx * dx + dy * dy + softening[c] * softening[c];
      const scale = mu[c] / (square * Math.sqrt(square));
      ax += dx * scale;
      ay += dy * scale;
    }
    a.x[i] = ax;
    a.y[i] = ay;
  }
}

function pull3d({ x, a, centre, mu, softening }: State): void {
  for (let i = 0; i < x.x.length; i++) {
    let ax = 0;
    let ay = 0;
    let az = 0;
    for (let c = 0; c < mu.length; c++) {
      const dx = centre.x[c] - x.x[i];
      const dy = centre.y[c] - x.y[i];
      const dz = centre.z[c] - x.z[i];
      const square = dx * dx + dy * dy + dz * dz + softening[c] * softening[c];
      const scale = mu[c] / (square * Math.sqrt(square));
      ax += dx * scale;
      ay += dy * scale;
      az += dz * scale;
    }
    a.x[i] = ax;
    a.y[i] = ay;
    a.z[i] = az;
  }
}
