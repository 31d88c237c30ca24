// Takes bodies apart that overlap: a displacement, no velocity, so that nothing flies off that was put into another.
//
// Each contact asks for a part of the overlap that will not have gone by itself when the next step ends, shared by
// inverse mass, so that the centre of mass stays. In the end no body is further from where it was than it or one that
// overlaps it moved in the step, and `MOST_SPEED` radii a second: what a step pressed together it takes apart, and bodies
// that were put into one place come apart at a pace the eye can follow. The accelerations of the step have served by now:
// their place takes where the bodies were.
import { get } from '../memory/columns';
import { LANES } from '../memory/lanes';
import { blockAt, contactIn, isSingle, pack, pushBlock } from './wide-contacts';
import { approach, readPlace } from './approach';
import { Body, body } from './body';
import { leave, reaction } from './wall-reactions';
import { ContactTable, putWord, word } from './table';

const PART: real = 0.8;

// Overlaps that the step did not make come apart at this many radii a second.
const MOST_SPEED: real = 4;

// This part of the radii may stay: bodies that lie on each other keep touching, and so keep still.
const SLOP: real = 0.001;

// Overlaps spread through a heap: so often a step, up and down in turns.
const ROUNDS: i32 = 4;

export function separate(t: ContactTable, dt: real): void {
  let count = 0;
  for (let i = 0; i < t.count; i++) {
    if (depthOf(t, i, dt) > 0) putWord(t.order, count++, i);
  }
  if (count == 0) return;
  const blocks = pack(t, count, dt, false);
  for (let slot = 0; slot < t.bodyCount; slot++) begin(t, slot, dt);
  for (let k = 0; k < count; k++) {
    const a = mostOf(t, word(t.slotA, word(t.order, k)));
    const b = mostOf(t, word(t.slotB, word(t.order, k)));
    const most = max<f32>(load<f32>(a), load<f32>(b));
    store<f32>(a, most);
    store<f32>(b, most);
  }
  for (let round = 0; round < ROUNDS; round++) {
    const forward = (round & 1) == 0;
    if (blocks > 0) pushBlocks(t, blocks, forward, dt);
    else for (let k = 0; k < count; k++) push(t, word(t.order, forward ? k : count - 1 - k), dt);
  }
  for (let slot = 0; slot < t.bodyCount; slot++) end(t, slot);
}

function pushBlocks(t: ContactTable, blocks: i32, forward: bool, dt: real): void {
  for (let n = 0; n < blocks; n++) {
    const block = blockAt(t, forward ? n : blocks - 1 - n);
    if (!isSingle(block)) {
      pushBlock(block, dt, PART, SLOP);
      continue;
    }
    for (let lane = 0; lane < LANES; lane++) {
      const i = contactIn(block, lane);
      if (i >= 0) push(t, i, dt);
    }
  }
}

// How far a body may be displaced, in the words that no row needs any more.
// @ts-ignore: decorator
@inline function mostOf(t: ContactTable, slot: i32): usize {
  return t.rowWords + ((<usize>slot) << 2);
}

function begin(t: ContactTable, slot: i32, dt: real): void {
  const b = body(t, slot);
  const row = word(t.bodyRows, slot);
  const x = get(t.startX, row);
  const y = get(t.startY, row);
  const z = t.layer == 0 ? <real>0 : get(t.startZ, row);
  const speed = sqrt<real>(x * x + y * y + z * z);
  store<f32>(mostOf(t, slot), <f32>(dt * (speed + MOST_SPEED * b.radius)));
  b.ax = b.x;
  b.ay = b.y;
  b.az = b.z;
}

// Takes a body back that went too far.
function end(t: ContactTable, slot: i32): void {
  const b = body(t, slot);
  const most = <real>load<f32>(mostOf(t, slot));
  const x = b.x - b.ax;
  const y = b.y - b.ay;
  const z = b.z - b.az;
  const square = x * x + y * y + z * z;
  if (!(square > most * most)) return;
  const scale = most / sqrt<real>(square);
  b.x = b.ax + x * scale;
  b.y = b.ay + y * scale;
  b.z = b.az + z * scale;
}

// The overlap of contact i that will be left when the next step ends.
function depthOf(t: ContactTable, i: i32, dt: real): real {
  const a = body(t, word(t.slotA, i));
  const b = body(t, word(t.slotB, i));
  readPlace(a, b);
  const overlap = a.radius + b.radius - approach.distance;
  const speed = (b.vx - a.vx) * get(t.nx, i) + (b.vy - a.vy) * get(t.ny, i) + (b.vz - a.vz) * get(t.nz, i);
  return overlap - SLOP * (a.radius + b.radius) - max<real>(0, speed * dt);
}

function push(t: ContactTable, i: i32, dt: real): void {
  const depth = depthOf(t, i, dt);
  if (!(depth > 0)) return;
  const a = body(t, word(t.slotA, i));
  const b = body(t, word(t.slotB, i));
  const x = get(t.nx, i);
  const y = get(t.ny, i);
  const z = get(t.nz, i);
  // A body that leaves its wall by less than this will not have room in the next step either.
  const slow = (<real>0.01 * depth) / dt;
  leave(t, a, -x, -y, -z, slow);
  const ax = reaction.x;
  const ay = reaction.y;
  const az = reaction.z;
  const sharing = a.inverseMass * reaction.share;
  leave(t, b, x, y, z, slow);
  const sum = sharing + b.inverseMass * reaction.share;
  if (!(sum > 0)) return;
  const size = (PART * depth) / sum;
  move(a, ax, ay, az, size * a.inverseMass);
  move(b, reaction.x, reaction.y, reaction.z, size * b.inverseMass);
}

// @ts-ignore: decorator
@inline function move(b: Body, x: real, y: real, z: real, size: real): void {
  b.x += x * size;
  b.y += y * size;
  b.z += z * size;
}
