// Contacts side by side: LANES of them in one go, with the bits of one after the other.
//
// In a sweep each contact sees what those before it did to its two bodies, and nothing else. Its level is one more than
// the highest level of an earlier contact of either body: so contacts of one level have no body in common, and going
// level by level is the same sweep to the bit, forwards and backwards. In a heap a level is a front of dozens or hundreds
// of contacts, which are packed into blocks of LANES. Contacts with friction, or of a body that a wall holds, have blocks
// of their own, and are solved one by one.
import { get, put } from '../memory/columns';
import { LANES, add, div, dot, mul, splat, sub } from '../memory/lanes';
import { body, nobody } from './body';
import { quads, readQuads, writeQuads } from './transpose4';
import { ContactTable, FINITE, putWord, rubbing, word } from './table';

// A block: the addresses of the bodies a and b and the contacts' indices (-1 for a lane without one), a word a lane each;
// then normals, gaps by dt, and impulses, a vector each.
const B: usize = 16;
const INDEX: usize = 32;
const NX: usize = 48;
const NY: usize = 64;
const NZ: usize = 80;
const RATE: usize = 96;
const HOLDING: usize = 112;
const BLOCK: usize = 128;

// Motions follow places in `Body`.
const MOTION: usize = 4 * sizeof<real>();

// In fewer contacts than this there is nothing to gain.
const LEAST: i32 = 32;

// @ts-ignore: decorator
@inline export function blockAt(t: ContactTable, n: i32): usize {
  return t.blocks + <usize>n * BLOCK;
}

// The contact in a lane of a block, -1 for none.
// @ts-ignore: decorator
@inline export function contactIn(block: usize, lane: i32): i32 {
  return word(block + INDEX, lane);
}

// Whether the contacts of a block are solved one by one.
// @ts-ignore: decorator
@inline export function isSingle(block: usize): bool {
  return load<u32>(block) == 0;
}

// Packs the first `count` contacts of t.order into blocks, and returns how many: 0 where one after the other is as well,
// or where there is no room, as in a long chain. `step` is the length of the step; with `rough`, contacts with friction
// are solved alone.
export function pack(t: ContactTable, count: i32, step: real, rough: bool): i32 {
  if (count < LEAST) return 0;
  const keys = findLevels(t, count, rough);
  if (keys == 0) return 0;
  let lanes = 0;
  for (let key = 0; key < keys; key++) {
    const size = word(t.levels, key);
    putWord(t.levels, key, lanes);
    lanes += (size + LANES - 1) & -LANES;
  }
  if (lanes > t.capacity) return 0;
  const blocks = lanes / LANES;
  for (let n = 0; n < blocks; n++) empty(blockAt(t, n));
  for (let k = 0; k < count; k++) {
    const i = word(t.order, k);
    const key = word(t.flags, i);
    const place = word(t.levels, key);
    putWord(t.levels, key, place + 1);
    fill(t, blockAt(t, place / LANES), place & (LANES - 1), i, (key & 1) != 0, step);
  }
  return blocks;
}

// Notes twice the level of each contact in its flags, one more for those that are solved alone, and counts the contacts
// of each such key in t.levels. Returns the number of keys, 0 where there are too many.
function findLevels(t: ContactTable, count: i32, rough: bool): i32 {
  const last = t.rowWords;
  memory.fill(last, 0, (<usize>t.bodyCount) << 2);
  let keys = 0;
  for (let k = 0; k < count; k++) {
    const i = word(t.order, k);
    const slotA = word(t.slotA, i);
    const slotB = word(t.slotB, i);
    const a = body(t, slotA);
    const b = body(t, slotB);
    const level = max<i32>(word(last, slotA), word(last, slotB));
    // What holds still is the same for all.
    if (a.inverseMass > 0) putWord(last, slotA, level + 1);
    if (b.inverseMass > 0) putWord(last, slotB, level + 1);
    const single = a.wall != 0 || b.wall != 0 || (rough && load<f32>(rubbing(t, i), 12) > 0);
    const key = 2 * level + i32(single);
    if (key >= keys) {
      const end = 2 * level + 2;
      if (end > t.mostLevels) return 0;
      memory.fill(t.levels + ((<usize>keys) << 2), 0, (<usize>(end - keys)) << 2);
      keys = end;
    }
    putWord(t.levels, key, word(t.levels, key) + 1);
    putWord(t.flags, i, key);
  }
  return keys;
}

// Lanes without a contact work on nobody, who does not move.
// @ts-ignore: decorator
@inline function empty(block: usize): void {
  const none = i32x4.splat(<i32>changetype<usize>(nobody()));
  v128.store(block, none);
  v128.store(block + B, none);
  v128.store(block + INDEX, i32x4.splat(-1));
  memory.fill(block + NX, 0, BLOCK - NX);
}

function fill(t: ContactTable, block: usize, lane: i32, i: i32, single: bool, step: real): void {
  putWord(block + INDEX, lane, i);
  if (single) return store<u32>(block, 0);
  putWord(block, lane, <i32>changetype<usize>(body(t, word(t.slotA, i))));
  putWord(block + B, lane, <i32>changetype<usize>(body(t, word(t.slotB, i))));
  put(block + NX, lane, get(t.nx, i));
  put(block + NY, lane, get(t.ny, i));
  put(block + NZ, lane, get(t.nz, i));
  put(block + RATE, lane, get(t.gap, i) / step);
  put(block + HOLDING, lane, get(t.holding, i));
}

// Puts the impulses of a block where those of the contacts are kept.
export function unpack(t: ContactTable, block: usize): void {
  if (isSingle(block)) return;
  for (let lane = 0; lane < LANES; lane++) {
    const i = contactIn(block, lane);
    if (i >= 0) put(t.holding, i, get(block + HOLDING, lane));
  }
}

// Brings the impulses of a block up to date, as `pressPair` does one: `half` is the time an impulse acts for, `step` what
// it acts for at most. With `start`, applies the impulses of the last step instead. Returns the changes of velocity.
export function pressBlock(block: usize, half: real, step: real, start: bool): v128 {
  const zero = splat(0);
  const nx = v128.load(block, NX);
  const ny = v128.load(block, NY);
  const nz = v128.load(block, NZ);
  const holding = v128.load(block, HOLDING);
  readQuads(block, MOTION);
  const avx = quads.q0;
  const avy = quads.q1;
  const avz = quads.q2;
  const wa = quads.q3;
  readQuads(block + B, MOTION);
  const bvx = quads.q0;
  const bvy = quads.q1;
  const bvz = quads.q2;
  const wb = quads.q3;
  const w = add(wa, wb);
  let impulse = holding;
  let active = v128.gt<real>(holding, zero);
  if (!start) {
    const excess = add(dot(sub(bvx, avx), sub(bvy, avy), sub(bvz, avz), nx, ny, nz), v128.load(block, RATE));
    const idle = v128.and(v128.ge<real>(excess, zero), v128.eq<real>(holding, zero));
    active = v128.andnot(v128.gt<real>(w, zero), idle);
    impulse = v128.max<real>(v128.neg<real>(holding), div(v128.neg<real>(excess), w));
  }
  const change = mul(v128.abs<real>(impulse), v128.max<real>(wa, wb));
  active = v128.and(active, v128.and(v128.ne<real>(impulse, zero), v128.lt<real>(change, splat(FINITE))));
  impulse = v128.and(impulse, active);
  v128.store(block, start ? impulse : add(holding, impulse), HOLDING);
  if (!v128.any_true(active)) return zero;

  readQuads(block, 0);
  const ax = quads.q0;
  const ay = quads.q1;
  const az = quads.q2;
  const ar = quads.q3;
  readQuads(block + B, 0);
  const bx = quads.q0;
  const by = quads.q1;
  const bz = quads.q2;
  const br = quads.q3;
  let time = splat(half);
  if (!start) {
    const gap = sub(dot(sub(bx, ax), sub(by, ay), sub(bz, az), nx, ny, nz), add(ar, br));
    const longer = v128.max<real>(time, v128.min<real>(splat(step), div(v128.neg<real>(gap), mul(impulse, w))));
    time = v128.bitselect(longer, time, v128.gt<real>(impulse, zero));
  }
  const ja = mul(impulse, wa);
  let dx = mul(ja, nx);
  let dy = mul(ja, ny);
  let dz = mul(ja, nz);
  writeQuads(block, MOTION, sub(avx, dx), sub(avy, dy), sub(avz, dz), wa);
  writeQuads(block, 0, sub(ax, mul(dx, time)), sub(ay, mul(dy, time)), sub(az, mul(dz, time)), ar);
  const jb = mul(impulse, wb);
  dx = mul(jb, nx);
  dy = mul(jb, ny);
  dz = mul(jb, nz);
  writeQuads(block + B, MOTION, add(bvx, dx), add(bvy, dy), add(bvz, dz), wb);
  writeQuads(block + B, 0, add(bx, mul(dx, time)), add(by, mul(dy, time)), add(bz, mul(dz, time)), br);
  return v128.and(change, active);
}

// Takes `part` of what the contacts of a block overlap by, less than `slop` of the radii and what goes by itself within
// `dt`, as `push` does for one.
export function pushBlock(block: usize, dt: real, part: real, slop: real): void {
  const nx = v128.load(block, NX);
  const ny = v128.load(block, NY);
  const nz = v128.load(block, NZ);
  readQuads(block, MOTION);
  const avx = quads.q0;
  const avy = quads.q1;
  const avz = quads.q2;
  const wa = quads.q3;
  readQuads(block + B, MOTION);
  const wb = quads.q3;
  const speed = dot(sub(quads.q0, avx), sub(quads.q1, avy), sub(quads.q2, avz), nx, ny, nz);
  readQuads(block, 0);
  const ax = quads.q0;
  const ay = quads.q1;
  const az = quads.q2;
  const ar = quads.q3;
  readQuads(block + B, 0);
  const bx = quads.q0;
  const by = quads.q1;
  const bz = quads.q2;
  const br = quads.q3;
  const dx = sub(bx, ax);
  const dy = sub(by, ay);
  const dz = sub(bz, az);
  const reach = add(ar, br);
  const overlap = sub(reach, v128.sqrt<real>(dot(dx, dy, dz, dx, dy, dz)));
  const goes = v128.max<real>(splat(0), mul(speed, splat(dt)));
  const depth = sub(sub(overlap, mul(splat(slop), reach)), goes);
  const sum = add(wa, wb);
  const active = v128.and(v128.gt<real>(depth, splat(0)), v128.gt<real>(sum, splat(0)));
  if (!v128.any_true(active)) return;
  const size = v128.and(div(mul(splat(part), depth), sum), active);
  const da = mul(size, wa);
  const db = mul(size, wb);
  writeQuads(block, 0, sub(ax, mul(nx, da)), sub(ay, mul(ny, da)), sub(az, mul(nz, da)), ar);
  writeQuads(block + B, 0, add(bx, mul(nx, db)), add(by, mul(ny, db)), add(bz, mul(nz, db)), br);
}
