// Resting contacts: those whose rebound is too short for the step. Their impulses are found together, for the speeds of
// approach must vanish everywhere at once: sequential impulses (projected Gauss-Seidel, Catto, "Iterative Dynamics with
// Temporal Coherence", 2005), each held at or above zero and starting from its value in the last step, so that a pile
// that lies still costs one sweep. Contacts with walls take part.
//
// Positions were moved by the integrator as if nothing held the bodies. An impulse that acts throughout the step moves
// a body by its change of velocity times half the step (and the integrator's lag): so a pile at rest stays where it is.
import { Columns, get, put } from '../memory/columns';
import { LANES, laneOf, splat } from '../memory/lanes';
import { impactSpeed, timeSince } from './walls/impact';
import { blockAt, contactIn, isSingle, pack, pressBlock, unpack } from './wide-contacts';
import { approach, readApproach, readPlace } from './approach';
import { Body, body, kick, nobody } from './body';
import { hold } from './friction';
import { bear, leave, reaction } from './wall-reactions';
import { ContactTable, FINITE, RUBBING_SIZE, putWord, rubbing, word } from './table';

const MOST_SWEEPS: i32 = 10;

// A sweep that changes no velocity by more than this part of the step's acceleration is the last.
const ENOUGH: real = 1e-4;

// Length of the step; the time impulses act for; a speed that makes no difference.
let step: real = 0;
let time: real = 0;
let slow: real = 0;

// Largest acceleration among the resting contacts, squared.
let most: real = 0;

export function holdResting(c: Columns, t: ContactTable, dt: real, lag: real): void {
  step = dt;
  time = <real>0.5 * dt + lag;
  const count = chooseResting(c, t, lag);
  if (count == 0) return;
  const speed = sqrt<real>(most) * dt;
  slow = speed * <real>0.01;
  const blocks = pack(t, count, dt, true);
  if (blocks > 0) sweepBlocks(t, blocks, true, true);
  else for (let k = 0; k < count; k++) start(t, word(t.order, k));
  for (let sweep = 0; sweep < MOST_SWEEPS; sweep++) {
    let change: real = 0;
    for (let k = 0; k < t.wallCount; k++) change = max<real>(change, pressWall(t, k));
    const forward = (sweep & 1) == 0;
    change = max<real>(change, blocks > 0 ? sweepBlocks(t, blocks, forward, false) : sweepPairs(t, count, forward));
    if (change <= speed * ENOUGH) break;
  }
  for (let n = 0; n < blocks; n++) unpack(t, blockAt(t, n));
  for (let k = 0; k < count; k++) {
    const i = word(t.order, k);
    put(t.impulse, i, get(t.impulse, i) + get(t.holding, i));
  }
}

// Goes through the resting contacts, and returns the largest change of velocity.
function sweepPairs(t: ContactTable, count: i32, forward: bool): real {
  let change: real = 0;
  for (let k = 0; k < count; k++) {
    change = max<real>(change, pressPair(t, word(t.order, forward ? k : count - 1 - k)));
  }
  return change;
}

// The same block by block; with `first`, starts from the impulses of the last step instead.
function sweepBlocks(t: ContactTable, blocks: i32, forward: bool, first: bool): real {
  let change: real = 0;
  let changes = splat(0);
  for (let n = 0; n < blocks; n++) {
    const block = blockAt(t, forward ? n : blocks - 1 - n);
    if (!isSingle(block)) {
      changes = v128.max<real>(changes, pressBlock(block, time, step, first));
      continue;
    }
    for (let lane = 0; lane < LANES; lane++) {
      const i = contactIn(block, lane);
      if (i < 0) break;
      if (first) start(t, i);
      else change = max<real>(change, pressPair(t, i));
    }
  }
  for (let lane = 0; lane < LANES; lane++) change = max<real>(change, laneOf(changes, lane));
  return change;
}

// Starts contact i from its impulse in the last step.
function start(t: ContactTable, i: i32): void {
  const from = get(t.holding, i);
  put(t.holding, i, 0);
  if (from > 0) press(t, i, body(t, word(t.slotA, i)), body(t, word(t.slotB, i)), from);
}

// Lists the contacts that rest, notes their gaps and coefficients of friction, and returns their number.
function chooseResting(c: Columns, t: ContactTable, lag: real): i32 {
  let count = 0;
  most = 0;
  for (let i = 0; i < t.count; i++) {
    const a = body(t, word(t.slotA, i));
    const b = body(t, word(t.slotB, i));
    const rowA = word(t.a, i);
    const rowB = word(t.b, i);
    readPlace(a, b);
    readApproach(a, b, rowA, rowB, t.layer == 0, lag);
    const gap = approach.distance - (a.radius + b.radius);
    const e = max<real>(get(c.restitution, rowA), get(c.restitution, rowB));
    const acceleration = max<real>(a.ax * a.ax + a.ay * a.ay + a.az * a.az, b.ax * b.ax + b.ay * b.ay + b.az * b.az);
    const pressed = get(t.holding, i) * (a.inverseMass + b.inverseMass);
    if (!rests(gap, e, pressed, <real>2 * step * sqrt<real>(acceleration))) {
      put(t.holding, i, 0);
      continue;
    }
    put(t.nx, i, approach.nx);
    put(t.ny, i, approach.ny);
    put(t.nz, i, approach.nz);
    put(t.gap, i, max<real>(0, gap));
    const sum = rubbing(t, i);
    memory.fill(sum, 0, RUBBING_SIZE);
    store<f32>(sum, <f32>sqrt<real>(get(c.friction, rowA) * get(c.friction, rowB)), 12);
    putWord(t.order, count++, i);
    most = max<real>(most, acceleration);
  }
  return count;
}

// Whether a contact rests. `pressed` is the speed that its impulse of the last step took away, `usual` one that the
// step's acceleration gives.
function rests(gap: real, e: real, pressed: real, usual: real): bool {
  const closing = -(approach.vx * approach.nx + approach.vy * approach.ny + approach.vz * approach.nz);
  const acceleration = max<real>(
    0,
    -(approach.ax * approach.nx + approach.ay * approach.ny + approach.az * approach.nz),
  );
  const some = max<real>(pressed, usual);
  if (!(closing > 0)) return -closing <= some && (some > 0 || e == 0);
  const half = <real>0.5 * max<real>(pressed, acceleration * step);
  if (gap > 0) return closing <= some && e * closing <= half;
  // What the sweeps over the impacts left goes on for another step only where it must not lose energy.
  if (e < 1) return true;
  const since = timeSince<real>(-gap, closing, acceleration, step);
  return e * impactSpeed<real>(closing, acceleration, since) <= half;
}

// Brings a wall's impulse on a body that rests there up to date. Returns the change of velocity.
function pressWall(t: ContactTable, k: i32): real {
  const slot = word(t.wallSlot, k);
  if (slot < 0) return 0;
  const b = body(t, slot);
  const w = b.inverseMass;
  if (w == 0) return 0;
  const x = get(t.wallNx, k);
  const y = get(t.wallNy, k);
  const z = get(t.wallNz, k);
  const holding = get(t.wallHolding, k);
  const excess = b.vx * x + b.vy * y + b.vz * z + get(t.wallGap, k);
  if (excess >= 0 && holding == 0) return 0;
  const impulse = max<real>(-holding, -excess / w);
  const change = abs<real>(impulse * w);
  if (change < FINITE) {
    bear(t, k, impulse);
    kick(b, impulse * w * x, impulse * w * y, impulse * w * z, time);
  }
  const limit = get(t.wallFriction, k) * (get(t.wallImpulse, k) - get(t.wallRubbed, k));
  if (limit > 0) hold(nobody(), b, x, y, z, limit, t.wallRubbing + <usize>k * 12, time);
  return change < FINITE ? change : <real>0;
}

// Brings the impulse of a resting contact up to date: the gap may close within a step, but not more.
function pressPair(t: ContactTable, i: i32): real {
  const a = body(t, word(t.slotA, i));
  const b = body(t, word(t.slotB, i));
  const x = get(t.nx, i);
  const y = get(t.ny, i);
  const z = get(t.nz, i);
  const excess = (b.vx - a.vx) * x + (b.vy - a.vy) * y + (b.vz - a.vz) * z + get(t.gap, i) / step;
  const holding = get(t.holding, i);
  if (excess >= 0 && holding == 0) return 0;
  leave(t, a, -x, -y, -z, slow);
  let w = a.inverseMass * reaction.share;
  leave(t, b, x, y, z, slow);
  w += b.inverseMass * reaction.share;
  if (!(w > 0)) return 0;
  const impulse = max<real>(-holding, -excess / w);
  const half = time;
  if (impulse > 0) {
    // Bodies that came into each other faster than by the step's acceleration go back as far as they came.
    const gap = (b.x - a.x) * x + (b.y - a.y) * y + (b.z - a.z) * z - (a.radius + b.radius);
    time = max<real>(half, min<real>(step, -gap / (impulse * w)));
  }
  const change = press(t, i, a, b, impulse);
  time = half;
  const sum = rubbing(t, i);
  const friction = <real>load<f32>(sum, 12);
  if (friction > 0) hold(a, b, x, y, z, friction * get(t.holding, i), sum, time);
  return change;
}

// Applies `impulse` to both bodies of contact i, walls answering. Returns the change of velocity.
function press(t: ContactTable, i: i32, a: Body, b: Body, impulse: real): real {
  const x = get(t.nx, i);
  const y = get(t.ny, i);
  const z = get(t.nz, i);
  const change = abs<real>(impulse) * max<real>(a.inverseMass, b.inverseMass);
  if (impulse == 0 || !(change < FINITE)) return 0;
  put(t.holding, i, get(t.holding, i) + impulse);
  pressBody(t, a, -x, -y, -z, impulse);
  pressBody(t, b, x, y, z, impulse);
  return change;
}

function pressBody(t: ContactTable, b: Body, x: real, y: real, z: real, impulse: real): void {
  leave(t, b, x, y, z, slow);
  if (reaction.wall >= 0) bear(t, reaction.wall, -impulse * reaction.cosine);
  const change = impulse * b.inverseMass;
  kick(b, change * reaction.x, change * reaction.y, change * reaction.z, time);
}
