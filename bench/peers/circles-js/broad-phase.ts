import { type Balls, REACH } from './state.ts';

/** The pairs closer than REACH times the sum of their radii, by ascending (a, b). */
export function findPairs(balls: Balls): void {
  const { stride, layer } = fill(balls);
  scan(balls, stride, layer);
  sort(balls);
}

/** Sorts the bodies into buckets, and returns the distances in buckets between neighbours in y and in z. */
function fill(balls: Balls): { stride: number; layer: number } {
  const { count, flat, x, y, z, radius, buckets, bucketOf, starts, packed, packedBody } = balls;
  let most = 0;
  let minX = Infinity;
  let maxX = -Infinity;
  let minY = Infinity;
  let maxY = -Infinity;
  for (let i = 0; i < count; i++) {
    if (radius[i] > most) most = radius[i];
    if (x[i] < minX) minX = x[i];
    if (x[i] > maxX) maxX = x[i];
    if (y[i] < minY) minY = y[i];
    if (y[i] > maxY) maxY = y[i];
  }
  const rate = 1 / (most * 2 * REACH * (1 + 1e-9));
  const width = Math.floor((maxX - minX) * rate) + 3;
  const area = width * (Math.floor((maxY - minY) * rate) + 3);
  const strides = stridesOf(balls, width, area);
  const { stride, layer } = strides;
  const mask = buckets - 1;
  starts.fill(0);
  for (let i = 0; i < count; i++) {
    let bucket = Math.floor(x[i] * rate) + stride * Math.floor(y[i] * rate);
    if (!flat) bucket += layer * Math.floor(z[i] * rate);
    bucket &= mask;
    bucketOf[i] = bucket;
    starts[bucket + 1]++;
  }
  let sum = 0;
  for (let k = 0; k <= buckets; k++) {
    const size = starts[k];
    starts[k] = sum;
    sum += size;
  }
  for (let i = 0; i < count; i++) {
    const place = starts[bucketOf[i] + 1]++;
    packed[4 * place] = x[i];
    packed[4 * place + 1] = y[i];
    packed[4 * place + 2] = flat ? 0 : z[i];
    packed[4 * place + 3] = radius[i];
    packedBody[place] = i;
  }
  return strides;
}

function stridesOf({ flat, buckets, bits }: Balls, width: number, area: number): { stride: number; layer: number } {
  const quarter = buckets >> 2;
  if (flat) return { stride: width <= quarter ? width : (1 << (bits >> 1)) + 1, layer: 0 };
  if (area <= quarter) return { stride: width, layer: area };
  return { stride: (1 << Math.floor(bits / 3)) + 1, layer: (1 << Math.floor((2 * bits) / 3)) + 1 };
}

/** Each body against those after it in its cell and the next, and against rows of three cells: one in 2D, four in 3D. */
function scan(balls: Balls, stride: number, layer: number): void {
  const { flat, buckets, starts } = balls;
  const mask = buckets - 1;
  balls.contacts = 0;
  for (let bucket = 0; bucket <= mask; bucket++) {
    const first = starts[bucket];
    const last = starts[bucket + 1];
    for (let i = first; i < last; i++) {
      test(balls, i, i + 1, starts[Math.min(bucket + 2, buckets)]);
      if (bucket === mask) test(balls, i, 0, starts[1]);
      testRow(balls, i, bucket + stride - 1);
      if (flat) continue;
      testRow(balls, i, bucket + layer - stride - 1);
      testRow(balls, i, bucket + layer - 1);
      testRow(balls, i, bucket + layer + stride - 1);
    }
  }
}

/** The three cells from `bucket`, wrapped round where the table of buckets ends. */
function testRow(balls: Balls, i: number, bucket: number): void {
  const { starts, buckets } = balls;
  const first = bucket & (buckets - 1);
  const end = first + 3;
  if (end <= buckets) {
    test(balls, i, starts[first], starts[end]);
    return;
  }
  test(balls, i, starts[first], starts[buckets]);
  test(balls, i, 0, starts[end - buckets]);
}

function test(balls: Balls, i: number, first: number, last: number): void {
  const { packed, packedBody, rawA, rawB, flat } = balls;
  const x = packed[4 * i];
  const y = packed[4 * i + 1];
  const z = packed[4 * i + 2];
  const radius = packed[4 * i + 3];
  for (let j = first; j < last; j++) {
    const dx = packed[4 * j] - x;
    const dy = packed[4 * j + 1] - y;
    const dz = flat ? 0 : packed[4 * j + 2] - z;
    const reach = (packed[4 * j + 3] + radius) * REACH;
    if (dx * dx + dy * dy + dz * dz < reach * reach) {
      const p = packedBody[i];
      const q = packedBody[j];
      rawA[balls.contacts] = p < q ? p : q;
      rawB[balls.contacts++] = p < q ? q : p;
    }
  }
}

/** Counting sort by a, then insertion by b within the few of each a. */
function sort({ count, contacts, rawA, rawB, cursor, a, b }: Balls): void {
  cursor.fill(0);
  for (let k = 0; k < contacts; k++) cursor[rawA[k]]++;
  let sum = 0;
  for (let i = 0; i < count; i++) {
    const size = cursor[i];
    cursor[i] = sum;
    sum += size;
  }
  a.fill(-1, 0, contacts);
  for (let k = 0; k < contacts; k++) {
    let place = cursor[rawA[k]]++;
    a[place] = rawA[k];
    while (place > 0 && a[place - 1] === rawA[k] && b[place - 1] > rawB[k]) {
      b[place] = b[place - 1];
      place--;
    }
    b[place] = rawB[k];
  }
}
