// What the rows take from the columns: once a step, because stiffness, length and mass may be changed in place.
import { columns, get, put } from '../columns';
import { SpringTable } from '../forces/springs';
import { RIGID, putWord, tableAt, useTable, word } from './table';

// Reads all springs for sub-steps of h seconds; 0 when one joins other bodies than its row says.
//
// With w the sum of the inverse masses and s = k h^2, a row changes its tension by gain C - softness tension, where
// gain = s / (s w + 1) and softness = 1 / (s w + 1). A rod's are 1 / w and 0.
export function readConstraints(table: usize, movable: u32, h: f64): i32 {
  const t = tableAt(table);
  useTable(t);
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
    const per: f64 = w > 0 ? 1 / (rigid ? w : s * w + 1) : 0;
    put(t.gain, row, <real>(rigid ? per : s * per));
    put(t.softness, row, rigid ? 0 : <real>per);
    if (rigid) rods++;
    else if (get(springs.damping, spring) > 0) t.damped++;
    if (get(t.breakForce, spring) > 0) t.breakable++;
  }
  const chained = word(t.chains, t.chainCount);
  t.rigid = i32(rods == chained && <u32>t.rowCount < chained + 4);
  return 1;
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

// Largest |d - L| / L of the springs stiffer than `stiffness`.
export function largestStretch(table: usize, stiffness: f64): f64 {
  const springs = changetype<SpringTable>(tableAt(table).springs);
  let most: f64 = 0;
  for (let i = 0; i < springs.active; i++) most = max<f64>(most, stretchOf(springs, i, stiffness));
  return most;
}

// The root of the mean square of the same.
export function rmsStretch(table: usize, stiffness: f64): f64 {
  const springs = changetype<SpringTable>(tableAt(table).springs);
  let sum: f64 = 0;
  let count = 0;
  for (let i = 0; i < springs.active; i++) {
    const stretch = stretchOf(springs, i, stiffness);
    if (stretch < 0) continue;
    sum += stretch * stretch;
    count++;
  }
  return count == 0 ? 0 : sqrt<f64>(sum / <f64>count);
}

// Below zero for a spring that does not count: a softer one, one without length, a slack cord.
// @ts-ignore: decorator
@inline function stretchOf(springs: SpringTable, i: i32, stiffness: f64): f64 {
  const spring = load<u32>(springs.links + <usize>i * 12);
  const length = <f64>get(springs.length, spring);
  if (length == 0 || <f64>get(springs.stiffness, spring) < stiffness) return -1;
  const extension = extensionOf(springs, i);
  if (extension < 0 && word(springs.cord, spring) != 0) return -1;
  return abs<f64>(extension) / length;
}
