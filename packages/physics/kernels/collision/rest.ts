// Resting contacts: those whose rebound is too short for the step. Their impulses are found together, for the speeds of
// approach must vanish everywhere at once: sequential impulses (projected Gauss-Seidel, Catto, "Iterative Dynamics with
// Temporal Coherence", 2005), each held at or above zero and starting from its value in the last step, so that a pile
// that lies still costs one sweep. Contacts with walls take part.
//
// Positions were moved by the integrator as if nothing held the bodies. An impulse that acts throughout the step moves
// a body by its change of velocity times half the step (and the integrator's lag): so a pile at rest stays where it is.
import { Columns, get, put } from '../columns';
import { impactSpeed, timeSince } from '../walls/impact';
import { aX, aY, aZ, accelerationSquare, distance, nX, nY, nZ, readApproach, vX, vY, vZ } from './approach';
import { frictionX, frictionY, frictionZ, hold, inverseMass } from './friction';
import { RESTS } from './impacts';
import { follow, kick } from './impulse';
import { bear, cosine, leave, leftX, leftY, leftZ, linkWalls, share, wall } from './support';
import { ContactTable, FINITE, putWord, word } from './table';

const MOST_SWEEPS: i32 = 10;

// A sweep that changes no velocity by more than this part of the step's acceleration is the last.
const ENOUGH: real = 1e-4;

// Largest acceleration among the resting contacts; times dt, the speed that counts as slow.
let most: real = 0;

export function holdResting(c: Columns, t: ContactTable, dt: real, lag: real, lastId: i32): void {
  if (chooseResting(c, t, dt, lag) == 0) return;
  linkWalls(t, lastId);
  const time = <real>0.5 * dt + lag;
  const slow = most * dt * <real>0.01;
  const enough = most * dt * ENOUGH;
  for (let i = 0; i < t.count; i++) {
    const from = get(t.holding, i);
    put(t.holding, i, 0);
    memory.fill(t.rubbing + <usize>i * 12, 0, 12);
    if (from > 0 && (word(t.rawB, i) & RESTS) != 0) press(c, t, i, from, dt, time, slow);
  }
  for (let sweep = 0; sweep < MOST_SWEEPS; sweep++) {
    let change: real = 0;
    for (let k = 0; k < t.wallCount; k++) change = max<real>(change, pressWall(c, t, k, dt, time));
    const forward = (sweep & 1) == 0;
    for (let k = 0; k < t.count; k++) {
      const i = forward ? k : t.count - 1 - k;
      if ((word(t.rawB, i) & RESTS) != 0) change = max<real>(change, pressPair(c, t, i, dt, time, slow));
    }
    if (change <= enough) break;
  }
  for (let i = 0; i < t.count; i++) put(t.impulse, i, get(t.impulse, i) + get(t.holding, i));
}

// Flags the contacts that rest, notes their gaps (f32 is enough: it is small against the radii) and counts them.
function chooseResting(c: Columns, t: ContactTable, dt: real, lag: real): i32 {
  let count = 0;
  most = 0;
  for (let i = 0; i < t.count; i++) {
    const a = word(t.a, i);
    const b = word(t.b, i);
    readApproach(c, t, a, b, <real>1 / dt, lag);
    const gap = distance - (get(c.radius, a) + get(c.radius, b));
    const e = max<real>(get(c.restitution, a), get(c.restitution, b));
    const pressed = get(t.holding, i) * (inverseMass(c, a) + inverseMass(c, b));
    if (!rests(gap, e, dt, pressed)) {
      put(t.holding, i, 0);
      continue;
    }
    put(t.nx, i, nX);
    put(t.ny, i, nY);
    put(t.nz, i, nZ);
    store<f32>(t.rawA + ((<usize>i) << 2), <f32>max<real>(0, gap));
    putWord(t.rawB, i, word(t.rawB, i) | RESTS);
    most = max<real>(most, sqrt<real>(accelerationSquare));
    count++;
  }
  return count;
}

// Whether a contact rests; `pressed` is the speed that its impulse of the last step took away.
function rests(gap: real, e: real, dt: real, pressed: real): bool {
  const closing = -(vX * nX + vY * nY + vZ * nZ);
  const acceleration = max<real>(0, -(aX * nX + aY * nY + aZ * nZ));
  const slow = max<real>(pressed, <real>2 * dt * sqrt<real>(accelerationSquare));
  if (!(closing > 0)) return -closing <= slow && (slow > 0 || e == 0);
  const half = <real>0.5 * max<real>(pressed, acceleration * dt);
  if (gap > 0) return closing <= slow && e * closing <= half;
  // What the sweeps over the impacts left goes on for another step only where it must not lose energy.
  if (e < 1) return true;
  const since = timeSince<real>(-gap, closing, acceleration, dt);
  return e * impactSpeed<real>(closing, acceleration, since) <= half;
}

// Brings a wall's impulse on a body that rests there up to date. Returns the change of velocity.
function pressWall(c: Columns, t: ContactTable, k: i32, dt: real, time: real): real {
  const holding = get(t.wallHolding, k);
  const body = word(t.wallBody, k);
  const w = inverseMass(c, body);
  const x = get(t.wallNx, k);
  const y = get(t.wallNy, k);
  const z = get(t.wallNz, k);
  const speed = get(c.velocityX, body) * x + get(c.velocityY, body) * y + get(c.velocityZ, body) * z;
  const excess = speed + get(t.wallGap, k) / dt;
  if (excess >= 0 && holding == 0) return 0;
  const impulse = max<real>(-holding, -excess / w);
  const change = abs<real>(impulse * w);
  if (change < FINITE) {
    bear(t, k, impulse);
    kick(c, t, body, impulse * w * x, impulse * w * y, impulse * w * z, time);
  }
  const limit = get(t.wallFriction, k) * (get(t.wallImpulse, k) - get(t.wallRubbed, k));
  if (limit > 0) rubPair(c, t, 0, body, x, y, z, limit, t.wallRubbing + <usize>k * 12, time);
  return change < FINITE ? change : <real>0;
}

// Friction up to `limit` between two bodies at rest on each other.
function rubPair(
  c: Columns, t: ContactTable, a: i32, b: i32, x: real, y: real, z: real, limit: real, sum: usize, time: real,
): void {
  if (hold(c, a, b, x, y, z, limit, sum) == 0) return;
  const wa = inverseMass(c, a);
  const wb = inverseMass(c, b);
  if (wa > 0) follow(c, t, a, -wa * frictionX, -wa * frictionY, -wa * frictionZ, time);
  if (wb > 0) follow(c, t, b, wb * frictionX, wb * frictionY, wb * frictionZ, time);
}

// Brings the impulse of a resting contact up to date: the gap may close within a step, but not more.
function pressPair(c: Columns, t: ContactTable, i: i32, dt: real, time: real, slow: real): real {
  const a = word(t.a, i);
  const b = word(t.b, i);
  const x = get(t.nx, i);
  const y = get(t.ny, i);
  const z = get(t.nz, i);
  const speed =
    (get(c.velocityX, b) - get(c.velocityX, a)) * x +
    (get(c.velocityY, b) - get(c.velocityY, a)) * y +
    (get(c.velocityZ, b) - get(c.velocityZ, a)) * z;
  const excess = speed + <real>load<f32>(t.rawA + ((<usize>i) << 2)) / dt;
  const holding = get(t.holding, i);
  if (excess >= 0 && holding == 0) return 0;
  leave(c, t, a, -x, -y, -z, dt, slow);
  let w = inverseMass(c, a) * share;
  leave(c, t, b, x, y, z, dt, slow);
  w += inverseMass(c, b) * share;
  if (!(w > 0)) return 0;
  const change = press(c, t, i, max<real>(-holding, -excess / w), dt, time, slow);
  const friction = sqrt<real>(get(c.friction, a) * get(c.friction, b));
  if (friction > 0) rubPair(c, t, a, b, x, y, z, friction * get(t.holding, i), t.rubbing + <usize>i * 12, time);
  return change;
}

// Applies `impulse` to both bodies of contact i, walls answering. Returns the change of velocity.
function press(c: Columns, t: ContactTable, i: i32, impulse: real, dt: real, time: real, slow: real): real {
  const a = word(t.a, i);
  const b = word(t.b, i);
  const x = get(t.nx, i);
  const y = get(t.ny, i);
  const z = get(t.nz, i);
  const change = abs<real>(impulse) * max<real>(inverseMass(c, a), inverseMass(c, b));
  if (impulse == 0 || !(change < FINITE)) return 0;
  put(t.holding, i, get(t.holding, i) + impulse);
  pressBody(c, t, a, -x, -y, -z, impulse, dt, time, slow);
  pressBody(c, t, b, x, y, z, impulse, dt, time, slow);
  return change;
}

function pressBody(
  c: Columns,
  t: ContactTable,
  row: i32,
  x: real,
  y: real,
  z: real,
  impulse: real,
  dt: real,
  time: real,
  slow: real,
): void {
  const w = inverseMass(c, row);
  if (w == 0) return;
  leave(c, t, row, x, y, z, dt, slow);
  if (wall >= 0) bear(t, wall, -impulse * cosine);
  const change = impulse * w;
  kick(c, t, row, change * leftX, change * leftY, change * leftZ, time);
}
