import { type Gas, REACH } from './state';

/** The pairs closer than REACH times the sum of their radii, by ascending (a, b). */
export function findPairs(gas: Gas): void {
  const stride = fill(gas);
  scan(gas, stride);
  sort(gas);
}

/** Sorts the bodies into buckets, and returns the distance in buckets between neighbours in y. */
function fill(gas: Gas): number {
  const { count, x, y, radius, bits, buckets, bucketOf, starts, packed, packedBody } = gas;
  let most = 0;
  let minX = Infinity;
  let maxX = -Infinity;
  for (let i = 0; i < count; i++) {
    if (radius[i] > most) most = radius[i];
    if (x[i] < minX) minX = x[i];
    if (x[i] > maxX) maxX = x[i];
  }
  const rate = 1 / (most * 2 * REACH * (1 + 1e-9));
  const width = Math.floor((maxX - minX) * rate) + 3;
  const stride = width <= buckets >> 2 ? width : (1 << (bits >> 1)) + 1;
  const mask = buckets - 1;
  starts.fill(0);
  for (let i = 0; i < count; i++) {
    const bucket = (Math.floor(x[i] * rate) + stride * Math.floor(y[i] * rate)) & mask;
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
    packed[3 * place] = x[i];
    packed[3 * place + 1] = y[i];
    packed[3 * place + 2] = radius[i];
    packedBody[place] = i;
  }
  return stride;
}

function scan(gas: Gas, stride: number): void {
  const { buckets, starts } = gas;
  const mask = buckets - 1;
  gas.contacts = 0;
  for (let bucket = 0; bucket <= mask; bucket++) {
    const first = starts[bucket];
    const last = starts[bucket + 1];
    if (first === last) continue;
    const above = (bucket + stride - 1) & mask;
    const whole = bucket + 2 <= mask && above + 2 <= mask;
    for (let i = first; i < last; i++) {
      if (whole) {
        test(gas, i, i + 1, starts[bucket + 2]);
        test(gas, i, starts[above], starts[above + 3]);
        continue;
      }
      test(gas, i, i + 1, last);
      for (const next of [bucket + 1, bucket + stride - 1, bucket + stride, bucket + stride + 1]) {
        test(gas, i, starts[next & mask], starts[(next & mask) + 1]);
      }
    }
  }
}

function test(gas: Gas, i: number, first: number, last: number): void {
  const { packed, packedBody, rawA, rawB } = gas;
  const x = packed[3 * i];
  const y = packed[3 * i + 1];
  const radius = packed[3 * i + 2];
  for (let j = first; j < last; j++) {
    const dx = packed[3 * j] - x;
    const dy = packed[3 * j + 1] - y;
    const reach = (packed[3 * j + 2] + radius) * REACH;
    if (dx * dx + dy * dy < reach * reach) {
      const p = packedBody[i];
      const q = packedBody[j];
      rawA[gas.contacts] = p < q ? p : q;
      rawB[gas.contacts++] = p < q ? q : p;
    }
  }
}

/** Counting sort by a, then insertion by b within the few of each a. */
function sort({ count, contacts, rawA, rawB, cursor, a, b }: Gas): void {
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
