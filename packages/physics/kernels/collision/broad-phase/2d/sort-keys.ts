// Sorts `count` keys of u64 by one digit after the other, least significant first; `spare` is a buffer of the same size. A pass
// keeps the order of what has the same digit. Digits that are zero in all keys take none: ids are small.
//
// Source: Knuth, The Art of Computer Programming, volume 3, section 5.2.5 (radix sort).
const DIGIT_BITS: u64 = 7;
const BUCKETS: i32 = 128;

// Of each digit: how many keys have it, then where the next of them goes.
const buckets = memory.data(4 * BUCKETS, 4);

export function sortKeys(keys: usize, spare: usize, count: i32): void {
  let used: u64 = 0;
  for (let i = 0; i < count; i++) used |= keyAt(keys, i);
  let from = keys;
  let to = spare;
  for (let shift: u64 = 0; shift < 64; shift += DIGIT_BITS) {
    if (((used >> shift) & (BUCKETS - 1)) == 0) continue;
    distribute(from, to, count, shift);
    const swapped = from;
    from = to;
    to = swapped;
  }
  if (from != keys) memory.copy(keys, from, (<usize>count) << 3);
}

function distribute(from: usize, to: usize, count: i32, shift: u64): void {
  memory.fill(buckets, 0, 4 * BUCKETS);
  for (let i = 0; i < count; i++) {
    const bucket = bucketOf(keyAt(from, i), shift);
    store<i32>(bucket, load<i32>(bucket) + 1);
  }
  let next = 0;
  for (let bucket = buckets; bucket < buckets + 4 * BUCKETS; bucket += 4) {
    const size = load<i32>(bucket);
    store<i32>(bucket, next);
    next += size;
  }
  for (let i = 0; i < count; i++) {
    const key = keyAt(from, i);
    const bucket = bucketOf(key, shift);
    const place = load<i32>(bucket);
    store<u64>(to + ((<usize>place) << 3), key);
    store<i32>(bucket, place + 1);
  }
}

// @ts-ignore: decorator
@inline function bucketOf(key: u64, shift: u64): usize {
  return buckets + ((<usize>(key >> shift) & (BUCKETS - 1)) << 2);
}

// @ts-ignore: decorator
@inline export function keyAt(keys: usize, i: i32): u64 {
  return load<u64>(keys + ((<usize>i) << 3));
}

// @ts-ignore: decorator
@inline export function putKey(keys: usize, i: i32, key: u64): void {
  store<u64>(keys + ((<usize>i) << 3), key);
}
