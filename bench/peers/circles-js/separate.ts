import type { Gas } from './state';

const PART = 0.5;
const MOST_SPEED = 4;

/** Displaces discs that overlap and will still do so when the next step ends. */
export function separate(gas: Gas): void {
  const { contacts, a, b, pushX, pushY } = gas;
  for (let i = 0; i < contacts; i++) {
    pushX[a[i]] = pushY[a[i]] = 0;
    pushX[b[i]] = pushY[b[i]] = 0;
  }
  let any = false;
  for (let i = 0; i < contacts; i++) any = push(gas, i) || any;
  if (!any) return;
  for (let i = 0; i < contacts; i++) {
    move(gas, a[i]);
    move(gas, b[i]);
  }
}

let leftX = 0;
let leftY = 0;
let share = 0;

function push(gas: Gas, i: number): boolean {
  const { x, y, vx, vy, radius, mass, nx, ny, dt } = gas;
  const a = gas.a[i];
  const b = gas.b[i];
  const dx = x[b] - x[a];
  const dy = y[b] - y[a];
  const overlap = radius[a] + radius[b] - Math.sqrt(dx * dx + dy * dy);
  if (!(overlap > 0)) return false;
  const speed = (vx[b] - vx[a]) * nx[i] + (vy[b] - vy[a]) * ny[i];
  const depth = overlap - Math.max(0, speed * dt);
  if (!(depth > 0)) return false;
  const slow = (0.01 * depth) / dt;
  leave(gas, a, -nx[i], -ny[i], slow);
  const wa = 1 / mass[a];
  const [ax, ay, shareA] = [leftX, leftY, wa * share];
  leave(gas, b, nx[i], ny[i], slow);
  const wb = 1 / mass[b];
  const sum = shareA + wb * share;
  if (!(sum > 0)) return false;
  const size = (PART * depth) / sum;
  gas.pushX[a] += ax * (size * wa);
  gas.pushY[a] += ay * (size * wa);
  gas.pushX[b] += leftX * (size * wb);
  gas.pushY[b] += leftY * (size * wb);
  return true;
}

/** How far body i can follow a push along (x, y): a wall it is at takes its part. */
function leave({ vx, vy, wall, wallGap, dt }: Gas, i: number, x: number, y: number, slow: number): void {
  leftX = x;
  leftY = y;
  share = 1;
  const mx = wall[i] === 1 ? 1 : wall[i] === 2 ? -1 : 0;
  const my = wall[i] === 3 ? 1 : wall[i] === 4 ? -1 : 0;
  const cosine = x * mx + y * my;
  if (!(cosine < 0) || vx[i] * mx + vy[i] * my + wallGap[i] / dt > slow) return;
  leftX = x - cosine * mx;
  leftY = y - cosine * my;
  share = Math.max(0, 1 - cosine * cosine);
}

function move({ x, y, radius, pushX, pushY, dt }: Gas, i: number): void {
  const length = Math.sqrt(pushX[i] * pushX[i] + pushY[i] * pushY[i]);
  if (!(length > 0)) return;
  const most = MOST_SPEED * radius[i] * dt;
  const scale = length > most ? most / length : 1;
  x[i] += pushX[i] * scale;
  y[i] += pushY[i] * scale;
  pushX[i] = pushY[i] = 0;
}
