// The physics of `particles` as one loop over typed arrays, as a good programmer writes it without kernels. It does all
// of our work: it stores the previous pose and checks that all values are in range. It computes in doubles and stores
// in the columns' precision; rounding each operation would triple the time.
import { MAX_POSITION, MAX_SPEED } from '@principia/physics';
import type { Particles, SceneRun } from '@principia/scenes';
import { type ParticleColumns, particleColumns, rebound } from './particles-columns.ts';
import type { Peer } from './peer.ts';
import { firstBodies, warmStep } from './warm-up.ts';

type Step = (columns: ParticleColumns, previous: Previous) => boolean;
type Previous = Pick<ParticleColumns, 'x' | 'y' | 'z'>;

export async function fusedJs(run: SceneRun): Promise<Peer> {
  const columns = firstBodies(particleColumns(run as Particles));
  const step: Step = run.world.dimensions === 2 ? step2d : step3d;
  return {
    name: 'fused by hand in plain JavaScript',
    step: await warmStep(columns, (some) => {
      const previous = { x: some.x.slice(), y: some.y.slice(), z: some.z.slice() };
      return () => {
        if (!step(some, previous)) throw new Error('The loop found a value out of range.');
      };
    }),
    positions: (axis) => columns[axis],
  };
}

/** False for NaN. */
function isInRange(x: number, v: number): boolean {
  return Math.abs(x) <= MAX_POSITION && Math.abs(v) <= MAX_SPEED;
}

function step2d(columns: ParticleColumns, previous: Previous): boolean {
  const { count, dt, gravity, side, wall, x, y, vx, vy, mass, drag, radius } = columns;
  let isGood = true;
  for (let i = 0; i < count; i++) {
    const ux = vx[i];
    const uy = vy[i];
    const m = mass[i];
    const k = drag[i] * Math.sqrt(ux * ux + uy * uy);
    const wx = ux - ((k * ux) / m) * dt;
    const wy = uy - (gravity + (k * uy) / m) * dt;
    const px = x[i] + wx * dt;
    const py = y[i] + wy * dt;
    previous.x[i] = x[i];
    previous.y[i] = y[i];
    vx[i] = wx;
    vy[i] = wy;
    x[i] = px;
    y[i] = py;
    if (!(isInRange(px, wx) && isInRange(py, wy))) isGood = false;
    const low = radius[i];
    const high = side - low;
    if (px < low) rebound(x, vx, i, ux, low, 1, wall, dt);
    else if (px > high) rebound(x, vx, i, ux, high, -1, wall, dt);
    if (py < low) rebound(y, vy, i, uy, low, 1, wall, dt);
    else if (py > high) rebound(y, vy, i, uy, high, -1, wall, dt);
  }
  return isGood;
}

function step3d(columns: ParticleColumns, previous: Previous): boolean {
  const { count, dt, gravity, side, wall, x, y, z, vx, vy, vz, mass, drag, radius } = columns;
  let isGood = true;
  for (let i = 0; i < count; i++) {
    const ux = vx[i];
    const uy = vy[i];
    const uz = vz[i];
    const m = mass[i];
    const k = drag[i] * Math.sqrt(ux * ux + uy * uy + uz * uz);
    const wx = ux - ((k * ux) / m) * dt;
    const wy = uy - (gravity + (k * uy) / m) * dt;
    const wz = uz - ((k * uz) / m) * dt;
    const px = x[i] + wx * dt;
    const py = y[i] + wy * dt;
    const pz = z[i] + wz * dt;
    previous.x[i] = x[i];
    previous.y[i] = y[i];
    previous.z[i] = z[i];
    vx[i] = wx;
    vy[i] = wy;
    vz[i] = wz;
    x[i] = px;
    y[i] = py;
    z[i] = pz;
    if (!(isInRange(px, wx) && isInRange(py, wy) && isInRange(pz, wz))) isGood = false;
    const low = radius[i];
    const high = side - low;
    if (px < low) rebound(x, vx, i, ux, low, 1, wall, dt);
    else if (px > high) rebound(x, vx, i, ux, high, -1, wall, dt);
    if (py < low) rebound(y, vy, i, uy, low, 1, wall, dt);
    else if (py > high) rebound(y, vy, i, uy, high, -1, wall, dt);
    if (pz < low) rebound(z, vz, i, uz, low, 1, wall, dt);
    else if (pz > high) rebound(z, vz, i, uz, high, -1, wall, dt);
  }
  return isGood;
}
