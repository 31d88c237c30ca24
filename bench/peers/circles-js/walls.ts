import type { Column } from '../columns.ts';
import { type Balls, WALL_REACH } from './state.ts';

/** The walls of the box, one axis after the other. */
export function meetWalls(balls: Balls): void {
  const { x, y, z, vx, vy, vz, startX, startY, startZ, far } = balls;
  balls.walls = 0;
  bounce(balls, x, vx, startX, far.x, 0);
  bounce(balls, y, vy, startY, far.y, 1);
  if (!balls.flat) bounce(balls, z, vz, startZ, far.z, 2);
}

function bounce(balls: Balls, x: Column, v: Column, start: Column, side: number, axis: number): void {
  const { count, radius, dt } = balls;
  for (let i = 0; i < count; i++) {
    const reach = radius[i] * WALL_REACH;
    if (x[i] >= reach && x[i] <= side - reach) continue;
    const lower = radius[i];
    const upper = side - radius[i];
    const next = x[i] + v[i] * dt;
    if (!((x[i] < lower && next >= lower) || (x[i] > upper && next <= upper))) {
      for (let turn = 0; turn < 4; turn++) {
        if (x[i] < lower) rebound(balls, i, x, v, start, lower, 1, axis);
        else if (x[i] > upper) rebound(balls, i, x, v, start, upper, -1, axis);
        else break;
      }
      x[i] = Math.min(Math.max(x[i], lower), upper);
    }
    const below = x[i] - radius[i];
    if (below < (WALL_REACH - 1) * radius[i]) note(balls, i, axis, 1, 0, 0, Math.max(0, below));
    const above = side - x[i] - radius[i];
    if (above < (WALL_REACH - 1) * radius[i]) note(balls, i, axis, -1, 0, 0, Math.max(0, above));
  }
}

/** Back from the instant of impact, or to rest where the rebound would be over within the step. */
function rebound(
  balls: Balls,
  i: number,
  x: Column,
  v: Column,
  start: Column,
  plane: number,
  side: number,
  axis: number,
): void {
  const { dt, mass, restitution, wallRestitution } = balls;
  const depth = side * (plane - x[i]);
  const pull = (side * (start[i] - v[i])) / dt;
  const speed = -side * v[i];
  if (!(speed > 0)) {
    x[i] = plane;
    return;
  }
  const then = Math.sqrt(Math.max(0, speed * speed - pull * (depth + depth)));
  const since = Math.min((depth + depth) / (then + speed), dt);
  const impact = Math.max(0, speed - pull * since);
  const leave = Math.max(restitution[i], wallRestitution) * impact;
  const out = since * (leave - 0.5 * (pull * since));
  const flies = out > 0 && impact > 0;
  const away = flies ? leave - pull * since : 0;
  const after = side * away;
  x[i] = flies ? plane + side * out : plane;
  start[i] = flies ? start[i] + (after - v[i]) : 0;
  const impulse = (away + side * -v[i]) * mass[i];
  v[i] = after;
  if (impulse > 0) note(balls, i, axis, side, impulse, flies ? 0 : impulse, 0);
}

function note(
  balls: Balls,
  i: number,
  axis: number,
  side: number,
  impulse: number,
  holding: number,
  gap: number,
): void {
  const k = balls.walls++;
  balls.wallBody[k] = i;
  balls.wallAxis[k] = axis;
  balls.wallSide[k] = side;
  balls.wallImpulse[k] = impulse;
  balls.wallHolding[k] = holding;
  balls.wallGap[k] = gap;
}

/** Notes which wall holds a body most, and how fast bodies may come to walls: as fast as closes the gap in a step. */
export function linkWalls(balls: Balls): void {
  const { walls, dt, met, wallBody, wallAxis, wallSide, wallGap, wallHolding, wallOf, vx, vy, vz } = balls;
  const velocities = [vx, vy, vz];
  wallOf.fill(0);
  for (let k = 0; k < walls; k++) {
    const i = wallBody[k];
    if (met[i] === 0) continue;
    if (wallGap[k] > 0) {
      const speed = velocities[wallAxis[k]][i] * wallSide[k];
      wallGap[k] = Math.max(wallGap[k] / dt, -speed);
    }
    if (wallOf[i] === 0 || wallHolding[k] > wallHolding[wallOf[i] - 1]) wallOf[i] = k + 1;
  }
}

/** How far a body can follow a push: `share` of its inverse mass along what is `left` of the direction. */
export const left = { x: 0, y: 0, z: 0, share: 1, wall: -1, cosine: 0 };

/** Finds out for body i and direction (x, y, z); `slow` is a speed that makes no difference. */
export function leave(balls: Balls, i: number, x: number, y: number, z: number, slow: number): void {
  left.x = x;
  left.y = y;
  left.z = z;
  left.share = 1;
  left.wall = balls.wallOf[i] - 1;
  if (left.wall >= 0) leaveWall(balls, i, x, y, z, slow);
}

function leaveWall(balls: Balls, i: number, x: number, y: number, z: number, slow: number): void {
  const { wallAxis, wallSide, wallGap, vx, vy, vz } = balls;
  const axis = wallAxis[left.wall];
  const side = wallSide[left.wall];
  const cosine = (axis === 0 ? x : axis === 1 ? y : z) * side;
  const off = (axis === 0 ? vx : axis === 1 ? vy : vz)[i] * side;
  if (!(cosine < 0) || off + wallGap[left.wall] > slow) {
    left.wall = -1;
    return;
  }
  if (axis === 0) left.x = 0;
  else if (axis === 1) left.y = 0;
  else left.z = 0;
  left.cosine = cosine;
  left.share = Math.max(0, 1 - cosine * cosine);
}
