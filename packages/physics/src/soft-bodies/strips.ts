// Finds quad strips among triangles, whose two triangles per quad the wind kernel handles together.

/** The minimum number of quads of a strip. */
const MIN_QUADS = 8;

/** The number of rows behind a strip's last nodes that the kernel writes back unchanged. */
const ROWS_BEHIND = 3;

/**
 * Splits a list of triangles into quad strips and others, as kernels/soft-bodies/wind.ts reads it: for each section its
 * first triangle and 1 if it is a strip (kernels/soft-bodies/strips.ts), else 0; then the number of triangles. `rows`
 * is the length of a column.
 */
export function listStrips(ids: ArrayLike<number>, rows: number): number[] {
  const sections: number[] = [];
  const count = ids.length / 3;
  let openSection = -1;
  for (let first = 0; first < count; ) {
    const quads = countQuads(ids, first, rows);
    if (quads >= MIN_QUADS) sections.push(first, 1);
    else if (openSection < 0) sections.push(first, 0);
    openSection = quads >= MIN_QUADS ? -1 : first;
    first += quads >= MIN_QUADS ? 2 * quads : 1;
  }
  return [...sections, count];
}

/** Returns the number of quads of the strip that starts with triangle `first`; 0 if there is no strip. */
function countQuads(ids: ArrayLike<number>, first: number, rows: number): number {
  const isTriangle = (triangle: number, a: number, b: number, c: number) =>
    ids[3 * triangle] === a && ids[3 * triangle + 1] === b && ids[3 * triangle + 2] === c;
  const [top, bottom] = [ids[3 * first], ids[3 * first + 1]];
  let quads = 0;
  while (isTriangle(first + quads, top + quads, bottom + quads, top + quads + 1)) quads++;
  if (Math.max(top, bottom) + quads + ROWS_BEHIND >= rows) return 0;
  for (let i = 0; i < quads; i++) {
    if (!isTriangle(first + quads + i, top + i + 1, bottom + i, bottom + i + 1)) return 0;
  }
  return quads;
}
