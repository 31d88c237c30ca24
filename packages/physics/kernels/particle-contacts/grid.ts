// The uniform grid of the broad phase: it chooses the cell size and assigns each body to a bucket.
//
// A cell is as wide as the largest diameter, so that touching bodies lie in the same or in adjacent cells. Bodies much
// larger than the rest would overfill every cell: they stay out of the grid and are tested against all bodies, if they are
// 16 at most, or if that takes fewer tests.
// Cells map to a power-of-two table of buckets: cell (i, j, k) is bucket (i + stride j + layer k) mod size. Neighbours
// in x are therefore adjacent in memory, the extent of the scene costs no memory, and distant cells that share a bucket
// only cost extra tests. `stride` and `layer` keep the buckets of the 9 (27) adjacent cells distinct, so that no pair
// is found twice. Source: Green, "Particle Simulation using CUDA" (2010).
import { Columns, get } from '../memory/columns';
import { LANES, at, larger, smaller, splat } from '../memory/lanes';
import { ContactTable, CONTACT_MARGIN, putWord, word } from './table';

const MAX_LARGE_BODIES: i32 = 16;
const BINS: i32 = 256;
const MIN_BUCKETS: i32 = 1024;

// The square of a larger radius could overflow.
const MAX_RADIUS: real = 1e13;

// Results of `measure` over all bodies with a collider: how many there are, their radii, and the extents of the scene.
let count: i32 = 0;
let minRadius: real = 0;
let maxRadius: real = 0;
let width: f64 = 0;
let height: f64 = 0;

// Cells per metre.
let cellsPerMetre: f64 = 0;
// Bodies with a larger radius (m) stay out of the grid.
let maxGridRadius: real = 0;

// A row is a body with a collider if its radius is valid and it has Position, the first component, whose bit is 1.
// @ts-ignore: decorator
@inline function hasCollider(c: Columns, row: i32): bool {
  const radius = get(c.radius, row);
  return radius > 0 && radius <= MAX_RADIUS && (word(c.members, row) & 1) != 0;
}

// Counts the bodies, and finds the smallest and largest radius and the extents of the scene. Rows without a collider have
// radius zero, as have the unused particles of emitters.
function measure(c: Columns, rows: i32): void {
  const infinite = splat(<real>Infinity);
  let smallest = infinite;
  let largest = splat(0);
  let lowX = infinite;
  let lowY = infinite;
  let highX = v128.neg<real>(infinite);
  let highY = highX;
  let counts = i32x4.splat(0);
  for (let row = 0; row < rows; row += LANES) {
    const radius = v128.load(c.radius + at(row));
    const x = v128.load(c.positionX + at(row));
    const y = v128.load(c.positionY + at(row));
    const round = v128.and(v128.gt<real>(radius, splat(0)), v128.le<real>(radius, splat(MAX_RADIUS)));
    // Every lane of the mask is -1, in f64 of both its halves.
    counts = i32x4.sub(counts, round);
    smallest = smaller(smallest, v128.bitselect(radius, smallest, round));
    largest = larger(largest, v128.and(radius, round));
    lowX = smaller(lowX, v128.bitselect(x, lowX, round));
    lowY = smaller(lowY, v128.bitselect(y, lowY, round));
    highX = larger(highX, v128.bitselect(x, highX, round));
    highY = larger(highY, v128.bitselect(y, highY, round));
  }
  count = i32x4.extract_lane(counts, 0) + i32x4.extract_lane(counts, 2);
  if (sizeof<real>() == 4) count += i32x4.extract_lane(counts, 1) + i32x4.extract_lane(counts, 3);
  minRadius = minLane(smallest);
  maxRadius = -minLane(v128.neg<real>(largest));
  width = -(<f64>minLane(v128.neg<real>(highX))) - <f64>minLane(lowX);
  height = -(<f64>minLane(v128.neg<real>(highY))) - <f64>minLane(lowY);
}

// @ts-ignore: decorator
@inline function minLane(v: v128): real {
  let minRadius = min<real>(v128.extract_lane<real>(v, 0), v128.extract_lane<real>(v, 1));
  if (sizeof<real>() == 4) {
    minRadius = min<real>(minRadius, <real>min<f32>(f32x4.extract_lane(v, 2), f32x4.extract_lane(v, 3)));
  }
  return minRadius;
}

// The histogram bin of a radius is its binary exponent.
// @ts-ignore: decorator
@inline function binOf(radius: real): i32 {
  return (reinterpret<i32>(<f32>radius) >> 23) & 255;
}

// Returns the largest radius that the grid accepts: the largest of all bodies, or of all except those in the highest bins.
function limitRadius(c: Columns, t: ContactTable, rows: i32, dimensions: i32): real {
  if (maxRadius <= <real>2 * minRadius) return maxRadius;
  memory.fill(t.histogram, 0, BINS << 2);
  for (let row = 0; row < rows; row++) {
    if (!hasCollider(c, row)) continue;
    const bin = binOf(get(c.radius, row));
    putWord(t.histogram, bin, word(t.histogram, bin) + 1);
  }
  const bin = highestBin(t, dimensions == 2 ? 0 : depthOf(c, rows));
  let largest: real = 0;
  for (let row = 0; row < rows; row++) {
    const radius = get(c.radius, row);
    if (hasCollider(c, row) && binOf(radius) <= bin) largest = max<real>(largest, radius);
  }
  return largest;
}

// Returns the extent of the scene in z.
function depthOf(c: Columns, rows: i32): f64 {
  let low: real = Infinity;
  let high: real = -Infinity;
  for (let row = 0; row < rows; row++) {
    if (!hasCollider(c, row)) continue;
    low = min<real>(low, get(c.positionZ, row));
    high = max<real>(high, get(c.positionZ, row));
  }
  return <f64>high - <f64>low;
}

// Returns the highest bin whose bodies are in the grid, for which a search takes the fewest tests. `depth` is the extent of
// the scene in z, 0 in two dimensions.
function highestBin(t: ContactTable, depth: f64): i32 {
  let above = 0;
  let bin = BINS - 1;
  while (bin > 0 && above + word(t.histogram, bin) <= MAX_LARGE_BODIES) above += word(t.histogram, bin--);
  let best = bin;
  let least = countTests(bin, above, depth);
  while (bin > 0) {
    above += word(t.histogram, bin--);
    if (<f64>above * <f64>count >= least) break;
    const tests = countTests(bin, above, depth);
    if (tests >= least) continue;
    least = tests;
    best = bin;
  }
  return best;
}

// The tests of a search with the bodies up to a bin in the grid, evenly spread, and those above it out of it.
function countTests(bin: i32, above: i32, depth: f64): f64 {
  // Twice the radius at the upper end of the bin.
  const cell = <f64>reinterpret<f32>((bin + 2) << 23);
  const inGrid = <f64>(count - above);
  // Half of the adjacent cells.
  let fraction = (4.5 * (cell / max<f64>(width, cell)) * cell) / max<f64>(height, cell);
  if (depth > 0) fraction *= (3 * cell) / max<f64>(depth, cell);
  return <f64>above * <f64>count + inGrid * inGrid * min<f64>(fraction, 1);
}

// Chooses cell size and bucket count for the bodies in rows [0, rows), in 2 or 3 `dimensions`.
export function chooseGrid(c: Columns, t: ContactTable, rows: i32, dimensions: i32): void {
  measure(c, rows);
  maxGridRadius = maxRadius > 0 ? limitRadius(c, t, rows, dimensions) : <real>0;
  // The small margin prevents rounding from placing two touching bodies two cells apart.
  const cell = <f64>maxGridRadius * 2 * <f64>CONTACT_MARGIN * (1 + 1e-9);
  cellsPerMetre = cell > 0 ? 1 / cell : 0;
  let buckets = MIN_BUCKETS;
  let bits = 10;
  while (buckets < 2 * count && buckets < t.maxBuckets) {
    buckets <<= 1;
    bits++;
  }
  t.buckets = buckets;
  const quarter = <f64>(buckets >> 2);
  const columns = floor<f64>(width * cellsPerMetre) + 3;
  const layers = columns * (floor<f64>(height * cellsPerMetre) + 3);
  if (dimensions == 2) {
    t.stride = columns <= quarter ? <i32>columns : (1 << (bits >> 1)) + 1;
    t.layer = 0;
    return;
  }
  t.stride = layers <= quarter ? <i32>columns : (1 << (bits / 3)) + 1;
  t.layer = layers <= quarter ? <i32>layers : (1 << ((2 * bits) / 3)) + 1;
}

// Converts coordinates to cell indices, as i32 in the low lanes. The computation is in f64, so that adjacent cells stay
// adjacent far from the origin. Adding 1.5 * 2^52 leaves an integer in the low bits of the mantissa; it wraps beyond
// 2^31 cells.
// @ts-ignore: decorator
@inline function cellsOf(x: v128): v128 {
  const magic = f64x2.splat(6755399441055744);
  const low = sizeof<real>() == 4 ? f64x2.promote_low_f32x4(x) : x;
  const a = f64x2.add(f64x2.floor(f64x2.mul(low, f64x2.splat(cellsPerMetre))), magic);
  if (sizeof<real>() == 8) return i32x4.shuffle(a, a, 0, 2, 0, 2);
  const high = f64x2.promote_low_f32x4(i32x4.shuffle(x, x, 2, 3, 2, 3));
  const b = f64x2.add(f64x2.floor(f64x2.mul(high, f64x2.splat(cellsPerMetre))), magic);
  return i32x4.shuffle(a, b, 0, 2, 4, 6);
}

// Returns the buckets of bodies at (x, y); `addLayer` extends them to (x, y, z).
// @ts-ignore: decorator
@inline function bucketsOf(t: ContactTable, x: v128, y: v128): v128 {
  return v128.and(i32x4.add(cellsOf(x), i32x4.mul(cellsOf(y), i32x4.splat(t.stride))), i32x4.splat(t.buckets - 1));
}

// @ts-ignore: decorator
@inline function addLayer(t: ContactTable, buckets: v128, z: v128): v128 {
  return v128.and(i32x4.add(buckets, i32x4.mul(cellsOf(z), i32x4.splat(t.layer))), i32x4.splat(t.buckets - 1));
}

// Stores one 32-bit word for each lane.
// @ts-ignore: decorator
@inline function storeWords(to: usize, words: v128): void {
  if (sizeof<real>() == 4) v128.store(to, words);
  else v128.store_lane<i64>(to, words, 0);
}

// Stores the bucket of each row in `rowWords`: -1 for a row without a collider, -2 for a body too large for the grid.
function findBuckets(c: Columns, t: ContactTable, rows: i32): void {
  const one = i32x4.splat(1);
  const none = i32x4.splat(-1);
  for (let row = 0; row < rows; row += LANES) {
    const radius = v128.load(c.radius + at(row));
    let round = v128.and(v128.gt<real>(radius, splat(0)), v128.le<real>(radius, splat(MAX_RADIUS)));
    const words = t.rowWords + ((<usize>row) << 2);
    if (!v128.any_true(round)) {
      storeWords(words, none);
      continue;
    }
    let bucket = bucketsOf(t, v128.load(c.positionX + at(row)), v128.load(c.positionY + at(row)));
    if (t.layer != 0) bucket = addLayer(t, bucket, v128.load(c.positionZ + at(row)));
    let small = v128.le<real>(radius, splat(maxGridRadius));
    if (sizeof<real>() == 8) {
      round = i32x4.shuffle(round, round, 0, 2, 0, 2);
      small = i32x4.shuffle(small, small, 0, 2, 0, 2);
    }
    const members = v128.load(c.members + ((<usize>row) << 2));
    round = v128.and(round, i32x4.eq(v128.and(members, one), one));
    storeWords(words, v128.bitselect(v128.bitselect(bucket, i32x4.splat(-2), small), none, round));
  }
}

// Counts the bodies of each bucket and stores the start of each bucket in starts[bucket + 1]. Placing the bodies
// advances this entry to the end of the bucket.
export function countBuckets(c: Columns, t: ContactTable, rows: i32): void {
  findBuckets(c, t, rows);
  const starts = t.starts;
  memory.fill(starts, 0, (<usize>(t.buckets + 2)) << 2);
  t.largeCount = 0;
  for (let row = 0; row < rows; row++) {
    const bucket = word(t.rowWords, row);
    if (bucket >= 0) putWord(starts, bucket + 1, word(starts, bucket + 1) + 1);
    else if (bucket == -2) t.largeCount++;
  }
  const end = starts + ((<usize>t.buckets) << 2);
  let sum = 0;
  for (let p = starts; p <= end; p += 4) {
    const size = load<i32>(p);
    store<i32>(p, sum);
    sum += size;
  }
  t.gridCount = sum;
}
