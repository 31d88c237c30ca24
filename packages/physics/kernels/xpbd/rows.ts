// What the rows take from the columns, whenever stiffness, length or mass was changed in place.
import { columns, get, put } from '../memory/columns';
import { SpringTable } from '../forces/springs';
import { ConstraintTable, RIGID, putWord, tableAt, word } from './table';
import { areUnchanged, forgetSum } from './checksum';

// Stiffness and inverse masses of the row read last, and what follows from them: most rows of a network are alike.
let stiffness: real = 0;
let inverseA: real = -1;
let inverseB: real = -1;
let gain: real = 0;
let softness: real = 0;
// For a row of a strand: sum of the inverse masses plus flexibility, and flexibility.
let diagonal: real = 0;
let flexibility: real = 0;
let isRod: bool = false;
let rods: i32 = 0;

// A k h^2 whose inverse is finite in f32.
const LEAST_STIFFNESS: f64 = 1e-30;

// Reads all springs for sub-steps of h seconds, unless they are what they were; 0 when one joins other bodies than its
// row says.
//
// With w the sum of the inverse masses and s = k h^2, a row changes its tension by gain C - softness tension, where
// gain = s / (s w + 1) and softness = 1 / (s w + 1). A rod's are 1 / w and 0. Rows of strands hold w + 1 / s and 1 / s
// in their place, infinity and 0 where nothing pulls.
export function readConstraints(table: usize, movable: u32, h: f64): i32 {
  const t = tableAt(table);
  if (areUnchanged(t, h)) return 1;
  const springs = changetype<SpringTable>(t.springs);
  const c = columns();
  for (let i = 0; i < t.nodeCount; i++) {
    const body = word(t.nodes, i);
    const mass = get(c.mass, body);
    const moves = mass > 0 && (word(c.members, body) & movable) == movable;
    put(t.inverse, body, moves ? 1 / mass : 0);
  }
  inverseA = -1;
  rods = 0;
  t.damped = 0;
  t.breakable = 0;
  for (let row = 0; row < t.rowCount; row++) {
    if (readRow(t, springs, row, h)) continue;
    forgetSum(t);
    return 0;
  }
  const chained = word(t.chains, t.chainCount);
  t.rigid = i32(rods == chained && <u32>t.rowCount < chained + 4);
  return 1;
}

// False when the spring joins other bodies than its row says.
// @ts-ignore: decorator
@inline function readRow(t: ConstraintTable, springs: SpringTable, row: i32, h: f64): bool {
  const spring = word(t.source, row);
  const isInStrand = <u32>row >= word(t.strands, 0) && <u32>row < word(t.strands, t.strandCount);
  if (spring == 0) {
    put(t.gain, row, isInStrand ? Infinity : 0);
    return true;
  }
  const a = word(t.a, row);
  const b = word(t.b, row);
  const isA = word(springs.a, spring);
  const isB = word(springs.b, spring);
  if (!((isA == a && isB == b) || (isA == b && isB == a))) return false;
  const length = get(springs.length, spring);
  put(t.length, row, word(springs.cord, spring) != 0 ? -length : length);
  const k = get(springs.stiffness, spring);
  const wa = get(t.inverse, a);
  const wb = get(t.inverse, b);
  if (wa != inverseA || wb != inverseB || k != stiffness) weigh(k, wa, wb, h);
  put(t.gain, row, isInStrand ? diagonal : gain);
  put(t.softness, row, isInStrand ? flexibility : softness);
  if (isRod) rods++;
  else if (get(springs.damping, spring) > 0) t.damped++;
  if (get(t.breakForce, spring) > 0) t.breakable++;
  return true;
}

function weigh(k: real, wa: real, wb: real, h: f64): void {
  stiffness = k;
  inverseA = wa;
  inverseB = wb;
  isRod = <f64>k >= RIGID;
  const w = <f64>wa + <f64>wb;
  const s = <f64>k * h * h;
  const per: f64 = w > 0 ? 1 / (isRod ? w : s * w + 1) : 0;
  gain = <real>(isRod ? per : s * per);
  softness = isRod ? 0 : <real>per;
  const pulls = w > 0 && s > LEAST_STIFFNESS;
  flexibility = isRod || !pulls ? 0 : <real>(1 / s);
  diagonal = pulls ? <real>(isRod ? w : w + 1 / s) : Infinity;
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
export function maxStrain(table: usize, stiffness: f64): f64 {
  const springs = changetype<SpringTable>(tableAt(table).springs);
  let most: f64 = 0;
  for (let i = 0; i < springs.active; i++) most = max<f64>(most, stretchOf(springs, i, stiffness));
  return most;
}

// The root of the mean square of the same.
export function rmsStrain(table: usize, stiffness: f64): f64 {
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
