// Copies stiffness, length and mass from the columns into the rows, whenever one was changed in place.
import { columns, get, put } from '../memory/columns';
import { SpringTable } from '../forces/springs';
import { ConstraintTable, RIGID, putWord, tableAt, word } from './table';
import { rodImpulse } from './chain';
import { invalidateChecksum, updateChecksum } from './checksum';

// The stiffness and inverse masses of the last row, and the coefficients that follow from them: most rows of a soft
// body are alike, so the divisions are cached.
let stiffness: real = 0;
let inverseA: real = -1;
let inverseB: real = -1;
let gain: real = 0;
let softness: real = 0;
// For a row of a batch: the sum of the inverse masses plus the compliance term, and the compliance term.
let diagonal: real = 0;
let compliance: real = 0;
let isRod: bool = false;
let rodCount: i32 = 0;

// The minimum of k h^2 whose inverse is finite in f32.
const MIN_STIFFNESS: f64 = 1e-30;

// Reads all springs for sub-steps of h seconds, unless their checksum is unchanged. Returns 0 if a spring joins
// bodies other than its row says.
//
// With w the sum of the inverse masses and s = k h^2, a row changes its tension by gain C - softness tension, where
// gain = s / (s w + 1) and softness = 1 / (s w + 1): gain is 1 / (w + alpha) and softness alpha gain, with the XPBD
// compliance alpha = 1 / s. For a rod they are 1 / w and 0. Rows of batches store w + alpha and alpha instead, or
// infinity and 0 where the spring has no effect.
export function readConstraints(table: usize, movable: u32, h: f64): i32 {
  const t = tableAt(table);
  if (updateChecksum(t, h)) return 1;
  const springs = changetype<SpringTable>(t.springs);
  const c = columns();
  for (let i = 0; i < t.nodeCount; i++) {
    const body = word(t.nodes, i);
    const mass = get(c.mass, body);
    const moves = mass > 0 && (word(c.members, body) & movable) == movable;
    put(t.inverseMass, body, moves ? 1 / mass : 0);
  }
  inverseA = -1;
  rodCount = 0;
  t.damped = 0;
  t.breakable = 0;
  for (let row = 0; row < t.rowCount; row++) {
    if (readRow(t, springs, row, h)) continue;
    invalidateChecksum(t);
    return 0;
  }
  const chainedCount = word(t.chains, t.chainCount);
  t.onlyRodChains = i32(rodCount == chainedCount && <u32>t.rowCount < chainedCount + 4);
  return 1;
}

// Returns false if the spring joins bodies other than its row says.
// @ts-ignore: decorator
@inline function readRow(t: ConstraintTable, springs: SpringTable, row: i32, h: f64): bool {
  const spring = word(t.springIds, row);
  const isInBatch = <u32>row >= word(t.batches, 0) && <u32>row < word(t.batches, t.batchCount);
  if (spring == 0) {
    put(t.gain, row, isInBatch ? Infinity : 0);
    return true;
  }
  const a = word(t.a, row);
  const b = word(t.b, row);
  const currentA = word(springs.a, spring);
  const currentB = word(springs.b, spring);
  if (!((currentA == a && currentB == b) || (currentA == b && currentB == a))) return false;
  const length = get(springs.length, spring);
  put(t.length, row, word(springs.tensionOnly, spring) != 0 ? -length : length);
  const k = get(springs.stiffness, spring);
  const wa = get(t.inverseMass, a);
  const wb = get(t.inverseMass, b);
  if (wa != inverseA || wb != inverseB || k != stiffness) updateCoefficients(k, wa, wb, h);
  put(t.gain, row, isInBatch ? diagonal : gain);
  put(t.softness, row, isInBatch ? compliance : softness);
  if (isRod) rodCount++;
  else if (get(springs.damping, spring) > 0) t.damped++;
  if (get(t.breakForce, spring) > 0) t.breakable++;
  return true;
}

function updateCoefficients(k: real, wa: real, wb: real, h: f64): void {
  stiffness = k;
  inverseA = wa;
  inverseB = wb;
  isRod = <f64>k >= RIGID;
  const w = <f64>wa + <f64>wb;
  const s = <f64>k * h * h;
  const scale: f64 = w > 0 ? 1 / (isRod ? w : s * w + 1) : 0;
  gain = <real>(isRod ? scale : s * scale);
  softness = isRod ? 0 : <real>scale;
  const isEffective = w > 0 && s > MIN_STIFFNESS;
  compliance = isRod || !isEffective ? 0 : <real>(1 / s);
  diagonal = isEffective ? <real>(isRod ? w : w + 1 / s) : Infinity;
}

// Lists the springs whose tension exceeds their breaking force; `h` is the sub-step of the stored tensions, s.
export function findBroken(table: usize, h: f64): i32 {
  const t = tableAt(table);
  let count = 0;
  for (let row = 0; row < t.rowCount; row++) {
    const spring = word(t.springIds, row);
    if (spring == 0) continue;
    const limit = <f64>get(t.breakForce, spring);
    if (limit == 0) continue;
    const tension = t.onlyRodChains != 0 ? rodImpulse(t, row, h) : <f64>get(t.tension, row);
    if (tension > limit * h * h) putWord(t.broken, count++, spring);
  }
  return count;
}

// Lists the same for springs that act as forces, by Hooke's law.
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

// Returns the largest |d - L| / L of the springs with at least `stiffness`.
export function maxStrain(table: usize, stiffness: f64): f64 {
  const springs = changetype<SpringTable>(tableAt(table).springs);
  let largest: f64 = 0;
  for (let i = 0; i < springs.active; i++) largest = max<f64>(largest, strainOf(springs, i, stiffness));
  return largest;
}

// Returns the root mean square of |d - L| / L of the springs with at least `stiffness`.
export function rmsStrain(table: usize, stiffness: f64): f64 {
  const springs = changetype<SpringTable>(tableAt(table).springs);
  let sum: f64 = 0;
  let count = 0;
  for (let i = 0; i < springs.active; i++) {
    const strain = strainOf(springs, i, stiffness);
    if (strain < 0) continue;
    sum += strain * strain;
    count++;
  }
  return count == 0 ? 0 : sqrt<f64>(sum / <f64>count);
}

// Returns -1 for a spring that does not count: one softer than `stiffness`, without length, or slack and
// tension-only.
// @ts-ignore: decorator
@inline function strainOf(springs: SpringTable, i: i32, stiffness: f64): f64 {
  const spring = load<u32>(springs.links + <usize>i * 12);
  const length = <f64>get(springs.length, spring);
  if (length == 0 || <f64>get(springs.stiffness, spring) < stiffness) return -1;
  const extension = extensionOf(springs, i);
  if (extension < 0 && word(springs.tensionOnly, spring) != 0) return -1;
  return abs<f64>(extension) / length;
}
