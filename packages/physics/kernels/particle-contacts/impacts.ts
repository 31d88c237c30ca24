// Impacts are contacts whose rebound the step can resolve. Each is solved at the instant the surfaces met.
//
// Seen from the end of the step, the bodies touched a time t ago, with normal n and closing speed s. The impulse of a
// collision with restitution e is
//     J = (1 + e) s / (1/m_a + 1/m_b).
// The new velocities hold since then, so positions change by (change of velocity) * t. An isolated pair is therefore
// exact under any constant acceleration; momentum is conserved to rounding, and so is energy where e = 1.
//
// Surfaces that meet exactly at the end of the step collide in it, a time 0 ago: left to resting-contacts.ts they would
// lose their rebound.
//
// Impacts are solved in time slices of dt/64, earliest first, and within a slice in ascending (a, b). A collision can
// cause others, so the contacts of bodies that collided are tested again, at most three more times; later collisions
// are left to the next step. Impacts elsewhere in the scene do not affect the result.
//
// If `pressingSpeed` is the speed by which external forces press the two together in a step, a rebound at e s returns
// after 2 e s dt / pressingSpeed. If that is within the step, the contact is at rest and resting-contacts.ts solves it;
// a body that arrives fast still loses its speed here, at the exact instant.
import { Columns, get, put } from '../memory/columns';
import { approach, readRelativeMotion, readSeparation } from './approach';
import { Body, body, applyVelocityChange } from './body';
import { applyFriction } from './friction';
import { MAX_DEPTH, noteImpact, noteVector } from './impact-list';
import { ContactTable, FINITE, putWord, word } from './table';
import { roundImpact, timeSinceRoundImpact } from './time-of-impact';

// Flag of a contact that collided in this step.
const COLLIDED: i32 = 1;

const SLICES: i32 = 64;
const MAX_PASSES: i32 = 4;

export function resolveImpacts(c: Columns, t: ContactTable, dt: real, lag: real): void {
  const count = orderByTime(t, dt, lag);
  if (count == 0) return;
  memory.fill(t.rowWords, 0, (<usize>t.bodyCount) << 2);
  let hitCount = 0;
  for (let k = 0; k < count; k++) hitCount += collide(c, t, word(t.order, k), dt, lag, 1);
  for (let pass = 1; pass < MAX_PASSES && hitCount > 0; pass++) {
    hitCount = 0;
    for (let i = 0; i < t.count; i++) {
      const latest = max<i32>(word(t.rowWords, word(t.slotA, i)), word(t.rowWords, word(t.slotB, i)));
      if (latest >= pass) hitCount += collide(c, t, i, dt, lag, pass + 1);
    }
  }
}

// Lists the contacts that may collide, earliest slice first, and returns their count.
function orderByTime(t: ContactTable, dt: real, lag: real): i32 {
  const ends = t.histogram;
  memory.fill(ends, 0, (SLICES + 1) << 2);
  const inverseDt = <real>1 / dt;
  for (let i = 0; i < t.count; i++) {
    const slice = sliceOf(t, i, dt, inverseDt, lag);
    putWord(t.flags, i, slice << 2);
    if (slice >= 0) putWord(ends, slice + 1, word(ends, slice + 1) + 1);
  }
  for (let s = 0; s < SLICES; s++) putWord(ends, s + 1, word(ends, s + 1) + word(ends, s));
  const total = word(ends, SLICES);
  for (let i = 0; i < t.count; i++) {
    const slice = word(t.flags, i) >> 2;
    putWord(t.flags, i, 0);
    if (slice < 0) continue;
    const position = word(ends, slice);
    putWord(ends, slice, position + 1);
    putWord(t.order, position, i);
  }
  return total;
}

// Returns the time slice in which a contact happened, 0 being the earliest, or -1 if it cannot collide.
function sliceOf(t: ContactTable, i: i32, dt: real, inverseDt: real, lag: real): i32 {
  const a = body(t, word(t.slotA, i));
  const b = body(t, word(t.slotB, i));
  readSeparation(a, b);
  readRelativeMotion(a, b, word(t.a, i), word(t.b, i), t.layer == 0, lag);
  put(t.nx, i, approach.nx);
  put(t.ny, i, approach.ny);
  put(t.nz, i, approach.nz);
  put(t.speed, i, speedBeforeStep(dt));
  const reach = a.radius + b.radius;
  if (!(approach.distance <= reach)) return -1;
  const timeSinceImpact = timeSinceRoundImpact(
    approach.x,
    approach.y,
    approach.z,
    approach.vx,
    approach.vy,
    approach.vz,
    0,
    0,
    0,
    reach,
    dt,
  );
  if (timeSinceImpact >= 0) return max<i32>(0, SLICES - 1 - <i32>(timeSinceImpact * inverseDt * <real>SLICES));
  if (!(approach.vx * approach.nx + approach.vy * approach.ny + approach.vz * approach.nz < 0)) return -1;
  return approach.distance < reach ? 0 : SLICES - 1;
}

// Returns the speed of approach along the normal when the step began.
// @ts-ignore: decorator
@inline function speedBeforeStep(dt: real): real {
  const x = approach.vx - approach.ax * dt;
  const y = approach.vy - approach.ay * dt;
  const z = approach.vz - approach.az * dt;
  return -(x * approach.nx + y * approach.ny + z * approach.nz);
}

// Solves the impact of contact i if there is one, and marks its bodies with the number of this `pass`. Returns 1 if the
// bodies collided.
function collide(c: Columns, t: ContactTable, i: i32, dt: real, lag: real, pass: i32): i32 {
  const a = body(t, word(t.slotA, i));
  const b = body(t, word(t.slotB, i));
  const reach = a.radius + b.radius;
  readSeparation(a, b);
  if (!(approach.distance <= reach)) return 0;
  const rowA = word(t.a, i);
  const rowB = word(t.b, i);
  readRelativeMotion(a, b, rowA, rowB, t.layer == 0, lag);
  const closing = -(approach.vx * approach.nx + approach.vy * approach.ny + approach.vz * approach.nz);
  const flags = word(t.flags, i);
  // Bodies that passed through each other within the step are separating by now, as are bodies that already collided.
  if (!(closing > 0) && (flags & COLLIDED) != 0) return 0;
  let timeSinceImpact = timeSinceRoundImpact(
    approach.x,
    approach.y,
    approach.z,
    approach.vx,
    approach.vy,
    approach.vz,
    approach.ax,
    approach.ay,
    approach.az,
    reach,
    dt,
  );
  let x = approach.nx;
  let y = approach.ny;
  let z = approach.nz;
  let speed = closing;
  if (timeSinceImpact >= 0) {
    x = roundImpact.nx;
    y = roundImpact.ny;
    z = roundImpact.nz;
    speed = roundImpact.speed;
  } else {
    // The bodies touched before the step began and overlapped for all of it, or they touch just now, and the root of the
    // quadratic is below zero by rounding.
    timeSinceImpact = approach.distance < reach ? dt : <real>0;
  }
  if (!(speed > 0)) return 0;
  let e = max<real>(get(c.restitution, rowA), get(c.restitution, rowB));
  const wa = a.inverseMass;
  const wb = b.inverseMass;
  // The weight of a pile acts through its contacts and is not part of the accelerations yet; the resting impulse of the
  // last step estimates it.
  const restingSpeed = get(t.accumulatedImpulse, i) * (wa + wb);
  const pressingSpeed = max<real>(restingSpeed, -(approach.ax * x + approach.ay * y + approach.az * z) * dt);
  if (e * speed <= <real>0.5 * pressingSpeed) {
    if (speed <= <real>2 * pressingSpeed) return 0;
    e = 0;
  }
  return strike(c, t, i, a, b, x, y, z, speed, e, timeSinceImpact, pass);
}

// Lets two bodies collide at `speed` along the normal (x, y, z), a time ago. Returns 1 if they did.
//
// Under forces that depend on position or velocity the mean acceleration is not that after the impact, and an elastic
// impact a time ago would gain or lose energy. It acts at the end of the step instead, on the velocities there: that
// keeps the energy whatever the forces are. The bodies part in the next step; where they got too deep into each other for
// that, the impact acts when it was.
function strike(
  c: Columns,
  t: ContactTable,
  i: i32,
  a: Body,
  b: Body,
  x: real,
  y: real,
  z: real,
  speed: real,
  e: real,
  timeSinceImpact: real,
  pass: i32,
): i32 {
  const wa = a.inverseMass;
  const wb = b.inverseMass;
  let closing = speed;
  let time = timeSinceImpact;
  if (t.isUneven != 0 && e >= 1 && speed * time <= MAX_DEPTH * (a.radius + b.radius)) {
    const last = -(approach.vx * x + approach.vy * y + approach.vz * z);
    if (last > 0) {
      closing = last;
      time = 0;
    }
  }
  const impulse = ((<real>1 + e) * closing) / (wa + wb);
  if (!(impulse > 0 && impulse < FINITE && impulse * wa < FINITE && impulse * wb < FINITE)) return 0;
  put(t.nx, i, x);
  put(t.ny, i, y);
  put(t.nz, i, z);
  const flags = word(t.flags, i);
  // Of several impacts in a step the fastest is reported.
  put(t.speed, i, (flags & COLLIDED) == 0 ? speed : max<real>(speed, get(t.speed, i)));
  put(t.impulse, i, get(t.impulse, i) + impulse);
  putWord(t.flags, i, flags | COLLIDED);
  if (wa > 0) putWord(t.rowWords, word(t.slotA, i), pass);
  if (wb > 0) putWord(t.rowWords, word(t.slotB, i), pass);
  const ja = -impulse * wa;
  const jb = impulse * wb;
  applyVelocityChange(a, ja * x, ja * y, ja * z, time);
  applyVelocityChange(b, jb * x, jb * y, jb * z, time);
  applyFrictionAndNote(c, t, i, a, b, x, y, z, e, impulse, time, timeSinceImpact);
  return 1;
}

// Applies the friction of an impact that acted a `time` ago, and notes the impact.
function applyFrictionAndNote(
  c: Columns,
  t: ContactTable,
  i: i32,
  a: Body,
  b: Body,
  x: real,
  y: real,
  z: real,
  e: real,
  impulse: real,
  time: real,
  timeSinceImpact: real,
): void {
  const moved = a.inverseMass > 0 ? a : b;
  const vx = moved.vx;
  const vy = moved.vy;
  const vz = moved.vz;
  const friction = sqrt<real>(get(c.friction, word(t.a, i)) * get(c.friction, word(t.b, i)));
  applyFriction(a, b, x, y, z, friction, impulse, time);
  const note = noteImpact(t, word(t.slotA, i), word(t.slotB, i), e, timeSinceImpact);
  const mass = (a.inverseMass > 0 ? -(<real>1) : <real>1) / moved.inverseMass;
  if (note != 0) noteVector(note, mass * (moved.vx - vx), mass * (moved.vy - vy), mass * (moved.vz - vz));
}
