import type { Column } from '../columns';
import { type Gas, WALL_REACH } from './state';

/** Elastic walls of the box along one axis; `first` is the number of the wall at the origin. */
export function bounce(gas: Gas, x: Column, v: Column, start: Column, first: number): void {
  const { count, radius, side } = gas;
  for (let i = 0; i < count; i++) {
    const reach = radius[i] * WALL_REACH;
    if (x[i] >= reach && x[i] <= side - reach) continue;
    const lower = radius[i];
    const upper = side - radius[i];
    const next = x[i] + v[i] * gas.dt;
    if (!((x[i] < lower && next >= lower) || (x[i] > upper && next <= upper))) {
      for (let turn = 0; turn < 4; turn++) {
        if (x[i] < lower) rebound(gas, i, x, v, start, lower, 1, first);
        else if (x[i] > upper) rebound(gas, i, x, v, start, upper, -1, first + 1);
        else break;
      }
      x[i] = Math.min(Math.max(x[i], lower), upper);
    }
    note(gas, i, first, x[i] - radius[i]);
    note(gas, i, first + 1, -(x[i] - side) - radius[i]);
  }
}

function rebound(
  gas: Gas,
  i: number,
  x: Column,
  v: Column,
  start: Column,
  plane: number,
  side: number,
  wall: number,
): void {
  const depth = side * (plane - x[i]);
  const speed = -side * v[i];
  if (!(speed > 0)) {
    x[i] = plane;
    return;
  }
  const since = Math.min((2 * depth) / (speed + speed), gas.dt);
  const after = side * speed;
  x[i] = plane + side * (since * speed);
  start[i] += after - v[i];
  v[i] = after;
  note(gas, i, wall, 0);
}

function note({ wall, wallGap, radius }: Gas, i: number, number: number, gap: number): void {
  if (wall[i] !== 0 || !(gap < (WALL_REACH - 1) * radius[i])) return;
  wall[i] = number;
  wallGap[i] = Math.max(0, gap);
}

/** Turns the gaps into the speeds at which the bodies may come to their walls. */
export function allow({ count, dt, vx, vy, wall, wallGap }: Gas): void {
  for (let i = 0; i < count; i++) {
    if (wall[i] === 0 || !(wallGap[i] > 0)) continue;
    const speed = wall[i] === 1 ? vx[i] : wall[i] === 2 ? -vx[i] : wall[i] === 3 ? vy[i] : -vy[i];
    wallGap[i] = Math.max(wallGap[i] / dt, -speed);
  }
}
