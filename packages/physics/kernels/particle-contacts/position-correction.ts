// Position correction: overlapping bodies are displaced without a change of velocity, so that the correction adds no
// kinetic energy.
//
// Each contact removes a fraction of the overlap that will remain after the next step. The displacement is shared by
// inverse mass, so that the centre of mass does not move. A body is displaced by at most the distance that it or a body
// overlapping it moved in the step, plus MAX_SEPARATION_SPEED radii a second: overlap caused by the step is corrected
// within it, and bodies that were created overlapping separate visibly smoothly. The acceleration fields of the bodies
// are no longer needed here, so they hold the initial positions.
import { Columns, get } from '../memory/columns';
import { LANES } from '../memory/lanes';
import { blockAt, contactIn, isSingle, packBlocks, correctPositionsWide } from './wide-contacts';
import { approach, readSeparation } from './approach';
import { Body, body } from './body';
import { constrainToWall, reaction } from './wall-reactions';
import { ContactTable, putWord, word } from './table';

const CORRECTION_FRACTION: real = 0.8;

// Initial overlaps separate at this many radii a second.
const MAX_SEPARATION_SPEED: real = 4;

// This fraction of the sum of the radii may remain as overlap, so that resting bodies keep touching and stay at rest.
const SLOP: real = 0.001;

// Iterations per step, in alternating order, so that corrections propagate through a pile in both directions.
const ITERATIONS: i32 = 4;

// Steps in which an elastic impact may be over.
const PASSING_STEPS: real = 256;

export function correctPositions(c: Columns, t: ContactTable, dt: real): void {
  let count = 0;
  for (let i = 0; i < t.count; i++) {
    const depth = depthOf(t, i, dt);
    if (depth > 0 && !(t.isUneven != 0 && isPassing(c, t, i, depth, dt))) putWord(t.order, count++, i);
  }
  if (count == 0) return;
  const blocks = packBlocks(t, count, dt, false);
  for (let slot = 0; slot < t.bodyCount; slot++) saveStart(t, slot, dt);
  for (let k = 0; k < count; k++) {
    const a = maxDisplacementOf(t, word(t.slotA, word(t.order, k)));
    const b = maxDisplacementOf(t, word(t.slotB, word(t.order, k)));
    const maxDisplacement = max<f32>(load<f32>(a), load<f32>(b));
    store<f32>(a, maxDisplacement);
    store<f32>(b, maxDisplacement);
  }
  for (let iteration = 0; iteration < ITERATIONS; iteration++) {
    const forward = (iteration & 1) == 0;
    if (blocks > 0) correctBlocks(t, blocks, forward, dt);
    else for (let k = 0; k < count; k++) correctPosition(t, word(t.order, forward ? k : count - 1 - k), dt);
  }
  for (let slot = 0; slot < t.bodyCount; slot++) limitDisplacement(t, slot);
}

// Returns whether the bodies of contact i, with overlap `depth`, are on their way through an elastic impact. Under forces
// that depend on position, bodies that such impacts leave in each other (impacts.ts) would gain energy by displacement, so
// they part by themselves.
function isPassing(c: Columns, t: ContactTable, i: i32, depth: real, dt: real): bool {
  if (max<real>(get(c.restitution, word(t.a, i)), get(c.restitution, word(t.b, i))) < 1) return false;
  const a = body(t, word(t.slotA, i));
  const b = body(t, word(t.slotB, i));
  const speed = (b.vx - a.vx) * get(t.nx, i) + (b.vy - a.vy) * get(t.ny, i) + (b.vz - a.vz) * get(t.nz, i);
  return abs<real>(speed) * PASSING_STEPS * dt >= depth;
}

function correctBlocks(t: ContactTable, blocks: i32, forward: bool, dt: real): void {
  for (let n = 0; n < blocks; n++) {
    const block = blockAt(t, forward ? n : blocks - 1 - n);
    if (!isSingle(block)) {
      correctPositionsWide(block, dt, CORRECTION_FRACTION, SLOP);
      continue;
    }
    for (let lane = 0; lane < LANES; lane++) {
      const i = contactIn(block, lane);
      if (i >= 0) correctPosition(t, i, dt);
    }
  }
}

// The maximum displacement of a body, stored in the row words, which are free by now.
// @ts-ignore: decorator
@inline function maxDisplacementOf(t: ContactTable, slot: i32): usize {
  return t.rowWords + ((<usize>slot) << 2);
}

function saveStart(t: ContactTable, slot: i32, dt: real): void {
  const b = body(t, slot);
  const row = word(t.bodyRows, slot);
  const x = get(t.startX, row);
  const y = get(t.startY, row);
  const z = t.layer == 0 ? <real>0 : get(t.startZ, row);
  const speed = sqrt<real>(x * x + y * y + z * z);
  store<f32>(maxDisplacementOf(t, slot), <f32>(dt * (speed + MAX_SEPARATION_SPEED * b.radius)));
  b.ax = b.x;
  b.ay = b.y;
  b.az = b.z;
}

// Scales the displacement of a body back to its maximum.
function limitDisplacement(t: ContactTable, slot: i32): void {
  const b = body(t, slot);
  const maxDisplacement = <real>load<f32>(maxDisplacementOf(t, slot));
  const x = b.x - b.ax;
  const y = b.y - b.ay;
  const z = b.z - b.az;
  const square = x * x + y * y + z * z;
  if (!(square > maxDisplacement * maxDisplacement)) return;
  const scale = maxDisplacement / sqrt<real>(square);
  b.x = b.ax + x * scale;
  b.y = b.ay + y * scale;
  b.z = b.az + z * scale;
}

// Returns the overlap of contact i that will remain at the end of the next step, less the slop.
function depthOf(t: ContactTable, i: i32, dt: real): real {
  const a = body(t, word(t.slotA, i));
  const b = body(t, word(t.slotB, i));
  readSeparation(a, b);
  const overlap = a.radius + b.radius - approach.distance;
  const speed = (b.vx - a.vx) * get(t.nx, i) + (b.vy - a.vy) * get(t.ny, i) + (b.vz - a.vz) * get(t.nz, i);
  return overlap - SLOP * (a.radius + b.radius) - max<real>(0, speed * dt);
}

function correctPosition(t: ContactTable, i: i32, dt: real): void {
  const depth = depthOf(t, i, dt);
  if (!(depth > 0)) return;
  const a = body(t, word(t.slotA, i));
  const b = body(t, word(t.slotB, i));
  const x = get(t.nx, i);
  const y = get(t.ny, i);
  const z = get(t.nz, i);
  // A body that leaves its wall more slowly than this stays supported during the next step.
  const speedTolerance = (<real>0.01 * depth) / dt;
  constrainToWall(t, a, -x, -y, -z, speedTolerance);
  const ax = reaction.x;
  const ay = reaction.y;
  const az = reaction.z;
  const freeMassA = a.inverseMass * reaction.massFraction;
  constrainToWall(t, b, x, y, z, speedTolerance);
  const sum = freeMassA + b.inverseMass * reaction.massFraction;
  if (!(sum > 0)) return;
  const size = (CORRECTION_FRACTION * depth) / sum;
  move(a, ax, ay, az, size * a.inverseMass);
  move(b, reaction.x, reaction.y, reaction.z, size * b.inverseMass);
}

// @ts-ignore: decorator
@inline function move(b: Body, x: real, y: real, z: real, size: real): void {
  b.x += x * size;
  b.y += y * size;
  b.z += z * size;
}
