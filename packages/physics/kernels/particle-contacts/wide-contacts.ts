// Wide contacts: solves LANES contacts at a time with bits identical to the sequential solver.
//
// In an iteration a contact depends only on the earlier contacts of its two bodies. Its batch (colour) is one more than
// the highest batch of an earlier contact of either body, so contacts of one batch share no body, and solving batch by
// batch is bitwise equal to the sequential order, forwards and backwards. In a pile a batch has dozens or hundreds of
// contacts, which are packed into blocks of LANES. Contacts with friction or with a wall-supported body are kept in
// separate blocks and solved sequentially.
import { get, put } from '../memory/columns';
import { LANES, add, div, dot, larger, mul, smaller, splat, sub } from '../memory/lanes';
import { body, staticBody } from './body';
import { transposed, readTransposed, writeTransposed } from './transpose4';
import { ContactTable, FINITE, putWord, frictionStateAt, word } from './table';

// Layout of a block, in bytes: the addresses of the bodies a and b and the contact indices (-1 for an empty lane), one
// word per lane; then normals, gap / dt, and impulses, one vector each.
const BODY_B: usize = 16;
const INDEX: usize = 32;
const NX: usize = 48;
const NY: usize = 64;
const NZ: usize = 80;
const GAP_SPEED: usize = 96;
const IMPULSE: usize = 112;
const BLOCK: usize = 128;

// Velocities follow the positions in `Body`.
const VELOCITY: usize = 4 * sizeof<real>();

// Wide solving does not pay for fewer contacts.
const MIN_CONTACTS: i32 = 32;

// @ts-ignore: decorator
@inline export function blockAt(t: ContactTable, n: i32): usize {
  return t.blocks + <usize>n * BLOCK;
}

// The contact in a lane of a block, or -1 if the lane is empty.
// @ts-ignore: decorator
@inline export function contactIn(block: usize, lane: i32): i32 {
  return word(block + INDEX, lane);
}

// Returns whether the contacts of a block are solved sequentially.
// @ts-ignore: decorator
@inline export function isSingle(block: usize): bool {
  return load<u32>(block) == 0;
}

// Packs the first `count` contacts of t.order into blocks and returns the block count, or 0 if sequential solving is as
// fast or the blocks do not fit, as in a long chain. `step` is the length of the step. With `singleFriction` contacts
// with friction are solved sequentially.
export function packBlocks(t: ContactTable, count: i32, step: real, singleFriction: bool): i32 {
  if (count < MIN_CONTACTS) return 0;
  const keys = findBatches(t, count, singleFriction);
  if (keys == 0) return 0;
  let lanes = 0;
  for (let key = 0; key < keys; key++) {
    const size = word(t.batches, key);
    putWord(t.batches, key, lanes);
    lanes += (size + LANES - 1) & -LANES;
  }
  if (lanes > t.capacity) return 0;
  const blocks = lanes / LANES;
  for (let n = 0; n < blocks; n++) clearBlock(blockAt(t, n));
  for (let k = 0; k < count; k++) {
    const i = word(t.order, k);
    const key = word(t.flags, i);
    const lanePosition = word(t.batches, key);
    putWord(t.batches, key, lanePosition + 1);
    fillLane(t, blockAt(t, lanePosition / LANES), lanePosition & (LANES - 1), i, (key & 1) != 0, step);
  }
  return blocks;
}

// Stores the key of each contact in its flags, which is 2 * batch, plus 1 if it is solved sequentially, and counts the
// contacts of each key in t.batches. Returns the number of keys, or 0 if there are too many.
function findBatches(t: ContactTable, count: i32, singleFriction: bool): i32 {
  const last = t.rowWords;
  memory.fill(last, 0, (<usize>t.bodyCount) << 2);
  let keys = 0;
  for (let k = 0; k < count; k++) {
    const i = word(t.order, k);
    const slotA = word(t.slotA, i);
    const slotB = word(t.slotB, i);
    const a = body(t, slotA);
    const b = body(t, slotB);
    const batch = max<i32>(word(last, slotA), word(last, slotB));
    // Solving does not change an immovable body, so contacts may share it within a batch.
    if (a.inverseMass > 0) putWord(last, slotA, batch + 1);
    if (b.inverseMass > 0) putWord(last, slotB, batch + 1);
    const single = a.wall != 0 || b.wall != 0 || (singleFriction && load<f32>(frictionStateAt(t, i), 12) > 0);
    const key = 2 * batch + i32(single);
    if (key >= keys) {
      const end = 2 * batch + 2;
      if (end > t.maxBatches) return 0;
      memory.fill(t.batches + ((<usize>keys) << 2), 0, (<usize>(end - keys)) << 2);
      keys = end;
    }
    putWord(t.batches, key, word(t.batches, key) + 1);
    putWord(t.flags, i, key);
  }
  return keys;
}

// Empty lanes refer to the static body, which does not move.
// @ts-ignore: decorator
@inline function clearBlock(block: usize): void {
  const none = i32x4.splat(<i32>changetype<usize>(staticBody()));
  v128.store(block, none);
  v128.store(block + BODY_B, none);
  v128.store(block + INDEX, i32x4.splat(-1));
  memory.fill(block + NX, 0, BLOCK - NX);
}

function fillLane(t: ContactTable, block: usize, lane: i32, i: i32, single: bool, step: real): void {
  putWord(block + INDEX, lane, i);
  if (single) return store<u32>(block, 0);
  putWord(block, lane, <i32>changetype<usize>(body(t, word(t.slotA, i))));
  putWord(block + BODY_B, lane, <i32>changetype<usize>(body(t, word(t.slotB, i))));
  put(block + NX, lane, get(t.nx, i));
  put(block + NY, lane, get(t.ny, i));
  put(block + NZ, lane, get(t.nz, i));
  put(block + GAP_SPEED, lane, get(t.gap, i) / step);
  put(block + IMPULSE, lane, get(t.accumulatedImpulse, i));
}

// Copies the impulses of a block back to the contacts.
export function unpackBlock(t: ContactTable, block: usize): void {
  if (isSingle(block)) return;
  for (let lane = 0; lane < LANES; lane++) {
    const i = contactIn(block, lane);
    if (i >= 0) put(t.accumulatedImpulse, i, get(block + IMPULSE, lane));
  }
}

// Updates the impulses of a block with the formulas of `solveContact`. `half` is the duration for which an impulse
// acts, `step` its maximum. With `start` the impulses of the last step are applied instead. Returns the changes of
// velocity.
export function solveContactsWide(block: usize, half: real, step: real, start: bool): v128 {
  const zero = splat(0);
  const nx = v128.load(block, NX);
  const ny = v128.load(block, NY);
  const nz = v128.load(block, NZ);
  const accumulated = v128.load(block, IMPULSE);
  readTransposed(block, VELOCITY);
  const avx = transposed.q0;
  const avy = transposed.q1;
  const avz = transposed.q2;
  const wa = transposed.q3;
  readTransposed(block + BODY_B, VELOCITY);
  const bvx = transposed.q0;
  const bvy = transposed.q1;
  const bvz = transposed.q2;
  const wb = transposed.q3;
  const w = add(wa, wb);
  let impulse = accumulated;
  let active = v128.gt<real>(accumulated, zero);
  if (!start) {
    const excess = add(dot(sub(bvx, avx), sub(bvy, avy), sub(bvz, avz), nx, ny, nz), v128.load(block, GAP_SPEED));
    const idle = v128.and(v128.ge<real>(excess, zero), v128.eq<real>(accumulated, zero));
    active = v128.andnot(v128.gt<real>(w, zero), idle);
    impulse = larger(div(v128.neg<real>(excess), w), v128.neg<real>(accumulated));
  }
  const change = mul(v128.abs<real>(impulse), larger(wa, wb));
  active = v128.and(active, v128.and(v128.ne<real>(impulse, zero), v128.lt<real>(change, splat(FINITE))));
  impulse = v128.and(impulse, active);
  v128.store(block, start ? impulse : add(accumulated, impulse), IMPULSE);
  if (!v128.any_true(active)) return zero;

  readTransposed(block, 0);
  const ax = transposed.q0;
  const ay = transposed.q1;
  const az = transposed.q2;
  const ar = transposed.q3;
  readTransposed(block + BODY_B, 0);
  const bx = transposed.q0;
  const by = transposed.q1;
  const bz = transposed.q2;
  const br = transposed.q3;
  let time = splat(half);
  if (!start) {
    const gap = sub(dot(sub(bx, ax), sub(by, ay), sub(bz, az), nx, ny, nz), add(ar, br));
    const longer = larger(smaller(div(v128.neg<real>(gap), mul(impulse, w)), splat(step)), time);
    time = v128.bitselect(longer, time, v128.gt<real>(impulse, zero));
  }
  const ja = mul(impulse, wa);
  let dx = mul(ja, nx);
  let dy = mul(ja, ny);
  let dz = mul(ja, nz);
  writeTransposed(block, VELOCITY, sub(avx, dx), sub(avy, dy), sub(avz, dz), wa);
  writeTransposed(block, 0, sub(ax, mul(dx, time)), sub(ay, mul(dy, time)), sub(az, mul(dz, time)), ar);
  const jb = mul(impulse, wb);
  dx = mul(jb, nx);
  dy = mul(jb, ny);
  dz = mul(jb, nz);
  writeTransposed(block + BODY_B, VELOCITY, add(bvx, dx), add(bvy, dy), add(bvz, dz), wb);
  writeTransposed(block + BODY_B, 0, add(bx, mul(dx, time)), add(by, mul(dy, time)), add(bz, mul(dz, time)), br);
  return v128.and(change, active);
}

// Corrects `fraction` of the overlap of the contacts of a block, with the formulas of `correctPosition`. `slop` times
// the sum of the radii may remain, and motion within `dt` is subtracted.
export function correctPositionsWide(block: usize, dt: real, fraction: real, slop: real): void {
  const nx = v128.load(block, NX);
  const ny = v128.load(block, NY);
  const nz = v128.load(block, NZ);
  readTransposed(block, VELOCITY);
  const avx = transposed.q0;
  const avy = transposed.q1;
  const avz = transposed.q2;
  const wa = transposed.q3;
  readTransposed(block + BODY_B, VELOCITY);
  const wb = transposed.q3;
  const speed = dot(sub(transposed.q0, avx), sub(transposed.q1, avy), sub(transposed.q2, avz), nx, ny, nz);
  readTransposed(block, 0);
  const ax = transposed.q0;
  const ay = transposed.q1;
  const az = transposed.q2;
  const ar = transposed.q3;
  readTransposed(block + BODY_B, 0);
  const bx = transposed.q0;
  const by = transposed.q1;
  const bz = transposed.q2;
  const br = transposed.q3;
  const dx = sub(bx, ax);
  const dy = sub(by, ay);
  const dz = sub(bz, az);
  const reach = add(ar, br);
  const overlap = sub(reach, v128.sqrt<real>(dot(dx, dy, dz, dx, dy, dz)));
  const separation = larger(mul(speed, splat(dt)), splat(0));
  const depth = sub(sub(overlap, mul(splat(slop), reach)), separation);
  const sum = add(wa, wb);
  const active = v128.and(v128.gt<real>(depth, splat(0)), v128.gt<real>(sum, splat(0)));
  if (!v128.any_true(active)) return;
  const size = v128.and(div(mul(splat(fraction), depth), sum), active);
  const da = mul(size, wa);
  const db = mul(size, wb);
  writeTransposed(block, 0, sub(ax, mul(nx, da)), sub(ay, mul(ny, da)), sub(az, mul(nz, da)), ar);
  writeTransposed(block + BODY_B, 0, add(bx, mul(nx, db)), add(by, mul(ny, db)), add(bz, mul(nz, db)), br);
}
