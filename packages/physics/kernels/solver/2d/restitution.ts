// Bouncing, after the last sub-step: a point that was hit faster than the threshold gets the speed e u away from the surface,
// where u is the speed along the normal before the step. Source: Catto, Solver2D (2024).
//
// Where both points of a contact were hit, their impulses P solve K (P - P_old) = -(v + e u) together. One after the other
// would be unequal although the points are alike: a box that falls flat would bounce askew, and lose energy.
import { get, put } from '../../memory/columns';
import { LANES } from '../../memory/lanes';
import { BodyState, word } from './body';
import * as block from './contact-block';
import { RigidTable } from './rigid-table';

// Two points so close that the determinant of K is less than this part of the product of its diagonal are taken one by one.
const LEAST_DETERMINANT: real = 1e-3;

export function applyRestitution(table: usize): void {
  const t = changetype<RigidTable>(table);
  for (let i = 0; i < t.blockCount; i++) {
    const at = block.blockOf(t, i);
    for (let l = 0; l < LANES; l++) {
      const restitution = get(at + block.RESTITUTION, l);
      if (restitution != 0) bounce(t, at, l, restitution);
    }
  }
}

function bounce(t: RigidTable, at: usize, l: i32, restitution: real): void {
  const first = at + block.POINTS;
  const second = first + block.POINT;
  if (isHit(t, first, l) && isHit(t, second, l) && bounceTogether(at, first, second, l, restitution)) return;
  for (let p = first; p <= second; p += block.POINT) {
    if (isHit(t, p, l)) bounceAlone(at, p, l, restitution);
  }
}

function isHit(t: RigidTable, p: usize, l: i32): bool {
  return get(p + block.NORMAL_SPEED, l) <= -(<real>t.restitutionThreshold) && get(p + block.TOTAL_IMPULSE, l) != 0;
}

function bounceAlone(at: usize, p: usize, l: i32, restitution: real): void {
  const mass = get(p + block.NORMAL_MASS, l);
  setImpulse(at, p, l, get(p + block.NORMAL_IMPULSE, l) - mass * excessSpeed(at, p, l, restitution));
}

// Returns false, and changes nothing, where one of the points would have to pull.
function bounceTogether(at: usize, p: usize, q: usize, l: i32, restitution: real): bool {
  const pp = <real>1 / get(p + block.NORMAL_MASS, l);
  const qq = <real>1 / get(q + block.NORMAL_MASS, l);
  const pq = coupling(at, p, q, l);
  const determinant = pp * qq - pq * pq;
  if (!(determinant > LEAST_DETERMINANT * pp * qq)) return false;
  const speedP = excessSpeed(at, p, l, restitution);
  const speedQ = excessSpeed(at, q, l, restitution);
  const impulseP = get(p + block.NORMAL_IMPULSE, l) - (qq * speedP - pq * speedQ) / determinant;
  const impulseQ = get(q + block.NORMAL_IMPULSE, l) - (pp * speedQ - pq * speedP) / determinant;
  if (!(impulseP >= 0 && impulseQ >= 0)) return false;
  setImpulse(at, p, l, impulseP);
  setImpulse(at, q, l, impulseQ);
  return true;
}

function leverOf(at: usize, x: real, y: real, l: i32): real {
  return x * get(at + block.NY, l) - y * get(at + block.NX, l);
}

// The speed that an impulse of 1 N s at one of two points gives the other, along the normal.
function coupling(at: usize, p: usize, q: usize, l: i32): real {
  const nx = get(at + block.NX, l);
  const ny = get(at + block.NY, l);
  const leversA =
    leverOf(at, get(p + block.AX, l), get(p + block.AY, l), l) *
    leverOf(at, get(q + block.AX, l), get(q + block.AY, l), l);
  const leversB =
    leverOf(at, get(p + block.BX, l), get(p + block.BY, l), l) *
    leverOf(at, get(q + block.BX, l), get(q + block.BY, l), l);
  const x = get(at + block.MASS_AX, l) + get(at + block.MASS_BX, l);
  const y = get(at + block.MASS_AY, l) + get(at + block.MASS_BY, l);
  return x * nx * nx + y * ny * ny + get(at + block.INERTIA_A, l) * leversA + get(at + block.INERTIA_B, l) * leversB;
}

// The speed of a point along the normal less the one with which it should bounce, m/s.
function excessSpeed(at: usize, p: usize, l: i32, restitution: real): real {
  const a = changetype<BodyState>(<usize>word(at + block.A, l));
  const b = changetype<BodyState>(<usize>word(at + block.B, l));
  const vx = b.vx - b.w * get(p + block.BY, l) - (a.vx - a.w * get(p + block.AY, l));
  const vy = b.vy + b.w * get(p + block.BX, l) - (a.vy + a.w * get(p + block.AX, l));
  return get(at + block.NX, l) * vx + get(at + block.NY, l) * vy + restitution * get(p + block.NORMAL_SPEED, l);
}

function setImpulse(at: usize, p: usize, l: i32, wanted: real): void {
  const a = changetype<BodyState>(<usize>word(at + block.A, l));
  const b = changetype<BodyState>(<usize>word(at + block.B, l));
  const nx = get(at + block.NX, l);
  const ny = get(at + block.NY, l);
  const impulse = wanted > 0 ? min<real>(wanted, block.MAX_IMPULSE) : <real>0;
  const delta = impulse - get(p + block.NORMAL_IMPULSE, l);
  put(p + block.NORMAL_IMPULSE, l, impulse);
  put(p + block.TOTAL_IMPULSE, l, get(p + block.TOTAL_IMPULSE, l) + delta);
  a.vx -= get(at + block.MASS_AX, l) * delta * nx;
  a.vy -= get(at + block.MASS_AY, l) * delta * ny;
  a.w -= get(at + block.INERTIA_A, l) * delta * leverOf(at, get(p + block.AX, l), get(p + block.AY, l), l);
  b.vx += get(at + block.MASS_BX, l) * delta * nx;
  b.vy += get(at + block.MASS_BY, l) * delta * ny;
  b.w += get(at + block.INERTIA_B, l) * delta * leverOf(at, get(p + block.BX, l), get(p + block.BY, l), l);
}
