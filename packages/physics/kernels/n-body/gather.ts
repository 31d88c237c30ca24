// Packs the bodies of a mutual force and scatters its results. Bodies are in ascending id: first the sources, then test
// particles. Bodies with non-finite values are left out until they are corrected.
import { columns, get, isWaiting, put } from '../memory/columns';
import { LANES } from '../memory/lanes';
import { NBody, coincident2 } from './workspace';

let changed: bool = false;

// Stores a value and records whether it changed.
// @ts-ignore: decorator
@inline function storeIfChanged(column: usize, slot: i32, value: real): void {
  if (get(column, slot) != value) {
    changed = true;
    put(column, slot, value);
  }
}

// @ts-ignore: decorator
@inline function isFinite3(x: real, y: real, z: real, s: real): bool {
  const sum = x * 0 + y * 0 + z * 0 + s * 0;
  return sum == 0 && s != 0;
}

// Returns the exponent of the smallest power of two above a positive number.
// @ts-ignore: decorator
@inline function exponentAbove(value: f64): i64 {
  return <i64>((reinterpret<u64>(value) >> 52) & 0x7ff) - 1022;
}

// Returns 2 to `exponent`, which is limited to what `real` can hold and divide by.
function powerOfTwo(exponent: i64): f64 {
  const maxExponent: i64 = sizeof<real>() == 4 ? 120 : 1000;
  const clamped = min<i64>(maxExponent, max<i64>(-maxExponent, exponent));
  return reinterpret<f64>((<u64>(clamped + 1023)) << 52);
}

// The unit of length is at most 2^TYPICAL_EXPONENT times the geometric mean of the distances from the origin, and at least
// 2^extentExponent() times the extent. So a few bodies far away, ejected by close encounters, do not make the seventh power
// of the distances of all others underflow, and the fifth power of the extent does not overflow.
const TYPICAL_EXPONENT: i64 = 6;
// @ts-ignore: decorator
@inline function extentExponent(): i64 {
  return sizeof<real>() == 4 ? -20 : -60;
}

let count: i32 = 0;
let testCount: i32 = 0;

// Determines extent and units, and counts the bodies.
function measure(w: NBody, column: usize, required: u32, testBit: u32, rows: i32): void {
  const c = columns();
  let lowX: real = Infinity;
  let lowY: real = Infinity;
  let lowZ: real = Infinity;
  let highX: real = -Infinity;
  let highY: real = -Infinity;
  let highZ: real = -Infinity;
  let strongest: real = 0;
  let exponents: i64 = 0;
  let measured: i64 = 0;
  count = 0;
  testCount = 0;
  for (let row = 0; row < rows; row++) {
    const bits = load<u32>(c.members + ((<usize>row) << 2));
    if ((bits & required) != required) continue;
    const x = get(c.positionX, row);
    const y = get(c.positionY, row);
    const z = get(c.positionZ, row);
    const s = get(column, row);
    if (!isFinite3(x, y, z, s) || isWaiting(row)) continue;
    lowX = min<real>(lowX, x);
    lowY = min<real>(lowY, y);
    lowZ = min<real>(lowZ, z);
    highX = max<real>(highX, x);
    highY = max<real>(highY, y);
    highZ = max<real>(highZ, z);
    const distance = max<real>(abs<real>(x), max<real>(abs<real>(y), abs<real>(z)));
    if (distance > 0) {
      exponents += exponentAbove(<f64>distance);
      measured++;
    }
    if (bits & testBit) {
      testCount++;
    } else {
      strongest = max<real>(strongest, abs<real>(s));
      count++;
    }
  }
  const extent = max<real>(highX - lowX, max<real>(highY - lowY, highZ - lowZ));
  const side = extent > 0 ? exponentAbove(<f64>extent) : 0;
  const typical = measured > 0 ? exponents / measured + TYPICAL_EXPONENT : side;
  const length = powerOfTwo(min<i64>(side, max<i64>(typical, side + extentExponent())));
  const strength = strongest > 0 ? powerOfTwo(exponentAbove(<f64>strongest)) : 1;
  if (length != w.length || strength != w.strength) changed = true;
  w.length = length;
  w.strength = strength;
  w.side = powerOfTwo(side) / length;
  w.lowX = <f64>lowX / length;
  w.lowY = <f64>lowY / length;
  w.lowZ = <f64>lowZ / length;
}

// Fills slots from `slot` with the bodies whose test bit is `expectedTestBit`; returns the slot after the last.
function pack(w: NBody, column: usize, required: u32, testBit: u32, expectedTestBit: u32, rows: i32, slot: i32): i32 {
  const c = columns();
  const perLength = <real>(1 / w.length);
  const perStrength = <real>(1 / w.strength);
  for (let row = 0; row < rows; row++) {
    const bits = load<u32>(c.members + ((<usize>row) << 2));
    if ((bits & required) != required || (bits & testBit) != expectedTestBit) continue;
    const x = get(c.positionX, row);
    const y = get(c.positionY, row);
    const z = get(c.positionZ, row);
    const s = get(column, row);
    if (!isFinite3(x, y, z, s) || isWaiting(row)) continue;
    const idAt = w.ids + ((<usize>slot) << 2);
    if (load<u32>(idAt) != row) changed = true;
    store<u32>(idAt, row);
    storeIfChanged(w.x, slot, x * perLength);
    storeIfChanged(w.y, slot, y * perLength);
    storeIfChanged(w.z, slot, z * perLength);
    storeIfChanged(w.s, slot, expectedTestBit != 0 ? 0 : s * perStrength);
    slot++;
  }
  return slot;
}

// Pads slots [slot, end) with zero strength at the position of an existing body.
function pad(w: NBody, slot: i32, end: i32): void {
  const from = slot > 0 ? slot - 1 : 0;
  for (; slot < end; slot++) {
    store<u32>(w.ids + ((<usize>slot) << 2), 0);
    put(w.x, slot, get(w.x, from));
    put(w.y, slot, get(w.y, from));
    put(w.z, slot, get(w.z, from));
    put(w.s, slot, 0);
  }
}

// Packs rows [0, rows) that have all `required` bits, with strengths from `column`. Returns the number of bodies; if
// any value changed, results and tree become invalid.
export function nBodyGather(
  address: usize,
  column: usize,
  required: u32,
  testBit: u32,
  softening: f64,
  rows: i32,
): i32 {
  const w = changetype<NBody>(address);
  changed = false;
  measure(w, column, required, testBit, rows);
  const sources = count;
  const tests = (sources + 7) & ~7;
  const end = tests + testCount;
  if (sources != w.sources || end != w.end) changed = true;
  const bodies = sources + testCount;
  if (end + 2 * LANES > w.capacity + 64) return -1;
  const scaled = softening / w.length;
  const softening2 = max<f64>(scaled * scaled, coincident2());
  if (softening2 != w.softening2) changed = true;
  pad(w, pack(w, column, required, testBit, 0, rows, 0), tests);
  if (testCount > 0) pack(w, column, required, testBit, testBit, rows, tests);
  pad(w, end, (end + 7) & ~7);
  w.sources = sources;
  w.tests = tests;
  w.end = end;
  w.bodies = bodies;
  w.softening2 = softening2;
  if (changed) {
    w.treeValid = 0;
    w.resultsValid = 0;
  }
  return bodies;
}

// Adds the results to the force columns, N. `coefficient` converts strength²/length^power to newtons.
export function nBodyScatter(
  address: usize,
  column: usize,
  fx: usize,
  fy: usize,
  fz: usize,
  coefficient: f64,
  power: i32,
): void {
  const w = changetype<NBody>(address);
  const perLength = power == 2 ? 1 / (w.length * w.length) : 1 / w.length;
  const scale = coefficient * w.strength * perLength;
  const last = w.resultsByTree ? w.bodies : w.end;
  for (let position = 0; position < last; position++) {
    const slot = w.resultsByTree ? load<i32>(w.order + ((<usize>position) << 2)) : position;
    const row = load<u32>(w.ids + ((<usize>slot) << 2));
    if (row == 0) continue;
    // The direct sum stores forces between the sources, which are equal and opposite to the last bit.
    const own = w.resultsByTree || slot >= w.tests ? <f64>get(column, row) : w.strength;
    const k = scale * own;
    put(fx, row, get(fx, row) + <real>(k * <f64>get(w.ax, position)));
    put(fy, row, get(fy, row) + <real>(k * <f64>get(w.ay, position)));
    if (fz != 0) put(fz, row, get(fz, row) + <real>(k * <f64>get(w.az, position)));
  }
}
