import { kick } from './impacts.ts';
import type { Balls } from './state.ts';
import { leave, left } from './walls.ts';

const MOST_SWEEPS = 10;
const ENOUGH = 1e-4;

/** A speed that makes no difference: a hundredth of what the largest acceleration gives in a step. */
let slow = 0;

/** Resting contacts: sequential impulses that start from those of the last step. */
export function holdResting(balls: Balls): void {
  const { dt, order, holding, impulse } = balls;
  const { count, most } = chooseResting(balls);
  if (count === 0) return;
  const speed = Math.sqrt(most) * dt;
  slow = speed * 0.01;
  for (let k = 0; k < count; k++) {
    const i = order[k];
    const from = holding[i];
    holding[i] = 0;
    if (from > 0) press(balls, i, from, 0.5 * dt);
  }
  for (let sweep = 0; sweep < MOST_SWEEPS; sweep++) {
    let change = 0;
    for (let k = 0; k < balls.walls; k++) change = Math.max(change, pressWall(balls, k));
    for (let k = 0; k < count; k++) {
      change = Math.max(change, pressPair(balls, order[sweep % 2 === 0 ? k : count - 1 - k]));
    }
    if (change <= speed * ENOUGH) break;
  }
  for (let k = 0; k < count; k++) impulse[order[k]] += holding[order[k]];
}

/** Lists the contacts that rest. Returns their number and the square of the largest acceleration among them. */
function chooseResting(balls: Balls): { count: number; most: number } {
  const { contacts, a, b, ax, ay, az, flat, dt, gap, order, holding, inverseMass } = balls;
  let count = 0;
  let most = 0;
  for (let i = 0; i < contacts; i++) {
    const [p, q] = [a[i], b[i]];
    const first = ax[p] * ax[p] + ay[p] * ay[p] + (flat ? 0 : az[p] * az[p]);
    const second = ax[q] * ax[q] + ay[q] * ay[q] + (flat ? 0 : az[q] * az[q]);
    const acceleration = Math.max(first, second);
    const pressed = holding[i] * (inverseMass[p] + inverseMass[q]);
    if (!rests(balls, i, pressed, 2 * dt * Math.sqrt(acceleration))) {
      holding[i] = 0;
      continue;
    }
    gap[i] = Math.max(0, gap[i]);
    order[count++] = i;
    most = Math.max(most, acceleration);
  }
  return { count, most };
}

/** Whether contact i rests; notes its gap, and its normal if so. */
function rests(balls: Balls, i: number, pressed: number, usual: number): boolean {
  const { flat, x, y, z, vx, vy, vz, ax, ay, az, radius, restitution, dt, nx, ny, nz } = balls;
  const a = balls.a[i];
  const b = balls.b[i];
  const dx = x[b] - x[a];
  const dy = y[b] - y[a];
  const dz = flat ? 0 : z[b] - z[a];
  const distance = Math.sqrt(dx * dx + dy * dy + dz * dz);
  const gap = distance - (radius[a] + radius[b]);
  const px = dx / distance;
  const py = dy / distance;
  const pz = dz / distance;
  const closing = -((vx[b] - vx[a]) * px + (vy[b] - vy[a]) * py + (flat ? 0 : (vz[b] - vz[a]) * pz));
  const along = (ax[b] - ax[a]) * px + (ay[b] - ay[a]) * py + (flat ? 0 : (az[b] - az[a]) * pz);
  const acceleration = Math.max(0, -along);
  const e = Math.max(restitution[a], restitution[b]);
  if (!decide(gap, closing, acceleration, e, pressed, Math.max(pressed, usual), dt)) return false;
  nx[i] = px;
  ny[i] = py;
  if (!flat) nz[i] = pz;
  balls.gap[i] = gap;
  return true;
}

function decide(
  gap: number,
  closing: number,
  acceleration: number,
  e: number,
  pressed: number,
  some: number,
  dt: number,
): boolean {
  if (!(closing > 0)) return -closing <= some && (some > 0 || e === 0);
  const half = 0.5 * Math.max(pressed, acceleration * dt);
  if (gap > 0) return closing <= some && e * closing <= half;
  if (e < 1) return true;
  const depth = -gap;
  const then = Math.sqrt(Math.max(0, closing * closing - acceleration * (depth + depth)));
  const since = Math.min((depth + depth) / (then + closing), dt);
  return e * Math.max(0, closing - acceleration * since) <= half;
}

/** Brings a wall's impulse on a body up to date. Returns the change of velocity. */
function pressWall(balls: Balls, k: number): number {
  const { wallBody, wallAxis, wallSide, wallGap, wallHolding, met, inverseMass, vx, vy, vz, dt } = balls;
  const i = wallBody[k];
  if (met[i] === 0) return 0;
  const axis = wallAxis[k];
  const side = wallSide[k];
  const w = inverseMass[i];
  const excess = (axis === 0 ? vx : axis === 1 ? vy : vz)[i] * side + wallGap[k];
  if (excess >= 0 && wallHolding[k] === 0) return 0;
  const impulse = Math.max(-wallHolding[k], -excess / w);
  bear(balls, k, impulse);
  kick(balls, i, impulse * w * side, axis === 0 ? 1 : 0, axis === 1 ? 1 : 0, axis === 2 ? 1 : 0, 0.5 * dt);
  return Math.abs(impulse * w);
}

function bear({ wallHolding, wallImpulse }: Balls, k: number, impulse: number): void {
  wallHolding[k] += impulse;
  wallImpulse[k] += impulse;
}

/** Brings the impulse of a resting contact up to date. Returns the change of velocity. */
function pressPair(balls: Balls, i: number): number {
  const { flat, x, y, z, vx, vy, vz, radius, inverseMass, holding, dt } = balls;
  const a = balls.a[i];
  const b = balls.b[i];
  const nx = balls.nx[i];
  const ny = balls.ny[i];
  const nz = flat ? 0 : balls.nz[i];
  const closing = (vx[b] - vx[a]) * nx + (vy[b] - vy[a]) * ny + (flat ? 0 : (vz[b] - vz[a]) * nz);
  const excess = closing + balls.gap[i] / dt;
  const before = holding[i];
  if (excess >= 0 && before === 0) return 0;
  let w = inverseMass[a] + inverseMass[b];
  if (balls.wallOf[a] !== 0 || balls.wallOf[b] !== 0) {
    leave(balls, a, -nx, -ny, -nz, slow);
    w = inverseMass[a] * left.share;
    leave(balls, b, nx, ny, nz, slow);
    w += inverseMass[b] * left.share;
  }
  if (!(w > 0)) return 0;
  const impulse = Math.max(-before, -excess / w);
  let time = 0.5 * dt;
  if (impulse > 0) {
    const along = (x[b] - x[a]) * nx + (y[b] - y[a]) * ny + (flat ? 0 : (z[b] - z[a]) * nz);
    time = Math.max(time, Math.min(dt, -(along - (radius[a] + radius[b])) / (impulse * w)));
  }
  return press(balls, i, impulse, time);
}

/** Applies an impulse to both bodies of contact i, walls answering. Returns the change of velocity. */
function press(balls: Balls, i: number, impulse: number, time: number): number {
  if (impulse === 0) return 0;
  const { flat, inverseMass, nx, ny, nz, holding } = balls;
  const a = balls.a[i];
  const b = balls.b[i];
  holding[i] += impulse;
  const z = flat ? 0 : nz[i];
  pressBody(balls, a, -nx[i], -ny[i], -z, impulse, time);
  pressBody(balls, b, nx[i], ny[i], z, impulse, time);
  return Math.abs(impulse) * Math.max(inverseMass[a], inverseMass[b]);
}

function pressBody(balls: Balls, i: number, x: number, y: number, z: number, impulse: number, time: number): void {
  const change = impulse * balls.inverseMass[i];
  if (balls.wallOf[i] === 0) {
    kick(balls, i, change, x, y, z, time);
    return;
  }
  leave(balls, i, x, y, z, slow);
  if (left.wall >= 0) bear(balls, left.wall, -impulse * left.cosine);
  kick(balls, i, change, left.x, left.y, left.z, time);
}
