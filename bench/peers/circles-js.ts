// Colliding discs or balls in a box as a user would write them without an engine: velocity Verlet, a uniform grid, and
// a few passes over the close pairs that push them apart and apply impulses. It does other work than ours: no time of
// impact, no ordering of impacts, no solver for resting contacts. In 2D all z are zero and the grid has one layer.
import { bodies, velocityVerlet } from '@principia/physics';
import type { BoxedRun, SceneRun } from '@principia/scenes';
import { type Column, denseColumn } from './columns.ts';
import type { Peer } from './peer.ts';

/** Passes over the pairs in a step. They are too few to carry the weight of a heap, which sinks into itself. */
const PASSES = 8;

/** Undefined for bodies with friction or for another integrator. */
export function circlesJs(run: SceneRun): Peer | undefined {
  const boxed = run as BoxedRun;
  if (boxed.friction > 0 || run.world.integrator.name !== velocityVerlet.name) return undefined;
  const state = stateOf(boxed);
  const { x, y, z, vx, vy, vz, radius, dt, gravity, far, restitution, is3D } = state;
  return {
    name: 'plain JavaScript loops over a grid',
    step() {
      move(x, vx, dt, 0);
      move(y, vy, dt, -gravity);
      if (is3D) move(z, vz, dt, 0);
      sortIntoCells(state);
      findPairs(state);
      for (let pass = 0; pass < PASSES; pass++) {
        collideAll(state);
        bounce(x, vx, radius, far.x, restitution);
        bounce(y, vy, radius, far.y, restitution);
        if (is3D) bounce(z, vz, radius, far.z, restitution);
      }
    },
    positions: (axis) => state[axis],
    differs: true,
  };
}

type State = ReturnType<typeof stateOf>;

function stateOf({ world, dt, far, gravity, restitution }: BoxedRun) {
  const { Position, Velocity, Mass, Collider } = world.components;
  const list = bodies(world);
  const ids = list.ids.slice(0, list.count);
  const dense = (column: Column) => denseColumn(world.precision, column, ids);
  const radius = dense(Collider.radius);
  let maxRadius = 0;
  for (let i = 0; i < radius.length; i++) maxRadius = Math.max(maxRadius, radius[i]);
  const cell = 2 * maxRadius;
  const columns = Math.max(1, Math.ceil(far.x / cell));
  const rows = Math.max(1, Math.ceil(far.y / cell));
  const layers = Math.max(1, Math.ceil(far.z / cell));
  return {
    count: ids.length,
    is3D: world.dimensions === 3,
    dt,
    far,
    gravity,
    restitution,
    x: dense(Position.x),
    y: dense(Position.y),
    z: dense(Position.z),
    vx: dense(Velocity.x),
    vy: dense(Velocity.y),
    vz: dense(Velocity.z),
    radius,
    inverseMass: dense(Mass.value).map((mass) => 1 / mass),
    bodyRestitution: dense(Collider.restitution),
    cell,
    columns,
    rows,
    layers,
    cellOf: new Int32Array(ids.length),
    /** First entry of each cell in `sorted`. */
    starts: new Int32Array(columns * rows * layers + 1),
    sorted: new Int32Array(ids.length),
    /** Bodies of the pairs, two entries each; a body has fewer than eight pairs with a larger index on average. */
    pairs: new Int32Array(16 * ids.length),
    pairCount: 0,
  };
}

/** Moves bodies along an axis by velocity Verlet under a constant acceleration. */
function move(x: Column, v: Column, dt: number, acceleration: number): void {
  for (let i = 0; i < x.length; i++) {
    const mid = v[i] + 0.5 * acceleration * dt;
    x[i] += mid * dt;
    v[i] = mid + 0.5 * acceleration * dt;
  }
}

/** Walls clamp the position and reflect the velocity. */
function bounce(x: Column, v: Column, radius: Column, far: number, restitution: number): void {
  for (let i = 0; i < x.length; i++) {
    if (x[i] < radius[i]) {
      x[i] = radius[i];
      if (v[i] < 0) v[i] *= -restitution;
    } else if (x[i] > far - radius[i]) {
      x[i] = far - radius[i];
      if (v[i] > 0) v[i] *= -restitution;
    }
  }
}

/** Counting sort of the bodies by cell. */
function sortIntoCells({ count, x, y, z, cell, columns, rows, layers, cellOf, starts, sorted }: State): void {
  starts.fill(0);
  for (let i = 0; i < count; i++) {
    const column = clampIndex(x[i] / cell, columns);
    const row = clampIndex(y[i] / cell, rows);
    const layer = clampIndex(z[i] / cell, layers);
    cellOf[i] = column + columns * (row + rows * layer);
    starts[cellOf[i] + 1]++;
  }
  for (let c = 1; c < starts.length; c++) starts[c] += starts[c - 1];
  for (let i = count - 1; i >= 0; i--) sorted[--starts[cellOf[i] + 1]] = i;
  // The loop above moved every start back by one cell; this restores them.
  starts.copyWithin(0, 1);
  starts[starts.length - 1] = count;
}

function clampIndex(value: number, count: number): number {
  return Math.min(count - 1, Math.max(0, Math.floor(value)));
}

/** Lists the pairs that overlap; the second body is in a neighbouring cell and has a larger index. */
function findPairs(state: State): void {
  const { count, cellOf, columns, rows, layers, starts, sorted } = state;
  state.pairCount = 0;
  for (let i = 0; i < count; i++) {
    const column = cellOf[i] % columns;
    const row = Math.floor(cellOf[i] / columns) % rows;
    const layer = Math.floor(cellOf[i] / (columns * rows));
    const last = Math.min(columns - 1, column + 1);
    for (let l = Math.max(0, layer - 1); l <= Math.min(layers - 1, layer + 1); l++) {
      for (let r = Math.max(0, row - 1); r <= Math.min(rows - 1, row + 1); r++) {
        const line = columns * (r + rows * l);
        // The cells of a row are consecutive in `sorted`.
        for (let k = starts[line + Math.max(0, column - 1)]; k < starts[line + last + 1]; k++) {
          if (sorted[k] > i && squaredDistance(state, i, sorted[k]) < squaredReach(state, i, sorted[k])) {
            state.pairs[2 * state.pairCount] = i;
            state.pairs[2 * state.pairCount++ + 1] = sorted[k];
          }
        }
      }
    }
  }
}

function squaredDistance({ x, y, z }: State, i: number, j: number): number {
  const dx = x[j] - x[i];
  const dy = y[j] - y[i];
  const dz = z[j] - z[i];
  return dx * dx + dy * dy + dz * dz;
}

function squaredReach({ radius }: State, i: number, j: number): number {
  const reach = radius[i] + radius[j];
  return reach * reach;
}

function collideAll(state: State): void {
  const { pairs, pairCount } = state;
  for (let k = 0; k < pairCount; k++) collide(state, pairs[2 * k], pairs[2 * k + 1]);
}

/** Separates two overlapping bodies along their normal and applies the impulse of the collision. */
function collide(state: State, i: number, j: number): void {
  const { x, y, z, vx, vy, vz, radius, inverseMass, bodyRestitution } = state;
  const dx = x[j] - x[i];
  const dy = y[j] - y[i];
  const dz = z[j] - z[i];
  const square = dx * dx + dy * dy + dz * dz;
  const contactDistance = radius[i] + radius[j];
  if (square >= contactDistance * contactDistance || square === 0) return;
  const distance = Math.sqrt(square);
  const [nx, ny, nz] = [dx / distance, dy / distance, dz / distance];
  const effectiveMass = 1 / (inverseMass[i] + inverseMass[j]);
  const push = (contactDistance - distance) * effectiveMass;
  const speed = (vx[j] - vx[i]) * nx + (vy[j] - vy[i]) * ny + (vz[j] - vz[i]) * nz;
  const restitution = Math.max(bodyRestitution[i], bodyRestitution[j]);
  const impulse = speed < 0 ? -(1 + restitution) * speed * effectiveMass : 0;
  const [wi, wj] = [inverseMass[i], inverseMass[j]];
  x[i] -= push * wi * nx;
  y[i] -= push * wi * ny;
  z[i] -= push * wi * nz;
  x[j] += push * wj * nx;
  y[j] += push * wj * ny;
  z[j] += push * wj * nz;
  vx[i] -= impulse * wi * nx;
  vy[i] -= impulse * wi * ny;
  vz[i] -= impulse * wi * nz;
  vx[j] += impulse * wj * nx;
  vy[j] += impulse * wj * ny;
  vz[j] += impulse * wj * nz;
}
