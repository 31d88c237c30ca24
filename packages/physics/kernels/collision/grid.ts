// The uniform grid of the broad phase: how large its cells are, and its bodies in the order of their cells.
//
// A cell is as wide as the largest diameter, so that bodies that touch lie in the same or in neighbouring cells. A few
// bodies much larger than the rest would make every cell a crowd: at most 16 of them stay out of the grid and are tested
// against everything. Cells are kept in a table of buckets, a power of two long: cell (i, j, k) is bucket
// i + stride j + layer k, wrapped round. Neighbours in x are therefore neighbours in memory, no extent of the scene
// costs memory, and far cells that share a bucket cost a few tests. `stride` and `layer` keep the buckets of the 9 (27)
// neighbouring cells apart, so that no pair is found twice. After Green, "Particle Simulation using CUDA" (2010).
import { Columns, get } from '../columns';
import { ContactTable, REACH, putWord, word } from './table';

const MOST_LARGE: i32 = 16;
const BINS: i32 = 256;
const LEAST_BUCKETS: i32 = 1024;

let minX: f64 = 0;
let minY: f64 = 0;
let maxX: f64 = 0;
let maxY: f64 = 0;
let leastRadius: real = 0;
let mostRadius: real = 0;

// Cells per metre.
export let cellRate: f64 = 0;
// Bodies with a larger radius stay out of the grid.
export let gridRadius: real = 0;

// A radius the grid can work with: positive, and not so large that its square overflows.
// @ts-ignore: decorator
@inline export function isRound(radius: real): bool {
  return radius > 0 && radius <= <real>1e13;
}

// A coordinate in cells. In f64 so that neighbouring cells stay neighbours far from the origin; wraps round beyond 2^31.
// @ts-ignore: decorator
@inline export function cellOf(x: real): i32 {
  return <i32>(<i64>floor<f64>(<f64>x * cellRate));
}

function measure(c: Columns, ids: usize, count: i32): void {
  let least = <real>Infinity;
  let most: real = 0;
  minX = minY = Infinity;
  maxX = maxY = -Infinity;
  for (let i = 0; i < count; i++) {
    const row = word(ids, i);
    const radius = get(c.radius, row);
    if (!isRound(radius)) continue;
    least = min<real>(least, radius);
    most = max<real>(most, radius);
    const x = <f64>get(c.positionX, row);
    const y = <f64>get(c.positionY, row);
    minX = min<f64>(minX, x);
    minY = min<f64>(minY, y);
    maxX = max<f64>(maxX, x);
    maxY = max<f64>(maxY, y);
  }
  leastRadius = least;
  mostRadius = most;
}

// Bin of a radius: its binary exponent.
// @ts-ignore: decorator
@inline function binOf(radius: real): i32 {
  return (reinterpret<i32>(<f32>radius) >> 23) & 255;
}

// The largest radius that belongs into the grid: of all bodies, or of all but the few of the highest bins.
function limitRadius(c: Columns, t: ContactTable, ids: usize, count: i32): real {
  if (mostRadius <= <real>2 * leastRadius) return mostRadius;
  memory.fill(t.histogram, 0, BINS << 2);
  for (let i = 0; i < count; i++) {
    const radius = get(c.radius, word(ids, i));
    if (isRound(radius)) putWord(t.histogram, binOf(radius), word(t.histogram, binOf(radius)) + 1);
  }
  let above = 0;
  let bin = BINS - 1;
  while (bin > 0 && above + word(t.histogram, bin) <= MOST_LARGE) above += word(t.histogram, bin--);
  let limit: real = 0;
  for (let i = 0; i < count; i++) {
    const radius = get(c.radius, word(ids, i));
    if (isRound(radius) && binOf(radius) <= bin) limit = max<real>(limit, radius);
  }
  return limit;
}

// Chooses cells and buckets for the bodies `ids`, in `dimensions` 2 or 3.
export function chooseGrid(c: Columns, t: ContactTable, ids: usize, count: i32, dimensions: i32): void {
  measure(c, ids, count);
  gridRadius = mostRadius > 0 ? limitRadius(c, t, ids, count) : <real>0;
  // A hair wider, so that rounding cannot put two that touch two cells apart.
  const cell = <f64>gridRadius * 2 * <f64>REACH * (1 + 1e-9);
  cellRate = cell > 0 ? 1 / cell : 0;
  let buckets = LEAST_BUCKETS;
  let bits = 10;
  while (buckets < 2 * count && buckets < t.maxBuckets) {
    buckets <<= 1;
    bits++;
  }
  t.buckets = buckets;
  const quarter = <f64>(buckets >> 2);
  const width = floor<f64>((maxX - minX) * cellRate) + 3;
  const height = floor<f64>((maxY - minY) * cellRate) + 3;
  if (dimensions == 2) {
    t.stride = width <= quarter ? <i32>width : (1 << (bits >> 1)) + 1;
    t.layer = 0;
    return;
  }
  const fits = width * height <= quarter;
  t.stride = fits ? <i32>width : (1 << (bits / 3)) + 1;
  t.layer = fits ? <i32>(width * height) : (1 << ((2 * bits) / 3)) + 1;
}

// Turns the numbers of bodies per bucket in starts[1 …] into where each bucket begins.
export function sumStarts(t: ContactTable): void {
  const end = t.starts + ((<usize>t.buckets) << 2);
  let sum = 0;
  for (let p = t.starts; p <= end; p += 4) {
    const size = load<i32>(p);
    store<i32>(p, sum);
    sum += size;
  }
  t.gridCount = sum;
}
