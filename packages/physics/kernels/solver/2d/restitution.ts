// Bouncing, after the last sub-step: a point that was hit faster than the threshold gets the speed e u away from the surface,
// where u is the speed along the normal at the impact: u² = u₀² - 2 a s, from the speed u₀ and the separation s before the step,
// with the acceleration a by forces. Source: Catto, Solver2D (2024), where it is u₀.
//
// Where both points of a contact were hit, their impulses P solve K (P - P_old) = -(v + e u) together. One after the other
// would be unequal although the points are alike: a box that falls flat would bounce askew, and lose energy.
import { ContactPoint, RigidContact, contactAt, pointOf } from '../../collision/narrow-phase/2d/rigid-contact';
import { get, put } from '../../memory/columns';
import { LANES } from '../../memory/lanes';
import { BodyState, MOVES, flagsOf, word } from './body';
import * as block from './contact-block';
import { inverseMassX, inverseMassY } from './motion-locks';
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
  const isFirstHit = isHit(t, first, l);
  const isSecondHit = isHit(t, second, l);
  if (!isFirstHit && !isSecondHit) return;
  const contact = contactAt(t, word(at + block.SLOT, l));
  const away = accelerationOf(t, contact);
  const firstSpeed = -restitution * impactSpeed(first, l, pointOf(contact, 0), away);
  const secondSpeed = contact.count > 1 ? -restitution * impactSpeed(second, l, pointOf(contact, 1), away) : <real>0;
  if (isFirstHit && isSecondHit && bounceTogether(at, first, second, l, firstSpeed, secondSpeed)) return;
  if (isFirstHit) bounceAlone(at, first, l, firstSpeed);
  if (isSecondHit) bounceAlone(at, second, l, secondSpeed);
}

function isHit(t: RigidTable, p: usize, l: i32): bool {
  return get(p + block.NORMAL_SPEED, l) <= -(<real>t.restitutionThreshold) && get(p + block.TOTAL_IMPULSE, l) != 0;
}

// By how much forces accelerate the two bodies from each other along the normal, m/s². What touches other bodies, too, is borne by
// them.
function accelerationOf(t: RigidTable, contact: RigidContact): real {
  return accelerationAlong(t, contact.bodyB, contact) - accelerationAlong(t, contact.bodyA, contact);
}

function accelerationAlong(t: RigidTable, row: i32, contact: RigidContact): real {
  if ((flagsOf(t, row) & MOVES) == 0 || popcnt<u32>(word(t.usedColors, row)) > 1) return 0;
  const x = inverseMassX(t, row) * get(t.forceX, row);
  const y = inverseMassY(t, row) * get(t.forceY, row);
  return contact.nx * x + contact.ny * y;
}

// The speed along the normal with which the surfaces meet at a point, below 0, m/s.
function impactSpeed(p: usize, l: i32, point: ContactPoint, acceleration: real): real {
  const speed = get(p + block.NORMAL_SPEED, l);
  const gained = <real>-2 * acceleration * max<real>(0, point.separation);
  return -sqrt<real>(max<real>(0, speed * speed + gained));
}

function bounceAlone(at: usize, p: usize, l: i32, wanted: real): void {
  const mass = get(p + block.NORMAL_MASS, l);
  setImpulse(at, p, l, get(p + block.NORMAL_IMPULSE, l) + mass * missingSpeed(at, p, l, wanted));
}

// Returns false, and changes nothing, where one of the points would have to pull.
function bounceTogether(at: usize, p: usize, q: usize, l: i32, wantedP: real, wantedQ: real): bool {
  const pp = <real>1 / get(p + block.NORMAL_MASS, l);
  const qq = <real>1 / get(q + block.NORMAL_MASS, l);
  const pq = coupling(at, p, q, l);
  const determinant = pp * qq - pq * pq;
  if (!(determinant > LEAST_DETERMINANT * pp * qq)) return false;
  const speedP = missingSpeed(at, p, l, wantedP);
  const speedQ = missingSpeed(at, q, l, wantedQ);
  const impulseP = get(p + block.NORMAL_IMPULSE, l) + (qq * speedP - pq * speedQ) / determinant;
  const impulseQ = get(q + block.NORMAL_IMPULSE, l) + (pp * speedQ - pq * speedP) / determinant;
  if (!(impulseP >= 0 && impulseQ >= 0)) return false;
  setImpulse(at, p, l, impulseP);
  setImpulse(at, q, l, impulseQ);
  return true;
}

// The speed that an impulse of 1 N s at one of two points gives the other, along the normal.
function coupling(at: usize, p: usize, q: usize, l: i32): real {
  const nx = get(at + block.NX, l);
  const ny = get(at + block.NY, l);
  const leversA = get(p + block.NORMAL_LEVER_A, l) * get(q + block.NORMAL_LEVER_A, l);
  const leversB = get(p + block.NORMAL_LEVER_B, l) * get(q + block.NORMAL_LEVER_B, l);
  const x = get(at + block.MASS_AX, l) + get(at + block.MASS_BX, l);
  const y = get(at + block.MASS_AY, l) + get(at + block.MASS_BY, l);
  return x * nx * nx + y * ny * ny + get(at + block.INERTIA_A, l) * leversA + get(at + block.INERTIA_B, l) * leversB;
}

// What a point lacks to the speed with which it should bounce, along the normal, m/s.
function missingSpeed(at: usize, p: usize, l: i32, wanted: real): real {
  const a = changetype<BodyState>(<usize>word(at + block.A, l));
  const b = changetype<BodyState>(<usize>word(at + block.B, l));
  const turning = b.w * get(p + block.NORMAL_LEVER_B, l) - a.w * get(p + block.NORMAL_LEVER_A, l);
  return wanted - (get(at + block.NX, l) * (b.vx - a.vx) + get(at + block.NY, l) * (b.vy - a.vy) + turning);
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
  a.w -= get(at + block.INERTIA_A, l) * delta * get(p + block.NORMAL_LEVER_A, l);
  b.vx += get(at + block.MASS_BX, l) * delta * nx;
  b.vy += get(at + block.MASS_BY, l) * delta * ny;
  b.w += get(at + block.INERTIA_B, l) * delta * get(p + block.NORMAL_LEVER_B, l);
}
