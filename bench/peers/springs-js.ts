// The physics of the scene `springs` as plain loops over typed arrays: spring forces, then kick and drift.
import { bodies } from '@principia/physics';
import type { SceneRun } from '@principia/scenes';
import { type Column, denseColumn } from './columns.ts';
import type { Peer } from './peer.ts';

export function springsJs(run: SceneRun): Peer {
  const state = stateOf(run);
  const stretch = run.world.dimensions === 2 ? stretch2d : stretch3d;
  return {
    name: 'plain JavaScript',
    step() {
      stretch(state);
      move(state, run.world.dimensions);
    },
    positions: (axis) => state.x[axis],
  };
}

type State = ReturnType<typeof stateOf>;

function stateOf({ world, dt }: SceneRun) {
  const { Position, Velocity, Mass, Spring } = world.components;
  const { ids, count } = bodies(world);
  const nodes = ids.slice(0, count);
  const placeOf = new Uint32Array(world.rows);
  for (let i = 0; i < count; i++) placeOf[nodes[i]] = i;
  const links = Uint32Array.from({ length: world.lastId }, (_, i) => i + 1).filter((id) => Spring.a[id] > 0);
  const three = (columns: { x: Column; y: Column; z: Column }) => ({
    x: denseColumn(world.precision, columns.x, nodes),
    y: denseColumn(world.precision, columns.y, nodes),
    z: denseColumn(world.precision, columns.z, nodes),
  });
  const force = () => new Float64Array(count);
  return {
    dt,
    x: three(Position),
    v: three(Velocity),
    force: { x: force(), y: force(), z: force() },
    inverseMass: denseColumn(world.precision, Mass.value, nodes).map((mass) => (mass > 0 ? 1 / mass : 0)),
    a: links.map((link) => placeOf[Spring.a[link]]),
    b: links.map((link) => placeOf[Spring.b[link]]),
    stiffness: denseColumn(world.precision, Spring.stiffness, links),
    damping: denseColumn(world.precision, Spring.damping, links),
    length: denseColumn(world.precision, Spring.length, links),
  };
}

function stretch2d({ x, v, force, a, b, stiffness, damping, length }: State): void {
  force.x.fill(0);
  force.y.fill(0);
  for (let s = 0; s < a.length; s++) {
    const [i, j] = [a[s], b[s]];
    const dx = x.x[j] - x.x[i];
    const dy = x.y[j] - x.y[i];
    const distance = Math.sqrt(dx * dx + dy * dy);
    const nx = dx / distance;
    const ny = dy / distance;
    const rate = (v.x[j] - v.x[i]) * nx + (v.y[j] - v.y[i]) * ny;
    const tension = stiffness[s] * (distance - length[s]) + damping[s] * rate;
    force.x[i] += tension * nx;
    force.y[i] += tension * ny;
    force.x[j] -= tension * nx;
    force.y[j] -= tension * ny;
  }
}

function stretch3d({ x, v, force, a, b, stiffness, damping, length }: State): void {
  force.x.fill(0);
  force.y.fill(0);
  force.z.fill(0);
  for (let s = 0; s < a.length; s++) {
    const [i, j] = [a[s], b[s]];
    const dx = x.x[j] - x.x[i];
    const dy = x.y[j] - x.y[i];
    const dz = x.z[j] - x.z[i];
    const distance = Math.sqrt(dx * dx + dy * dy + dz * dz);
    const nx = dx / distance;
    const ny = dy / distance;
    const nz = dz / distance;
    const rate = (v.x[j] - v.x[i]) * nx + (v.y[j] - v.y[i]) * ny + (v.z[j] - v.z[i]) * nz;
    const tension = stiffness[s] * (distance - length[s]) + damping[s] * rate;
    force.x[i] += tension * nx;
    force.y[i] += tension * ny;
    force.z[i] += tension * nz;
    force.x[j] -= tension * nx;
    force.y[j] -= tension * ny;
    force.z[j] -= tension * nz;
  }
}

function move({ dt, x, v, force, inverseMass }: State, dimensions: 2 | 3): void {
  for (const axis of dimensions === 2 ? (['x', 'y'] as const) : (['x', 'y', 'z'] as const)) {
    const [position, velocity, f] = [x[axis], v[axis], force[axis]];
    for (let i = 0; i < position.length; i++) {
      velocity[i] += f[i] * inverseMass[i] * dt;
      position[i] += velocity[i] * dt;
    }
  }
}
