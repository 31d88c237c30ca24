import type { Balls } from './state.ts';
import { leave, left } from './walls.ts';

const PART = 0.8;
const SLOP = 0.001;
const ROUNDS = 4;
const MOST_SPEED = 4;

/** Displaces bodies that overlap and will still do so when the next step ends. */
export function separate(balls: Balls): void {
  const { contacts, a, b, most, order } = balls;
  let deep = 0;
  for (let i = 0; i < contacts; i++) if (depthOf(balls, i) > 0) order[deep++] = i;
  if (deep === 0) return;
  begin(balls);
  for (let k = 0; k < deep; k++) {
    const i = order[k];
    most[a[i]] = most[b[i]] = Math.max(most[a[i]], most[b[i]]);
  }
  for (let round = 0; round < ROUNDS; round++) {
    for (let k = 0; k < deep; k++) push(balls, order[round % 2 === 0 ? k : deep - 1 - k]);
  }
  end(balls);
}

function begin(balls: Balls): void {
  const { count, flat, dt, radius, startX, startY, startZ, x, y, z, fromX, fromY, fromZ, most } = balls;
  for (let i = 0; i < count; i++) {
    const square = startX[i] * startX[i] + startY[i] * startY[i] + (flat ? 0 : startZ[i] * startZ[i]);
    most[i] = dt * (Math.sqrt(square) + MOST_SPEED * radius[i]);
    fromX[i] = x[i];
    fromY[i] = y[i];
    if (!flat) fromZ[i] = z[i];
  }
}

/** Takes bodies back that went too far. */
function end({ count, flat, x, y, z, fromX, fromY, fromZ, most }: Balls): void {
  for (let i = 0; i < count; i++) {
    const dx = x[i] - fromX[i];
    const dy = y[i] - fromY[i];
    const dz = flat ? 0 : z[i] - fromZ[i];
    const square = dx * dx + dy * dy + dz * dz;
    if (!(square > most[i] * most[i])) continue;
    const scale = most[i] / Math.sqrt(square);
    x[i] = fromX[i] + dx * scale;
    y[i] = fromY[i] + dy * scale;
    if (!flat) z[i] = fromZ[i] + dz * scale;
  }
}

function depthOf(balls: Balls, i: number): number {
  const { flat, x, y, z, vx, vy, vz, radius, nx, ny, nz, dt } = balls;
  const a = balls.a[i];
  const b = balls.b[i];
  const dx = x[b] - x[a];
  const dy = y[b] - y[a];
  const dz = flat ? 0 : z[b] - z[a];
  const overlap = radius[a] + radius[b] - Math.sqrt(dx * dx + dy * dy + dz * dz);
  const speed = (vx[b] - vx[a]) * nx[i] + (vy[b] - vy[a]) * ny[i] + (flat ? 0 : (vz[b] - vz[a]) * nz[i]);
  return overlap - SLOP * (radius[a] + radius[b]) - Math.max(0, speed * dt);
}

function push(balls: Balls, i: number): void {
  const { flat, inverseMass, wallOf, nx, ny, nz, dt } = balls;
  const depth = depthOf(balls, i);
  if (!(depth > 0)) return;
  const a = balls.a[i];
  const b = balls.b[i];
  const wa = inverseMass[a];
  const wb = inverseMass[b];
  const z = flat ? 0 : nz[i];
  if (wallOf[a] !== 0 || wallOf[b] !== 0) {
    pushAtWall(balls, i, z, depth, (0.01 * depth) / dt);
    return;
  }
  const size = (PART * depth) / (wa + wb);
  move(balls, a, -nx[i], -ny[i], -z, size * wa);
  move(balls, b, nx[i], ny[i], z, size * wb);
}

function pushAtWall(balls: Balls, i: number, z: number, depth: number, slow: number): void {
  const { inverseMass, nx, ny } = balls;
  const a = balls.a[i];
  const b = balls.b[i];
  leave(balls, a, -nx[i], -ny[i], -z, slow);
  const { x: ax, y: ay, z: az, share } = left;
  leave(balls, b, nx[i], ny[i], z, slow);
  const sum = inverseMass[a] * share + inverseMass[b] * left.share;
  if (!(sum > 0)) return;
  const size = (PART * depth) / sum;
  move(balls, a, ax, ay, az, size * inverseMass[a]);
  move(balls, b, left.x, left.y, left.z, size * inverseMass[b]);
}

function move(balls: Balls, i: number, x: number, y: number, z: number, size: number): void {
  balls.x[i] += x * size;
  balls.y[i] += y * size;
  if (!balls.flat) balls.z[i] += z * size;
}
