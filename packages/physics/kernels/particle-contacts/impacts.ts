// Impacts: contacts whose rebound the step can resolve, each at the instant the surfaces met.
//
// Looking back from the end of the step, the bodies touched a time `since` ago, with normal n and closing speed s. The
// impulse of a collision with restitution e is
//     J = (1 + e) s / (1/m_a + 1/m_b),
// and as the new velocities hold since then, positions change by (change of velocity) * since. An isolated pair is thus
// exact under any constant acceleration, momentum is kept to rounding, and energy where e = 1.
//
// The earliest come first, in slices of dt/64; within a slice in ascending (a, b). Collisions may set off others, so the
// contacts of bodies that collided are looked at again, at most three times more; what is left then collides in the next
// step. What happens elsewhere makes no difference.
//
// With `pull` the speed that presses the two together in a step, a rebound at e s is back after 2 e s dt / pull. Where
// that is within the step the bodies are at rest on each other and `rest.ts` holds them; one that came in fast still
// gives up its speed here, at the right instant.
import { Columns, get, put } from '../memory/columns';
import { approach, readApproach, readPlace } from './approach';
import { body, kick } from './body';
import { rub } from './friction';
import { ContactTable, FINITE, putWord, word } from './table';
import { touch, touchTime } from './time-of-impact';

// A contact's flag in this step.
const COLLIDED: i32 = 1;

const SLICES: i32 = 64;
const MOST_SWEEPS: i32 = 4;

export function resolveImpacts(c: Columns, t: ContactTable, dt: real, lag: real): void {
  const count = orderByTime(t, dt, lag);
  if (count == 0) return;
  memory.fill(t.rowWords, 0, (<usize>t.bodyCount) << 2);
  let hit = 0;
  for (let k = 0; k < count; k++) hit += collide(c, t, word(t.order, k), dt, lag, 1);
  for (let sweep = 1; sweep < MOST_SWEEPS && hit > 0; sweep++) {
    hit = 0;
    for (let i = 0; i < t.count; i++) {
      const latest = max<i32>(word(t.rowWords, word(t.slotA, i)), word(t.rowWords, word(t.slotB, i)));
      if (latest >= sweep) hit += collide(c, t, i, dt, lag, sweep + 1);
    }
  }
}

// Lists the contacts that may collide, earliest slice first, and returns their number.
function orderByTime(t: ContactTable, dt: real, lag: real): i32 {
  const ends = t.histogram;
  memory.fill(ends, 0, (SLICES + 1) << 2);
  const rate = <real>1 / dt;
  for (let i = 0; i < t.count; i++) {
    const slice = sliceOf(t, i, dt, rate, lag);
    putWord(t.flags, i, slice << 2);
    if (slice >= 0) putWord(ends, slice + 1, word(ends, slice + 1) + 1);
  }
  for (let s = 0; s < SLICES; s++) putWord(ends, s + 1, word(ends, s + 1) + word(ends, s));
  const total = word(ends, SLICES);
  for (let i = 0; i < t.count; i++) {
    const slice = word(t.flags, i) >> 2;
    putWord(t.flags, i, 0);
    if (slice < 0) continue;
    const place = word(ends, slice);
    putWord(ends, slice, place + 1);
    putWord(t.order, place, i);
  }
  return total;
}

// The slice of the step in which a contact happened, 0 the earliest; -1 for one that cannot collide.
function sliceOf(t: ContactTable, i: i32, dt: real, rate: real, lag: real): i32 {
  const a = body(t, word(t.slotA, i));
  const b = body(t, word(t.slotB, i));
  readPlace(a, b);
  readApproach(a, b, word(t.a, i), word(t.b, i), t.layer == 0, lag);
  put(t.nx, i, approach.nx);
  put(t.ny, i, approach.ny);
  put(t.nz, i, approach.nz);
  const reach = a.radius + b.radius;
  if (!(approach.distance < reach)) return -1;
  const since = touchTime(
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
  if (since >= 0) return max<i32>(0, SLICES - 1 - <i32>(since * rate * <real>SLICES));
  return approach.vx * approach.nx + approach.vy * approach.ny + approach.vz * approach.nz < 0 ? 0 : -1;
}

// Lets contact i collide when it can, and notes with its bodies that they did in this `turn`. Returns 1 when it did.
function collide(c: Columns, t: ContactTable, i: i32, dt: real, lag: real, turn: i32): i32 {
  const a = body(t, word(t.slotA, i));
  const b = body(t, word(t.slotB, i));
  const reach = a.radius + b.radius;
  readPlace(a, b);
  if (!(approach.distance < reach)) return 0;
  const rowA = word(t.a, i);
  const rowB = word(t.b, i);
  readApproach(a, b, rowA, rowB, t.layer == 0, lag);
  const closing = -(approach.vx * approach.nx + approach.vy * approach.ny + approach.vz * approach.nz);
  const flags = word(t.flags, i);
  // Bodies that passed each other within the step move apart by now; those that have collided also do.
  if (!(closing > 0) && (flags & COLLIDED) != 0) return 0;
  let since = touchTime(
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
  if (since >= 0) {
    x = touch.x;
    y = touch.y;
    z = touch.z;
    speed = touch.speed;
  } else {
    // They touched before the step began, and moved into each other for all of it.
    since = dt;
  }
  if (!(speed > 0)) return 0;
  let e = max<real>(get(c.restitution, rowA), get(c.restitution, rowB));
  const wa = a.inverseMass;
  const wb = b.inverseMass;
  // What presses on a pile comes through it, and is not yet seen in the accelerations: the last step tells.
  const pressed = get(t.holding, i) * (wa + wb);
  const pull = max<real>(pressed, -(approach.ax * x + approach.ay * y + approach.az * z) * dt);
  if (e * speed <= <real>0.5 * pull) {
    if (speed <= <real>2 * pull) return 0;
    e = 0;
  }
  const impulse = ((<real>1 + e) * speed) / (wa + wb);
  if (!(impulse > 0 && impulse < FINITE && impulse * wa < FINITE && impulse * wb < FINITE)) return 0;
  put(t.nx, i, x);
  put(t.ny, i, y);
  put(t.nz, i, z);
  put(t.impulse, i, get(t.impulse, i) + impulse);
  putWord(t.flags, i, flags | COLLIDED);
  if (wa > 0) putWord(t.rowWords, word(t.slotA, i), turn);
  if (wb > 0) putWord(t.rowWords, word(t.slotB, i), turn);
  const ja = -impulse * wa;
  const jb = impulse * wb;
  kick(a, ja * x, ja * y, ja * z, since);
  kick(b, jb * x, jb * y, jb * z, since);
  rub(a, b, x, y, z, sqrt<real>(get(c.friction, rowA) * get(c.friction, rowB)), impulse, since);
  return 1;
}
