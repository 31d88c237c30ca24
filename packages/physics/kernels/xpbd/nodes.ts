// The bodies at springs: packed for the solver, kicked, and given back what it found. LANES of them at once where their
// ids follow each other, with the same result as one by one.
import { Columns, columns, get, put } from '../memory/columns';
import { LANES, add, at, mul, splat, sub } from '../memory/lanes';
import { turned0, turned1, turned2, turned3 } from './packed-bodies';
import { ConstraintTable, packedAt, part, putPart, tableAt, word } from './table';

// Largest coordinate the solver looks at, m; that of src/components/position.ts. Its square is finite in f32.
const FAR: real = 1e15;

// Whether the bodies from the i-th on are a run of LANES. Ids ascend.
// @ts-ignore: decorator
@inline function isRunAt(t: ConstraintTable, i: i32): bool {
  return i + LANES <= t.nodeCount && word(t.nodes, i + LANES - 1) - word(t.nodes, i) == <u32>(LANES - 1);
}

// Packs the bodies.
export function packBodies(table: usize): void {
  const t = tableAt(table);
  const c = columns();
  for (let i = 0; i < t.nodeCount; ) {
    const body = word(t.nodes, i);
    if (!isRunAt(t, i)) {
      packBody(t, body);
      i++;
      continue;
    }
    const o = at(body);
    const p = packedAt(t, body);
    const x = v128.load(c.positionX + o);
    const y = v128.load(c.positionY + o);
    const z = v128.load(c.positionZ + o);
    const good = v128.and(v128.and(isNear(x), isNear(y)), isNear(z));
    const toX = v128.and(x, good);
    const toY = v128.and(y, good);
    const toZ = v128.and(z, good);
    const inverse = v128.and(v128.load(t.inverse + o), good);
    v128.store(p, turned0(toX, toY, toZ, inverse));
    v128.store(p + secondAt(1), turned1(toX, toY, toZ, inverse));
    v128.store(p + secondAt(2), turned2(toX, toY, toZ, inverse));
    v128.store(p, turned3(toX, toY, toZ, inverse), 48);
    i += LANES;
  }
}

// Where the k-th of four vectors stands whose bodies follow each other: lanes.ts.
// @ts-ignore: decorator
@inline function secondAt(k: i32): usize {
  return sizeof<real>() == 4 || k == 3 ? (<usize>k) << 4 : (<usize>(3 - k)) << 4;
}

// @ts-ignore: decorator
@inline function isNear(x: v128): v128 {
  return v128.le<real>(v128.abs<real>(x), splat(FAR));
}

// One whose position is no number is packed at the origin as an anchor, so that it spreads nothing.
export function packBody(t: ConstraintTable, body: u32): void {
  const c = columns();
  const x = get(c.positionX, body);
  const y = get(c.positionY, body);
  const z = get(c.positionZ, body);
  const p = packedAt(t, body);
  const good = abs<real>(x) <= FAR && abs<real>(y) <= FAR && abs<real>(z) <= FAR;
  putPart(p, 0, good ? x : 0);
  putPart(p, 1, good ? y : 0);
  putPart(p, 2, good ? z : 0);
  putPart(p, 3, good ? get(t.inverse, body) : 0);
}

// Kicks the bodies at springs by their force for h seconds more, and lets them drift `drift` seconds with what they gain.
export function kickNodes(table: usize, fx: usize, fy: usize, fz: usize, h: f64, drift: f64): void {
  const t = tableAt(table);
  const c = columns();
  for (let i = 0; i < t.nodeCount; ) {
    const body = word(t.nodes, i);
    const isRun = isRunAt(t, i);
    kick(t, body, isRun, c.positionX, c.velocityX, fx, <real>h, <real>drift);
    kick(t, body, isRun, c.positionY, c.velocityY, fy, <real>h, <real>drift);
    if (fz != 0) kick(t, body, isRun, c.positionZ, c.velocityZ, fz, <real>h, <real>drift);
    i += isRun ? LANES : 1;
  }
}

// @ts-ignore: decorator
@inline function kick(
  t: ConstraintTable,
  body: u32,
  isRun: bool,
  position: usize,
  velocity: usize,
  force: usize,
  h: real,
  drift: real,
): void {
  if (!isRun) {
    const gain = h * get(t.inverse, body) * get(force, body);
    put(velocity, body, get(velocity, body) + gain);
    put(position, body, get(position, body) + drift * gain);
    return;
  }
  const o = at(body);
  const gain = mul(mul(splat(h), v128.load(t.inverse + o)), v128.load(force + o));
  v128.store(velocity + o, add(v128.load(velocity + o), gain));
  v128.store(position + o, add(v128.load(position + o), mul(splat(drift), gain)));
}

// Gives the bodies their corrected positions, and the velocity h seconds of which are the correction.
export function unpackBodies(table: usize, h: f64): void {
  const t = tableAt(table);
  const c = columns();
  const rate = <real>(1 / h);
  for (let i = 0; i < t.nodeCount; ) {
    const body = word(t.nodes, i);
    const isRun = isRunAt(t, i);
    const p = packedAt(t, body);
    if (isRun) correctRun(c, p, at(body), splat(rate));
    else if (part(p, 3) != 0) {
      correct(c.positionX, c.velocityX, body, part(p, 0), rate);
      correct(c.positionY, c.velocityY, body, part(p, 1), rate);
      correct(c.positionZ, c.velocityZ, body, part(p, 2), rate);
    }
    i += isRun ? LANES : 1;
  }
}

// @ts-ignore: decorator
@inline function correct(position: usize, velocity: usize, body: u32, to: real, rate: real): void {
  const from = get(position, body);
  put(velocity, body, get(velocity, body) + (to - from) * rate);
  put(position, body, to);
}

// @ts-ignore: decorator
@inline function correctRun(c: Columns, p: usize, o: usize, rate: v128): void {
  const v0 = v128.load(p);
  const v1 = v128.load(p + secondAt(1));
  const v2 = v128.load(p + secondAt(2));
  const v3 = v128.load(p, 48);
  const moves = v128.ne<real>(turned3(v0, v1, v2, v3), splat(0));
  correctAxis(c.positionX + o, c.velocityX + o, turned0(v0, v1, v2, v3), moves, rate);
  correctAxis(c.positionY + o, c.velocityY + o, turned1(v0, v1, v2, v3), moves, rate);
  correctAxis(c.positionZ + o, c.velocityZ + o, turned2(v0, v1, v2, v3), moves, rate);
}

// @ts-ignore: decorator
@inline function correctAxis(position: usize, velocity: usize, to: v128, moves: v128, rate: v128): void {
  const from = v128.load(position);
  const speed = v128.load(velocity);
  const gained = add(speed, mul(sub(to, from), rate));
  v128.store(velocity, v128.bitselect(gained, speed, moves));
  v128.store(position, v128.bitselect(to, from, moves));
}
