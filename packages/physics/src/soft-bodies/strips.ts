// Strips of meshes among triangles, for the kernel that looks at both triangles of a mesh together.

/** Fewer meshes are not worth it. */
const SHORTEST = 8;

/** Rows behind its last nodes that the kernel writes back as they were. */
const BEHIND = 3;

/**
 * The parts of a list of triangles, as kernels/soft-bodies/wind.ts reads them: for each its first triangle and 1 where it
 * is a strip, which kernels/soft-bodies/strips.ts describes, else 0; then the number of triangles. `rows`: of a column.
 */
export function partsOf(ids: ArrayLike<number>, rows: number): number[] {
  const parts: number[] = [];
  const count = ids.length / 3;
  let loose = -1;
  for (let first = 0; first < count; ) {
    const meshes = meshesFrom(ids, first, rows);
    if (meshes >= SHORTEST) parts.push(first, 1);
    else if (loose < 0) parts.push(first, 0);
    loose = meshes >= SHORTEST ? -1 : first;
    first += meshes >= SHORTEST ? 2 * meshes : 1;
  }
  return [...parts, count];
}

/** How many meshes the strip has that begins with this triangle; 0 when none does. */
function meshesFrom(ids: ArrayLike<number>, first: number, rows: number): number {
  const isAt = (triangle: number, a: number, b: number, c: number) =>
    ids[3 * triangle] === a && ids[3 * triangle + 1] === b && ids[3 * triangle + 2] === c;
  const [top, bottom] = [ids[3 * first], ids[3 * first + 1]];
  let meshes = 0;
  while (isAt(first + meshes, top + meshes, bottom + meshes, top + meshes + 1)) meshes++;
  if (Math.max(top, bottom) + meshes + BEHIND >= rows) return 0;
  for (let i = 0; i < meshes; i++) {
    if (!isAt(first + meshes + i, top + i + 1, bottom + i, bottom + i + 1)) return 0;
  }
  return meshes;
}
