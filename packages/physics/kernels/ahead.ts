// Reading ahead: a step that runs tile by tile comes to rows that lie in memory, not in the cache, at every tile. A loop
// that waits for divisions anyway has time to fetch the next tile's rows meanwhile. There is no instruction for it: a
// load whose value nobody looks at does the same.
//
// src/schedule/ahead.ts writes the table: how many bytes further the next tile's rows are, how many columns to read
// there (0: nothing lies ahead), and where those columns start.
// Addresses 64 on hold the columns (columns.ts), 512 on the bodies of a wall (collision/body.ts).
const TABLE: usize = 256;

// @ts-ignore: decorator
@inline export function aheadBytes(): usize {
  return load<usize>(TABLE);
}

// @ts-ignore: decorator
@inline export function aheadCount(): u32 {
  return load<u32>(TABLE, 4);
}

// Reads one cache line of each column, `offset` bytes from its start.
// @ts-ignore: decorator
@inline export function readAhead(count: u32, offset: usize): void {
  for (let k: u32 = 0; k < count; k++) load<u32>(load<usize>(TABLE + ((<usize>k) << 2), 8) + offset);
}
