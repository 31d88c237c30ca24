// The nodes (bodies at springs): packs them for the solver, applies forces to them, and writes the solution back.
// LANES nodes whose ids are consecutive are handled at once, with the same result as one by one.
import { Columns, columns, get, put } from '../memory/columns';
import { LANES, add, at, mul, splat, sub } from '../memory/lanes';
import { transpose0, transpose1, transpose2, transpose3 } from './packed-bodies';
import { ConstraintTable, packedAt, packedComponent, putPackedComponent, tableAt, word } from './table';

// The largest coordinate that the solver accepts, m, as in src/components/position.ts. Its square is finite in f32.
const MAX_COORDINATE: real = 1e15;

// Tests whether the ids of LANES nodes from index i on are consecutive. Ids ascend.
// @ts-ignore: decorator
@inline function isRunAt(t: ConstraintTable, i: i32): bool {
  return i + LANES <= t.nodeCount && word(t.nodes, i + LANES - 1) - word(t.nodes, i) == <u32>(LANES - 1);
}

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
    const isValid = v128.and(v128.and(isInRange(x), isInRange(y)), isInRange(z));
    const toX = v128.and(x, isValid);
    const toY = v128.and(y, isValid);
    const toZ = v128.and(z, isValid);
    const inverse = v128.and(v128.load(t.inverseMass + o), isValid);
    v128.store(p, transpose0(toX, toY, toZ, inverse));
    v128.store(p + vectorOffset(1), transpose1(toX, toY, toZ, inverse));
    v128.store(p + vectorOffset(2), transpose2(toX, toY, toZ, inverse));
    v128.store(p, transpose3(toX, toY, toZ, inverse), 48);
    i += LANES;
  }
}

// Offset of the k-th of four vectors if the bodies are consecutive: packed-bodies.ts.
// @ts-ignore: decorator
@inline function vectorOffset(k: i32): usize {
  return sizeof<real>() == 4 || k == 3 ? (<usize>k) << 4 : (<usize>(3 - k)) << 4;
}

// @ts-ignore: decorator
@inline function isInRange(x: v128): v128 {
  return v128.le<real>(v128.abs<real>(x), splat(MAX_COORDINATE));
}

// Packs a body. A position that is not a number or too large becomes an anchor at the origin, so that it cannot
// spread.
export function packBody(t: ConstraintTable, body: u32): void {
  const c = columns();
  const x = get(c.positionX, body);
  const y = get(c.positionY, body);
  const z = get(c.positionZ, body);
  const p = packedAt(t, body);
  const isValid = abs<real>(x) <= MAX_COORDINATE && abs<real>(y) <= MAX_COORDINATE && abs<real>(z) <= MAX_COORDINATE;
  putPackedComponent(p, 0, isValid ? x : 0);
  putPackedComponent(p, 1, isValid ? y : 0);
  putPackedComponent(p, 2, isValid ? z : 0);
  putPackedComponent(p, 3, isValid ? get(t.inverseMass, body) : 0);
}

// Applies the force on each node for h seconds more, and lets the node drift with the gained velocity for `drift`
// seconds.
export function kickNodes(table: usize, fx: usize, fy: usize, fz: usize, h: f64, drift: f64): void {
  const t = tableAt(table);
  const c = columns();
  for (let i = 0; i < t.nodeCount; ) {
    const body = word(t.nodes, i);
    const isRun = isRunAt(t, i);
    applyForce(t, body, isRun, c.positionX, c.velocityX, fx, <real>h, <real>drift);
    applyForce(t, body, isRun, c.positionY, c.velocityY, fy, <real>h, <real>drift);
    if (fz != 0) applyForce(t, body, isRun, c.positionZ, c.velocityZ, fz, <real>h, <real>drift);
    i += isRun ? LANES : 1;
  }
}

// @ts-ignore: decorator
@inline function applyForce(
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
    const gain = h * get(t.inverseMass, body) * get(force, body);
    put(velocity, body, get(velocity, body) + gain);
    put(position, body, get(position, body) + drift * gain);
    return;
  }
  const o = at(body);
  const gain = mul(mul(splat(h), v128.load(t.inverseMass + o)), v128.load(force + o));
  v128.store(velocity + o, add(v128.load(velocity + o), gain));
  v128.store(position + o, add(v128.load(position + o), mul(splat(drift), gain)));
}

// Writes the corrected positions to the columns, and adds to the velocities the corrections divided by h.
export function unpackBodies(table: usize, h: f64): void {
  const t = tableAt(table);
  const c = columns();
  const rate = <real>(1 / h);
  for (let i = 0; i < t.nodeCount; ) {
    const body = word(t.nodes, i);
    const isRun = isRunAt(t, i);
    const p = packedAt(t, body);
    if (isRun) correctRun(c, p, at(body), splat(rate));
    else if (packedComponent(p, 3) != 0) {
      correctBody(c.positionX, c.velocityX, body, packedComponent(p, 0), rate);
      correctBody(c.positionY, c.velocityY, body, packedComponent(p, 1), rate);
      correctBody(c.positionZ, c.velocityZ, body, packedComponent(p, 2), rate);
    }
    i += isRun ? LANES : 1;
  }
}

// @ts-ignore: decorator
@inline function correctBody(position: usize, velocity: usize, body: u32, to: real, rate: real): void {
  const from = get(position, body);
  put(velocity, body, get(velocity, body) + (to - from) * rate);
  put(position, body, to);
}

// @ts-ignore: decorator
@inline function correctRun(c: Columns, p: usize, o: usize, rate: v128): void {
  const v0 = v128.load(p);
  const v1 = v128.load(p + vectorOffset(1));
  const v2 = v128.load(p + vectorOffset(2));
  const v3 = v128.load(p, 48);
  const isMovable = v128.ne<real>(transpose3(v0, v1, v2, v3), splat(0));
  correctAxis(c.positionX + o, c.velocityX + o, transpose0(v0, v1, v2, v3), isMovable, rate);
  correctAxis(c.positionY + o, c.velocityY + o, transpose1(v0, v1, v2, v3), isMovable, rate);
  correctAxis(c.positionZ + o, c.velocityZ + o, transpose2(v0, v1, v2, v3), isMovable, rate);
}

// @ts-ignore: decorator
@inline function correctAxis(position: usize, velocity: usize, to: v128, isMovable: v128, rate: v128): void {
  const from = v128.load(position);
  const speed = v128.load(velocity);
  const gained = add(speed, mul(sub(to, from), rate));
  v128.store(velocity, v128.bitselect(gained, speed, isMovable));
  v128.store(position, v128.bitselect(to, from, isMovable));
}
