// Clears a record of a known size, a multiple of 16 bytes. Engines call a function for `memory.fill`, which takes longer than so
// few stores.

// @ts-ignore: decorator
@inline export function clearRecord(record: usize, bytes: usize): void {
  for (let p = record; p < record + bytes; p += 16) v128.store(p, i32x4.splat(0));
}
