// The field of all sources at one point by direct summation: for test particles, and to measure the tree's error.
import { get, put } from '../memory/columns';
import { LANES, add, at, mul, sub, splat } from '../memory/lanes';
import { laneSum, scaledStrength } from './direct';
import { approximateMedian } from './approximate-median';
import { NBody, SAMPLES } from './workspace';

@unmanaged
class Field {
  x: f64;
  y: f64;
  z: f64;
}

// The result of the last sum.
const field = changetype<Field>(memory.data(offsetof<Field>(), 8));

// Sums over a tile round less than one long sum.
const TILE: i32 = 1024;

// @ts-ignore: decorator
@inline function sumField(w: NBody, px: real, py: real, pz: real, inverseSquare: bool): void {
  const soft = splat(<real>w.softening2);
  const x = splat(px);
  const y = splat(py);
  const z = splat(pz);
  let sumX: f64 = 0;
  let sumY: f64 = 0;
  let sumZ: f64 = 0;
  for (let tile = 0; tile < w.tests; tile += TILE) {
    const end = min(tile + TILE, w.tests);
    let ax = splat(0);
    let ay = splat(0);
    let az = splat(0);
    for (let j = tile; j < end; j += LANES) {
      const dx = sub(v128.load(w.x + at(j)), x);
      const dy = sub(v128.load(w.y + at(j)), y);
      const dz = sub(v128.load(w.z + at(j)), z);
      const u = add(add(mul(dx, dx), mul(dy, dy)), add(mul(dz, dz), soft));
      const k = scaledStrength(v128.load(w.s + at(j)), u, inverseSquare);
      ax = add(ax, mul(dx, k));
      ay = add(ay, mul(dy, k));
      az = add(az, mul(dz, k));
    }
    sumX += <f64>laneSum(ax);
    sumY += <f64>laneSum(ay);
    sumZ += <f64>laneSum(az);
  }
  field.x = sumX;
  field.y = sumY;
  field.z = sumZ;
}

// Computes the acceleration, in units of strength over length^power, at a point given in units of length.
export function fieldAt(w: NBody, x: real, y: real, z: real, inverseSquare: bool): void {
  if (inverseSquare) sumField(w, x, y, z, true);
  else sumField(w, x, y, z, false);
}

// Computes the accelerations of the test particles directly.
export function directOntoTests(w: NBody, inverseSquare: bool): void {
  for (let slot = w.tests; slot < w.end; slot++) {
    fieldAt(w, get(w.x, slot), get(w.y, slot), get(w.z, slot), inverseSquare);
    put(w.ax, slot, <real>field.x);
    put(w.ay, slot, <real>field.y);
    put(w.az, slot, <real>field.z);
  }
}

// The error of a body in a weak field is taken relative to at least this fraction of the median field.
const MIN_FIELD_FRACTION: f64 = 0.1;

// Golden-ratio sequence in units of 2⁻³²: successive samples select different bodies and are evenly spread.
const GOLDEN_SHIFT: u32 = 0x9e3779b9;

// Returns the RMS relative error at `samples` bodies, evenly spread over the results, against the direct sum. It
// measures the error of the tree, or the rounding of the direct sum. Each `choice` selects other bodies.
export function sampleError(w: NBody, samples: i32, choice: i32, inverseSquare: bool): f64 {
  const n = min(min(samples, SAMPLES), w.bodies);
  if (n == 0) return 0;
  // Offset of the sample within its interval, in units of 2⁻³²; choice 0 takes the middle.
  const offset = <u64>(<u32>(1 << 31) + <u32>choice * GOLDEN_SHIFT);
  for (let k = 0; k < n; k++) {
    const body = <i32>((((((<u64>k) << 32) + offset) / <u64>n) * <u64>w.bodies) >> 32);
    const position = w.resultsByTree || body < w.sources ? body : body - w.sources + w.tests;
    if (w.resultsByTree) fieldAt(w, get(w.px, position), get(w.py, position), get(w.pz, position), inverseSquare);
    else fieldAt(w, get(w.x, position), get(w.y, position), get(w.z, position), inverseSquare);
    // The direct sum stores forces where the tree stores accelerations.
    const scale = w.resultsByTree || position >= w.sources ? 1 : 1 / <f64>get(w.s, position);
    const dx = <f64>get(w.ax, position) * scale - field.x;
    const dy = <f64>get(w.ay, position) * scale - field.y;
    const dz = <f64>get(w.az, position) * scale - field.z;
    const at = w.sample + ((<usize>k) << 4);
    store<f64>(at, dx * dx + dy * dy + dz * dz);
    store<real>(at, <real>sqrt<f64>(field.x * field.x + field.y * field.y + field.z * field.z), 8);
  }
  const minField = MIN_FIELD_FRACTION * approximateMedian(w.counts, w.sample + 8, 16, n);
  if (minField == 0) return 0;
  let sum: f64 = 0;
  for (let k = 0; k < n; k++) {
    const at = w.sample + ((<usize>k) << 4);
    const magnitude = max<f64>(minField, <f64>load<real>(at, 8));
    sum += load<f64>(at) / (magnitude * magnitude);
  }
  return sqrt<f64>(sum / <f64>n);
}
