// Finds the non-zero pages of the memory, which a snapshot copies. Most of a world's memory was never written.

// Returns the first page of `bytes` in [from, to) that has a non-zero byte (`used` 1) or only zeros (`used` 0), or `to`
// if there is none. Addresses and `bytes` are multiples of 64.
export function findPage(from: usize, to: usize, bytes: usize, used: i32): usize {
  for (let at = from; at < to; at += bytes) {
    if (<i32>hasNonZero(at, at + bytes) == used) return at;
  }
  return to;
}

function hasNonZero(from: usize, to: usize): bool {
  for (let at = from; at < to; at += 64) {
    const first = v128.or(v128.load(at), v128.load(at, 16));
    const second = v128.or(v128.load(at, 32), v128.load(at, 48));
    if (v128.any_true(v128.or(first, second))) return true;
  }
  return false;
}
