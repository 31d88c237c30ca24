import type { Gas } from './state';

const PART = 0.8;
const SLOP = 0.001;
const ROUNDS = 4;
const MOST_SPEED = 4;

/** Displaces discs that overlap and will still do so when the next step ends. */
export function separate(gas: Gas): void {
  const { contacts, a, b, most, order } = gas;
  let deep = 0;
  for (let i = 0; i < contacts; i++) if (depthOf(gas, i) > 0) order[deep++] = i;
  if (deep === 0) return;
  begin(gas);
  for (let k = 0; k < deep; k++) {
    const i = order[k];
    most[a[i]] = most[b[i]] = Math.max(most[a[i]], most[b[i]]);
  }
  for (let round = 0; round < ROUNDS; round++) {
    for (let k = 0; k < deep; k++) push(gas, order[round % 2 === 0 ? k : deep - 1 - k]);
  }
  end(gas);
}

function begin({ count, dt, radius, startX, startY, x, y, fromX, fromY, most }: Gas): void {
  for (let i = 0; i < count; i++) {
    const speed = Math.sqrt(startX[i] * startX[i] + startY[i] * startY[i]);
    most[i] = dt * (speed + MOST_SPEED * radius[i]);
    fromX[i] = x[i];
    fromY[i] = y[i];
  }
}

/** Takes discs back that went too far. */
function end({ count, x, y, fromX, fromY, most }: Gas): void {
  for (let i = 0; i < count; i++) {
    const dx = x[i] - fromX[i];
    const dy = y[i] - fromY[i];
    const square = dx * dx + dy * dy;
    if (!(square > most[i] * most[i])) continue;
    const scale = most[i] / Math.sqrt(square);
    x[i] = fromX[i] + dx * scale;
    y[i] = fromY[i] + dy * scale;
  }
}

function depthOf(gas: Gas, i: number): number {
  const { x, y, vx, vy, radius, nx, ny, dt } = gas;
  const a = gas.a[i];
  const b = gas.b[i];
  const dx = x[b] - x[a];
  const dy = y[b] - y[a];
  const overlap = radius[a] + radius[b] - Math.sqrt(dx * dx + dy * dy);
  const speed = (vx[b] - vx[a]) * nx[i] + (vy[b] - vy[a]) * ny[i];
  return overlap - SLOP * (radius[a] + radius[b]) - Math.max(0, speed * dt);
}

let leftX = 0;
let leftY = 0;
let share = 0;

function push(gas: Gas, i: number): void {
  const { mass, nx, ny, dt } = gas;
  const a = gas.a[i];
  const b = gas.b[i];
  const depth = depthOf(gas, i);
  if (!(depth > 0)) return;
  const slow = (0.01 * depth) / dt;
  leave(gas, a, -nx[i], -ny[i], slow);
  const wa = 1 / mass[a];
  const [ax, ay, shareA] = [leftX, leftY, wa * share];
  leave(gas, b, nx[i], ny[i], slow);
  const wb = 1 / mass[b];
  const sum = shareA + wb * share;
  if (!(sum > 0)) return;
  const size = (PART * depth) / sum;
  gas.x[a] += ax * (size * wa);
  gas.y[a] += ay * (size * wa);
  gas.x[b] += leftX * (size * wb);
  gas.y[b] += leftY * (size * wb);
}

/** How far body i can follow a push along (x, y): a wall it is at takes its part. */
function leave({ vx, vy, wall, wallGap }: Gas, i: number, x: number, y: number, slow: number): void {
  leftX = x;
  leftY = y;
  share = 1;
  const mx = wall[i] === 1 ? 1 : wall[i] === 2 ? -1 : 0;
  const my = wall[i] === 3 ? 1 : wall[i] === 4 ? -1 : 0;
  const cosine = x * mx + y * my;
  if (!(cosine < 0) || vx[i] * mx + vy[i] * my + wallGap[i] > slow) return;
  leftX = x - cosine * mx;
  leftY = y - cosine * my;
  share = Math.max(0, 1 - cosine * cosine);
}
