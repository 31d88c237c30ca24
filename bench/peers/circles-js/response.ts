import { separate } from './separate';
import { type Gas, SLICES } from './state';
import { allow } from './walls';

const MOST_SWEEPS = 4;

export function collide(gas: Gas): void {
  readAccelerations(gas);
  allow(gas);
  const listed = orderByTime(gas);
  if (listed > 0) {
    let hit = 0;
    for (let k = 0; k < listed; k++) if (impact(gas, gas.order[k])) hit++;
    for (let sweep = 1; sweep < MOST_SWEEPS && hit > 0; sweep++) {
      hit = 0;
      for (let i = 0; i < gas.contacts; i++) if (impact(gas, i)) hit++;
    }
  }
  refuseResting(gas);
  separate(gas);
}

/** Walls move the start velocity along; what is left of the difference is rounding. */
function readAccelerations({ count, dt, vx, vy, startX, startY, ax, ay }: Gas): void {
  const rate = 1 / dt;
  for (let i = 0; i < count; i++) {
    ax[i] = (vx[i] - startX[i]) * rate;
    ay[i] = (vy[i] - startY[i]) * rate;
  }
}

/** Lists the contacts that may collide, earliest slice of the step first. */
function orderByTime(gas: Gas): number {
  const { contacts, slice, ends, order, collided } = gas;
  ends.fill(0);
  for (let i = 0; i < contacts; i++) {
    collided[i] = 0;
    slice[i] = sliceOf(gas, i);
    if (slice[i] >= 0) ends[slice[i] + 1]++;
  }
  for (let s = 0; s < SLICES; s++) ends[s + 1] += ends[s];
  const total = ends[SLICES];
  for (let i = 0; i < contacts; i++) if (slice[i] >= 0) order[ends[slice[i]]++] = i;
  return total;
}

function sliceOf(gas: Gas, i: number): number {
  const { x, y, vx, vy, radius, dt, nx, ny } = gas;
  const a = gas.a[i];
  const b = gas.b[i];
  const dx = x[b] - x[a];
  const dy = y[b] - y[a];
  const ux = vx[b] - vx[a];
  const uy = vy[b] - vy[a];
  const distance = Math.sqrt(dx * dx + dy * dy);
  nx[i] = dx / distance;
  ny[i] = dy / distance;
  const reach = radius[a] + radius[b];
  if (!(distance < reach)) return -1;
  const since = touchTime(dx, dy, ux, uy, 0, 0, reach, dt);
  if (since >= 0) return Math.max(0, SLICES - 1 - ((since * (1 / dt) * SLICES) | 0));
  return ux * nx[i] + uy * ny[i] < 0 ? 0 : -1;
}

let touchX = 0;
let touchY = 0;
let touchSpeed = 0;

/** Time since two discs came to the distance `reach`, or -1 when that was not within the last `dt`. */
function touchTime(
  dx: number,
  dy: number,
  ux: number,
  uy: number,
  ax: number,
  ay: number,
  reach: number,
  dt: number,
): number {
  const along = dx * ux + dy * uy;
  const square = ux * ux + uy * uy;
  const gap = dx * dx + dy * dy - reach * reach;
  const discriminant = along * along - square * gap;
  if (!(discriminant >= 0) || !(square > 0)) return -1;
  const root = Math.sqrt(discriminant);
  let time = along < 0 && gap < 0 ? -gap / (root - along) : (along + root) / square;
  if (ax !== 0 || ay !== 0) {
    for (let k = 0; k < 3; k++) {
      const half = 0.5 * time;
      const px = dx - time * (ux - half * ax);
      const py = dy - time * (uy - half * ay);
      const slope = 2 * (px * (ax * time - ux) + py * (ay * time - uy));
      if (!(slope > 0)) break;
      time -= (px * px + py * py - reach * reach) / slope;
    }
  }
  if (!(time >= 0 && time <= dt)) return -1;
  const half = 0.5 * time;
  const px = dx - time * (ux - half * ax);
  const py = dy - time * (uy - half * ay);
  const length = Math.sqrt(px * px + py * py);
  touchX = px / length;
  touchY = py / length;
  touchSpeed = -((ux - ax * time) * touchX + (uy - ay * time) * touchY);
  return time;
}

function impact(gas: Gas, i: number): boolean {
  const { x, y, vx, vy, radius, mass, restitution, dt, nx, ny, collided } = gas;
  const a = gas.a[i];
  const b = gas.b[i];
  const reach = radius[a] + radius[b];
  const dx = x[b] - x[a];
  const dy = y[b] - y[a];
  const distance = Math.sqrt(dx * dx + dy * dy);
  if (!(distance < reach)) return false;
  const ax = gas.ax[b] - gas.ax[a];
  const ay = gas.ay[b] - gas.ay[a];
  const ux = vx[b] - vx[a];
  const uy = vy[b] - vy[a];
  let px = dx / distance;
  let py = dy / distance;
  let speed = -(ux * px + uy * py);
  if (!(speed > 0) && collided[i] !== 0) return false;
  let since = touchTime(dx, dy, ux, uy, ax, ay, reach, dt);
  if (since >= 0) {
    px = touchX;
    py = touchY;
    speed = touchSpeed;
  } else {
    since = dt;
  }
  if (!(speed > 0)) return false;
  let e = Math.max(restitution[a], restitution[b]);
  const wa = 1 / mass[a];
  const wb = 1 / mass[b];
  const pull = Math.max(0, -(ax * px + ay * py) * dt);
  if (e * speed <= 0.5 * pull) {
    if (speed <= 2 * pull) return false;
    e = 0;
  }
  const impulse = ((1 + e) * speed) / (wa + wb);
  nx[i] = px;
  ny[i] = py;
  collided[i] = 1;
  kick(gas, a, -impulse * wa * px, -impulse * wa * py, since);
  kick(gas, b, impulse * wb * px, impulse * wb * py, since);
  return true;
}

function kick({ x, y, vx, vy }: Gas, i: number, dx: number, dy: number, since: number): void {
  vx[i] += dx;
  vy[i] += dy;
  x[i] += dx * since;
  y[i] += dy * since;
}

/** A gas has no resting contacts; those that rounding makes look like one are only read, never pressed. */
function refuseResting(gas: Gas): void {
  const { x, y, vx, vy, ax, ay, radius, dt, nx, ny } = gas;
  for (let i = 0; i < gas.contacts; i++) {
    const a = gas.a[i];
    const b = gas.b[i];
    const dx = x[b] - x[a];
    const dy = y[b] - y[a];
    const distance = Math.sqrt(dx * dx + dy * dy);
    const px = dx / distance;
    const py = dy / distance;
    const closing = -((vx[b] - vx[a]) * px + (vy[b] - vy[a]) * py);
    const usual = 2 * dt * Math.sqrt(Math.max(ax[a] * ax[a] + ay[a] * ay[a], ax[b] * ax[b] + ay[b] * ay[b]));
    const pull = Math.max(0, -((ax[b] - ax[a]) * px + (ay[b] - ay[a]) * py)) * dt;
    if (closing > 0) {
      if (distance < radius[a] + radius[b] && closing <= 0.5 * pull) throw new Error('This gas has a resting contact.');
    } else if (-closing <= usual && usual > 0) {
      nx[i] = px;
      ny[i] = py;
    }
  }
}
