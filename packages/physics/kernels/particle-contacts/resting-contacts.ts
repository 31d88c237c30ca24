// Resting contacts are contacts whose rebound is too short for the step to resolve. Their impulses are solved together
// by sequential impulses (projected Gauss-Seidel; Catto, "Iterative Dynamics with Temporal Coherence", 2005) with
// accumulated impulses clamped at zero and warm starting, so that a pile at rest needs one iteration. Wall contacts are
// included.
//
// The integrator moved the bodies without contact forces. An impulse that acts throughout the step displaces a body by
// its change of velocity times half the step (plus the integrator's lag), which keeps a pile at rest in place.
import { Columns, get, put } from '../memory/columns';
import { LANES, laneOf, larger, splat } from '../memory/lanes';
import { computeImpactSpeed, computeTimeSinceImpact } from './walls/impact';
import { blockAt, contactIn, isSingle, packBlocks, solveContactsWide, unpackBlock } from './wide-contacts';
import { approach, readRelativeMotion, readSeparation } from './approach';
import { Body, body, applyVelocityChange, staticBody } from './body';
import { solveFriction } from './friction';
import { addWallImpulse, constrainToWall, reaction, releaseWalls } from './wall-reactions';
import { ContactTable, FINITE, FRICTION_STATE_SIZE, putWord, frictionStateAt, word } from './table';

const MAX_ITERATIONS: i32 = 10;

// The iteration stops when no velocity changes by more than this fraction of the step's velocity change by
// acceleration.
const VELOCITY_TOLERANCE: real = 1e-4;

// Length of the step (s); duration for which impulses act (s); speed that counts as zero (m/s).
let step: real = 0;
let impulseDuration: real = 0;
let speedTolerance: real = 0;

// Largest squared acceleration among the resting contacts, m^2/s^4.
let maxSquaredAcceleration: real = 0;

export function solveRestingContacts(c: Columns, t: ContactTable, dt: real, lag: real): void {
  step = dt;
  impulseDuration = <real>0.5 * dt + lag;
  const count = chooseResting(c, t, lag);
  if (count == 0) return;
  releaseWalls(c, t);
  const speed = sqrt<real>(maxSquaredAcceleration) * dt;
  speedTolerance = speed * <real>0.01;
  const blocks = packBlocks(t, count, dt, true);
  if (blocks > 0) iterateBlocks(t, blocks, true, true);
  else for (let k = 0; k < count; k++) warmStart(t, word(t.order, k));
  for (let iteration = 0; iteration < MAX_ITERATIONS; iteration++) {
    let change: real = 0;
    for (let k = 0; k < t.wallCount; k++) change = max<real>(change, solveWallContact(t, k));
    const forward = (iteration & 1) == 0;
    change = max<real>(
      change,
      blocks > 0 ? iterateBlocks(t, blocks, forward, false) : iterateContacts(t, count, forward),
    );
    if (change <= speed * VELOCITY_TOLERANCE) break;
  }
  for (let n = 0; n < blocks; n++) unpackBlock(t, blockAt(t, n));
  for (let k = 0; k < count; k++) {
    const i = word(t.order, k);
    put(t.impulse, i, get(t.impulse, i) + get(t.accumulatedImpulse, i));
  }
}

// Runs one iteration over the resting contacts and returns the largest change of velocity.
function iterateContacts(t: ContactTable, count: i32, forward: bool): real {
  let change: real = 0;
  for (let k = 0; k < count; k++) {
    change = max<real>(change, solveContact(t, word(t.order, forward ? k : count - 1 - k)));
  }
  return change;
}

// Runs one iteration block by block. With `first` it applies the impulses of the last step instead.
function iterateBlocks(t: ContactTable, blocks: i32, forward: bool, first: bool): real {
  let change: real = 0;
  let changes = splat(0);
  for (let n = 0; n < blocks; n++) {
    const block = blockAt(t, forward ? n : blocks - 1 - n);
    if (!isSingle(block)) {
      changes = larger(changes, solveContactsWide(block, impulseDuration, step, first));
      continue;
    }
    for (let lane = 0; lane < LANES; lane++) {
      const i = contactIn(block, lane);
      if (i < 0) break;
      if (first) warmStart(t, i);
      else change = max<real>(change, solveContact(t, i));
    }
  }
  for (let lane = 0; lane < LANES; lane++) change = max<real>(change, laneOf(changes, lane));
  return change;
}

// Warm starts contact i with its impulse of the last step.
function warmStart(t: ContactTable, i: i32): void {
  const from = get(t.accumulatedImpulse, i);
  put(t.accumulatedImpulse, i, 0);
  if (from > 0) applyNormalImpulse(t, i, body(t, word(t.slotA, i)), body(t, word(t.slotB, i)), from);
}

// Lists the resting contacts, stores their gaps and friction coefficients, marks their bodies in the row words, and
// returns their count.
function chooseResting(c: Columns, t: ContactTable, lag: real): i32 {
  let count = 0;
  maxSquaredAcceleration = 0;
  memory.fill(t.rowWords, 0, (<usize>t.bodyCount) << 2);
  for (let i = 0; i < t.count; i++) {
    const a = body(t, word(t.slotA, i));
    const b = body(t, word(t.slotB, i));
    const rowA = word(t.a, i);
    const rowB = word(t.b, i);
    readSeparation(a, b);
    readRelativeMotion(a, b, rowA, rowB, t.layer == 0, lag);
    const gap = approach.distance - (a.radius + b.radius);
    const e = max<real>(get(c.restitution, rowA), get(c.restitution, rowB));
    const acceleration = max<real>(a.ax * a.ax + a.ay * a.ay + a.az * a.az, b.ax * b.ax + b.ay * b.ay + b.az * b.az);
    const previousSpeed = get(t.accumulatedImpulse, i) * (a.inverseMass + b.inverseMass);
    if (!isResting(gap, e, previousSpeed, <real>2 * step * sqrt<real>(acceleration))) {
      put(t.accumulatedImpulse, i, 0);
      continue;
    }
    put(t.nx, i, approach.nx);
    put(t.ny, i, approach.ny);
    put(t.nz, i, approach.nz);
    put(t.gap, i, max<real>(0, gap));
    const frictionState = frictionStateAt(t, i);
    memory.fill(frictionState, 0, FRICTION_STATE_SIZE);
    store<f32>(frictionState, <f32>sqrt<real>(get(c.friction, rowA) * get(c.friction, rowB)), 12);
    putWord(t.order, count++, i);
    putWord(t.rowWords, word(t.slotA, i), 1);
    putWord(t.rowWords, word(t.slotB, i), 1);
    maxSquaredAcceleration = max<real>(maxSquaredAcceleration, acceleration);
  }
  return count;
}

// Decides whether a contact is at rest. `previousSpeed` is the closing speed that its impulse removed in the last step,
// `usualSpeed` a speed that the acceleration produces in a step.
function isResting(gap: real, e: real, previousSpeed: real, usualSpeed: real): bool {
  const closing = -(approach.vx * approach.nx + approach.vy * approach.ny + approach.vz * approach.nz);
  const acceleration = max<real>(
    0,
    -(approach.ax * approach.nx + approach.ay * approach.ny + approach.az * approach.nz),
  );
  const restingSpeed = max<real>(previousSpeed, usualSpeed);
  if (!(closing > 0)) return -closing <= restingSpeed && (restingSpeed > 0 || e == 0);
  const halfStep = <real>0.5 * max<real>(previousSpeed, acceleration * step);
  if (gap > 0) return closing <= restingSpeed && e * closing <= halfStep;
  // A closing speed that the impacts left is carried into the next step only if it must not lose energy.
  if (e < 1) return true;
  const timeSinceImpact = computeTimeSinceImpact<real>(-gap, closing, acceleration, step);
  return e * computeImpactSpeed<real>(closing, acceleration, timeSinceImpact) <= halfStep;
}

// Updates the impulse of a wall on a body that rests on it. Returns the change of velocity.
function solveWallContact(t: ContactTable, k: i32): real {
  const slot = word(t.wallSlot, k);
  if (slot < 0) return 0;
  const b = body(t, slot);
  const w = b.inverseMass;
  if (w == 0) return 0;
  const x = get(t.wallNx, k);
  const y = get(t.wallNy, k);
  const z = get(t.wallNz, k);
  const accumulated = get(t.wallAccumulatedImpulse, k);
  const excess = b.vx * x + b.vy * y + b.vz * z + get(t.wallGap, k);
  if (excess >= 0 && accumulated == 0) return 0;
  const impulse = max<real>(-accumulated, -excess / w);
  const change = abs<real>(impulse * w);
  if (change < FINITE) {
    addWallImpulse(t, k, impulse);
    applyVelocityChange(b, impulse * w * x, impulse * w * y, impulse * w * z, impulseDuration);
  }
  const limit = get(t.wallFriction, k) * (get(t.wallImpulse, k) - get(t.wallFrictionApplied, k));
  if (limit > 0) solveFriction(staticBody(), b, x, y, z, limit, t.wallTangentImpulse + <usize>k * 12, impulseDuration);
  return change < FINITE ? change : <real>0;
}

// Updates the normal impulse of a resting contact. The gap may close within the step, but the bodies may not overlap.
function solveContact(t: ContactTable, i: i32): real {
  const a = body(t, word(t.slotA, i));
  const b = body(t, word(t.slotB, i));
  const x = get(t.nx, i);
  const y = get(t.ny, i);
  const z = get(t.nz, i);
  const excess = (b.vx - a.vx) * x + (b.vy - a.vy) * y + (b.vz - a.vz) * z + get(t.gap, i) / step;
  const accumulated = get(t.accumulatedImpulse, i);
  if (excess >= 0 && accumulated == 0) return 0;
  constrainToWall(t, a, -x, -y, -z, speedTolerance);
  let w = a.inverseMass * reaction.massFraction;
  constrainToWall(t, b, x, y, z, speedTolerance);
  w += b.inverseMass * reaction.massFraction;
  if (!(w > 0)) return 0;
  const impulse = max<real>(-accumulated, -excess / w);
  const halfStep = impulseDuration;
  if (impulse > 0) {
    // If the bodies overlapped faster than the step's acceleration explains, the impulse acts long enough to remove the
    // overlap.
    const gap = (b.x - a.x) * x + (b.y - a.y) * y + (b.z - a.z) * z - (a.radius + b.radius);
    impulseDuration = max<real>(halfStep, min<real>(step, -gap / (impulse * w)));
  }
  const change = applyNormalImpulse(t, i, a, b, impulse);
  impulseDuration = halfStep;
  const frictionState = frictionStateAt(t, i);
  const friction = <real>load<f32>(frictionState, 12);
  if (friction > 0)
    solveFriction(a, b, x, y, z, friction * get(t.accumulatedImpulse, i), frictionState, impulseDuration);
  return change;
}

// Applies a normal impulse to both bodies of contact i, including wall reactions. Returns the change of velocity.
function applyNormalImpulse(t: ContactTable, i: i32, a: Body, b: Body, impulse: real): real {
  const x = get(t.nx, i);
  const y = get(t.ny, i);
  const z = get(t.nz, i);
  const change = abs<real>(impulse) * max<real>(a.inverseMass, b.inverseMass);
  if (impulse == 0 || !(change < FINITE)) return 0;
  put(t.accumulatedImpulse, i, get(t.accumulatedImpulse, i) + impulse);
  applyToBody(t, a, -x, -y, -z, impulse);
  applyToBody(t, b, x, y, z, impulse);
  return change;
}

function applyToBody(t: ContactTable, b: Body, x: real, y: real, z: real, impulse: real): void {
  constrainToWall(t, b, x, y, z, speedTolerance);
  if (reaction.wall >= 0) addWallImpulse(t, reaction.wall, -impulse * reaction.cosine);
  const change = impulse * b.inverseMass;
  applyVelocityChange(b, change * reaction.x, change * reaction.y, change * reaction.z, impulseDuration);
}
