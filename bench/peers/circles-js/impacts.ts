import { type Balls, SLICES } from './state.ts';

const MOST_SWEEPS = 4;

/** Collisions at the instant the surfaces met, the earliest first. */
export function resolveImpacts(balls: Balls): void {
  const { order, turn, a, b } = balls;
  const listed = orderByTime(balls);
  if (listed === 0) return;
  turn.fill(0);
  let hit = 0;
  for (let k = 0; k < listed; k++) if (impact(balls, order[k], 1)) hit++;
  for (let sweep = 1; sweep < MOST_SWEEPS && hit > 0; sweep++) {
    hit = 0;
    for (let i = 0; i < balls.contacts; i++) {
      if ((turn[a[i]] >= sweep || turn[b[i]] >= sweep) && impact(balls, i, sweep + 1)) hit++;
    }
  }
}

/** Lists the contacts that may collide, earliest slice of the step first. */
function orderByTime(balls: Balls): number {
  const { contacts, slice, ends, order, collided } = balls;
  ends.fill(0);
  for (let i = 0; i < contacts; i++) {
    collided[i] = 0;
    slice[i] = sliceOf(balls, i);
    if (slice[i] >= 0) ends[slice[i] + 1]++;
  }
  for (let s = 0; s < SLICES; s++) ends[s + 1] += ends[s];
  const total = ends[SLICES];
  for (let i = 0; i < contacts; i++) if (slice[i] >= 0) order[ends[slice[i]]++] = i;
  return total;
}

function sliceOf(balls: Balls, i: number): number {
  const { flat, x, y, z, vx, vy, vz, radius, dt, nx, ny, nz } = balls;
  const a = balls.a[i];
  const b = balls.b[i];
  const dx = x[b] - x[a];
  const dy = y[b] - y[a];
  const dz = flat ? 0 : z[b] - z[a];
  const distance = Math.sqrt(dx * dx + dy * dy + dz * dz);
  nx[i] = dx / distance;
  ny[i] = dy / distance;
  if (!flat) nz[i] = dz / distance;
  const reach = radius[a] + radius[b];
  if (!(distance < reach)) return -1;
  const ux = vx[b] - vx[a];
  const uy = vy[b] - vy[a];
  const uz = flat ? 0 : vz[b] - vz[a];
  const since = touchTime(dx, dy, dz, ux, uy, uz, 0, 0, 0, reach, dt);
  if (since >= 0) return Math.max(0, SLICES - 1 - ((since * (1 / dt) * SLICES) | 0));
  return ux * nx[i] + uy * ny[i] + (flat ? 0 : uz * nz[i]) < 0 ? 0 : -1;
}

let touchX = 0;
let touchY = 0;
let touchZ = 0;
let touchSpeed = 0;

/** Time since two bodies came to the distance `reach`, or -1 when that was not within the last `dt`. */
function touchTime(
  dx: number,
  dy: number,
  dz: number,
  ux: number,
  uy: number,
  uz: number,
  ax: number,
  ay: number,
  az: number,
  reach: number,
  dt: number,
): number {
  const along = dx * ux + dy * uy + dz * uz;
  const square = ux * ux + uy * uy + uz * uz;
  const gap = dx * dx + dy * dy + dz * dz - reach * reach;
  const discriminant = along * along - square * gap;
  if (!(discriminant >= 0) || !(square > 0)) return -1;
  const root = Math.sqrt(discriminant);
  let time = along < 0 && gap < 0 ? -gap / (root - along) : (along + root) / square;
  if (ax !== 0 || ay !== 0 || az !== 0) {
    for (let k = 0; k < 3; k++) {
      const half = 0.5 * time;
      const px = dx - time * (ux - half * ax);
      const py = dy - time * (uy - half * ay);
      const pz = dz - time * (uz - half * az);
      const slope = 2 * (px * (ax * time - ux) + py * (ay * time - uy) + pz * (az * time - uz));
      if (!(slope > 0)) break;
      time -= (px * px + py * py + pz * pz - reach * reach) / slope;
    }
  }
  if (!(time >= 0 && time <= dt)) return -1;
  const half = 0.5 * time;
  const px = dx - time * (ux - half * ax);
  const py = dy - time * (uy - half * ay);
  const pz = dz - time * (uz - half * az);
  const length = Math.sqrt(px * px + py * py + pz * pz);
  touchX = px / length;
  touchY = py / length;
  touchZ = pz / length;
  touchSpeed = -((ux - ax * time) * touchX + (uy - ay * time) * touchY + (uz - az * time) * touchZ);
  return time;
}

function impact(balls: Balls, i: number, turn: number): boolean {
  const { flat, x, y, z, vx, vy, vz, radius, inverseMass, restitution, dt, nx, ny, nz, collided } = balls;
  const a = balls.a[i];
  const b = balls.b[i];
  const reach = radius[a] + radius[b];
  const dx = x[b] - x[a];
  const dy = y[b] - y[a];
  const dz = flat ? 0 : z[b] - z[a];
  const distance = Math.sqrt(dx * dx + dy * dy + dz * dz);
  if (!(distance < reach)) return false;
  const ux = vx[b] - vx[a];
  const uy = vy[b] - vy[a];
  const uz = flat ? 0 : vz[b] - vz[a];
  let px = dx / distance;
  let py = dy / distance;
  let pz = dz / distance;
  let speed = -(ux * px + uy * py + uz * pz);
  if (!(speed > 0) && collided[i] !== 0) return false;
  const ax = balls.ax[b] - balls.ax[a];
  const ay = balls.ay[b] - balls.ay[a];
  const az = flat ? 0 : balls.az[b] - balls.az[a];
  let since = touchTime(dx, dy, dz, ux, uy, uz, ax, ay, az, reach, dt);
  if (since >= 0) {
    px = touchX;
    py = touchY;
    pz = touchZ;
    speed = touchSpeed;
  } else {
    since = dt;
  }
  if (!(speed > 0)) return false;
  let e = Math.max(restitution[a], restitution[b]);
  const wa = inverseMass[a];
  const wb = inverseMass[b];
  const pull = Math.max(balls.holding[i] * (wa + wb), -(ax * px + ay * py + az * pz) * dt);
  if (e * speed <= 0.5 * pull) {
    if (speed <= 2 * pull) return false;
    e = 0;
  }
  const impulse = ((1 + e) * speed) / (wa + wb);
  nx[i] = px;
  ny[i] = py;
  if (!flat) nz[i] = pz;
  balls.impulse[i] += impulse;
  collided[i] = 1;
  balls.turn[a] = turn;
  balls.turn[b] = turn;
  kick(balls, a, -impulse * wa, px, py, pz, since);
  kick(balls, b, impulse * wb, px, py, pz, since);
  return true;
}

/** Changes a velocity by `change` along (px, py, pz), and the position by what that amounts to in `time`. */
export function kick(
  { flat, x, y, z, vx, vy, vz }: Balls,
  i: number,
  change: number,
  px: number,
  py: number,
  pz: number,
  time: number,
): void {
  const dx = change * px;
  const dy = change * py;
  vx[i] += dx;
  vy[i] += dy;
  x[i] += dx * time;
  y[i] += dy * time;
  if (flat) return;
  const dz = change * pz;
  vz[i] += dz;
  z[i] += dz * time;
}
