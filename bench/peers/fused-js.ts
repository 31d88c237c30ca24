// The same physics written by hand as one plain loop over typed arrays: what a good programmer without kernels writes.
// It computes in doubles and stores in the columns' precision (rounding each operation makes it three times slower).
import type { Particles, SceneRun } from '@principia/scenes';
import { type ParticleColumns, particleColumns, rebound } from './particles-columns';
import type { Peer } from './peer';

export function fusedJs(run: SceneRun): Peer {
  const columns = particleColumns(run as Particles);
  const step = run.world.dimensions === 2 ? step2d : step3d;
  return {
    name: 'fused by hand in plain JavaScript',
    step: () => step(columns),
    positions: (axis) => columns[axis],
  };
}

function step2d({ count, dt, gravity, side, wall, x, y, vx, vy, mass, drag, radius }: ParticleColumns): void {
  for (let i = 0; i < count; i++) {
    const ux = vx[i] as number;
    const uy = vy[i] as number;
    const m = mass[i] as number;
    const k = (drag[i] as number) * Math.sqrt(ux * ux + uy * uy);
    const wx = ux - ((k * ux) / m) * dt;
    const wy = uy - (gravity + (k * uy) / m) * dt;
    const px = (x[i] as number) + wx * dt;
    const py = (y[i] as number) + wy * dt;
    vx[i] = wx;
    vy[i] = wy;
    x[i] = px;
    y[i] = py;
    const low = radius[i] as number;
    const high = side - low;
    if (px < low) rebound(x, vx, i, ux, low, 1, wall, dt);
    else if (px > high) rebound(x, vx, i, ux, high, -1, wall, dt);
    if (py < low) rebound(y, vy, i, uy, low, 1, wall, dt);
    else if (py > high) rebound(y, vy, i, uy, high, -1, wall, dt);
  }
}

function step3d({ count, dt, gravity, side, wall, x, y, z, vx, vy, vz, mass, drag, radius }: ParticleColumns): void {
  for (let i = 0; i < count; i++) {
    const ux = vx[i] as number;
    const uy = vy[i] as number;
    const uz = vz[i] as number;
    const m = mass[i] as number;
    const k = (drag[i] as number) * Math.sqrt(ux * ux + uy * uy + uz * uz);
    const wx = ux - ((k * ux) / m) * dt;
    const wy = uy - (gravity + (k * uy) / m) * dt;
    const wz = uz - ((k * uz) / m) * dt;
    const px = (x[i] as number) + wx * dt;
    const py = (y[i] as number) + wy * dt;
    const pz = (z[i] as number) + wz * dt;
    vx[i] = wx;
    vy[i] = wy;
    vz[i] = wz;
    x[i] = px;
    y[i] = py;
    z[i] = pz;
    const low = radius[i] as number;
    const high = side - low;
    if (px < low) rebound(x, vx, i, ux, low, 1, wall, dt);
    else if (px > high) rebound(x, vx, i, ux, high, -1, wall, dt);
    if (py < low) rebound(y, vy, i, uy, low, 1, wall, dt);
    else if (py > high) rebound(y, vy, i, uy, high, -1, wall, dt);
    if (pz < low) rebound(z, vz, i, uz, low, 1, wall, dt);
    else if (pz > high) rebound(z, vz, i, uz, high, -1, wall, dt);
  }
}
