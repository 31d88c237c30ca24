// Which pieces of the memory hold anything: what a snapshot copies. Most of a world's memory was never written.

// The first piece of `bytes` in [from, to) that holds something other than zeros (`used` 1), or nothing else (`used` 0);
// `to` when there is none. Addresses and `bytes` are multiples of 64.
export function nextPiece(from: usize, to: usize, bytes: usize, used: i32): usize {
  for (let at = from; at < to; at += bytes) {
    if (<i32>holdsAnything(at, at + bytes) == used) return at;
  }
  return to;
}

function holdsAnything(from: usize, to: usize): bool {
  for (let at = from; at < to; at += 64) {
    const first = v128.or(v128.load(at), v128.load(at, 16));
    const second = v128.or(v128.load(at, 32), v128.load(at, 48));
    if (v128.any_true(v128.or(first, second))) return true;
  }
  return false;
}
