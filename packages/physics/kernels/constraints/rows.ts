// What the rows take from the columns: once a step, because stiffness, length and mass may be changed in place.
import { columns, get, put } from '../columns';
import { SpringTable } from '../forces/springs';
import { ConstraintTable, RIGID, packedAt, part, putPart, putWord, tableAt, word } from './table';

// Largest coordinate the solver looks at, m; that of src/components/position.ts. Its square is finite in f32.
const FAR: f64 = 1e15;

// Reads all springs for sub-steps of h seconds; 0 when one joins other bodies than its row says.
//
// With w the sum of the inverse masses and s = k h^2, a row changes its tension by gain C - softness tension, where
// gain = s / (s w + 1) and softness = 1 / (s w + 1). A rod's are 1 / w and 0.
export function readConstraints(table: usize, movable: u32, h: f64): i32 {
  const t = tableAt(table);
  const springs = changetype<SpringTable>(t.springs);
  const c = columns();
  for (let i = 0; i < t.nodeCount; i++) {
    const body = word(t.nodes, i);
    const mass = get(c.mass, body);
    const moves = mass > 0 && (word(c.members, body) & movable) == movable;
    put(t.inverse, body, moves ? 1 / mass : 0);
  }
  let rods: u32 = 0;
  t.damped = 0;
  t.breakable = 0;
  for (let row = 0; row < t.rowCount; row++) {
    const spring = word(t.source, row);
    if (spring == 0) continue;
    const a = word(t.a, row);
    const b = word(t.b, row);
    const isA = word(springs.a, spring);
    const isB = word(springs.b, spring);
    if (!((isA == a && isB == b) || (isA == b && isB == a))) return 0;
    const length = get(springs.length, spring);
    put(t.length, row, word(springs.cord, spring) != 0 ? -length : length);
    const w = <f64>get(t.inverse, a) + <f64>get(t.inverse, b);
    const k = <f64>get(springs.stiffness, spring);
    const s = k * h * h;
    const rigid = k >= RIGID;
    const softness: f64 = w > 0 ? (rigid ? 0 : 1 / (s * w + 1)) : 0;
    put(t.gain, row, w > 0 ? <real>(rigid ? 1 / w : s * softness) : 0);
    put(t.softness, row, <real>softness);
    if (rigid) rods++;
    else if (get(springs.damping, spring) > 0) t.damped++;
    if (get(t.breakForce, spring) > 0) t.breakable++;
  }
  const chained = word(t.chains, t.chainCount);
  t.rigid = i32(rods == chained && <u32>t.rowCount < chained + 4);
  return 1;
}

// Packs the bodies.
export function packBodies(table: usize): void {
  const t = tableAt(table);
  for (let i = 0; i < t.nodeCount; i++) packBody(t, word(t.nodes, i));
}

// One whose position is no number is packed at the origin as an anchor, so that it spreads nothing.
export function packBody(t: ConstraintTable, body: u32): void {
  const c = columns();
  const x = get(c.positionX, body);
  const y = get(c.positionY, body);
  const z = get(c.positionZ, body);
  const p = packedAt(t, body);
  const good = abs(<f64>x) <= FAR && abs(<f64>y) <= FAR && abs(<f64>z) <= FAR;
  putPart(p, 0, good ? x : 0);
  putPart(p, 1, good ? y : 0);
  putPart(p, 2, good ? z : 0);
  putPart(p, 3, good ? get(t.inverse, body) : 0);
}

// Kicks the bodies at springs by their force for h seconds more, and lets them drift `drift` seconds with what they gain.
export function kickNodes(table: usize, fx: usize, fy: usize, fz: usize, h: f64, drift: f64): void {
  const t = tableAt(table);
  const c = columns();
  for (let i = 0; i < t.nodeCount; i++) {
    const body = word(t.nodes, i);
    const rate = <real>h * get(t.inverse, body);
    const way = rate * <real>drift;
    put(c.velocityX, body, get(c.velocityX, body) + rate * get(fx, body));
    put(c.velocityY, body, get(c.velocityY, body) + rate * get(fy, body));
    put(c.positionX, body, get(c.positionX, body) + way * get(fx, body));
    put(c.positionY, body, get(c.positionY, body) + way * get(fy, body));
    if (fz == 0) continue;
    put(c.velocityZ, body, get(c.velocityZ, body) + rate * get(fz, body));
    put(c.positionZ, body, get(c.positionZ, body) + way * get(fz, body));
  }
}

// Gives the bodies their corrected positions, and the velocity h seconds of which are the correction.
export function unpackBodies(table: usize, h: f64): void {
  const t = tableAt(table);
  const c = columns();
  const rate = <real>(1 / h);
  for (let i = 0; i < t.nodeCount; i++) {
    const body = word(t.nodes, i);
    const p = packedAt(t, body);
    if (part(p, 3) == 0) continue;
    correct(c.positionX, c.velocityX, body, part(p, 0), rate);
    correct(c.positionY, c.velocityY, body, part(p, 1), rate);
    correct(c.positionZ, c.velocityZ, body, part(p, 2), rate);
  }
}

// @ts-ignore: decorator
@inline function correct(position: usize, velocity: usize, body: u32, to: real, rate: real): void {
  const from = get(position, body);
  put(velocity, body, get(velocity, body) + (to - from) * rate);
  put(position, body, to);
}

// Lists the springs pulled harder than they bear; `h` is the sub-step the tensions belong to.
export function findBroken(table: usize, h: f64): i32 {
  const t = tableAt(table);
  let count = 0;
  for (let row = 0; row < t.rowCount; row++) {
    const spring = word(t.source, row);
    if (spring == 0) continue;
    const limit = <f64>get(t.breakForce, spring);
    if (limit > 0 && <f64>get(t.tension, row) > limit * h * h) putWord(t.broken, count++, spring);
  }
  return count;
}

// The same where springs are forces, by Hooke's law.
export function findOverloaded(table: usize): i32 {
  const t = tableAt(table);
  const springs = changetype<SpringTable>(t.springs);
  let count = 0;
  for (let i = 0; i < springs.active; i++) {
    const spring = load<u32>(springs.links + <usize>i * 12);
    const limit = <f64>get(t.breakForce, spring);
    if (limit > 0 && <f64>get(springs.stiffness, spring) * extensionOf(springs, i) > limit) {
      putWord(t.broken, count++, spring);
    }
  }
  return count;
}

// @ts-ignore: decorator
@inline function extensionOf(springs: SpringTable, i: i32): f64 {
  const c = columns();
  const link = springs.links + <usize>i * 12;
  const a = load<u32>(link, 4);
  const b = load<u32>(link, 8);
  const x = <f64>get(c.positionX, b) - <f64>get(c.positionX, a);
  const y = <f64>get(c.positionY, b) - <f64>get(c.positionY, a);
  const z = <f64>get(c.positionZ, b) - <f64>get(c.positionZ, a);
  return sqrt<f64>(x * x + y * y + z * z) - <f64>get(springs.length, load<u32>(link));
}

// Largest |d - L| / L of the springs stiffer than `stiffness`; slack cords count nothing.
export function largestStretch(table: usize, stiffness: f64): f64 {
  const springs = changetype<SpringTable>(tableAt(table).springs);
  let most: f64 = 0;
  for (let i = 0; i < springs.active; i++) {
    const spring = load<u32>(springs.links + <usize>i * 12);
    const length = <f64>get(springs.length, spring);
    if (length == 0 || <f64>get(springs.stiffness, spring) < stiffness) continue;
    const extension = extensionOf(springs, i);
    if (extension < 0 && word(springs.cord, spring) != 0) continue;
    most = max<f64>(most, abs<f64>(extension) / length);
  }
  return most;
}
