// Lists of triangles that are known to be those of a cloth with springs along rows and columns.

const quadsOf = new WeakMap<object, number>();

/**
 * Notes that a list has the triangles of a grid with springs along rows and columns: for each row `quads` triangles whose
 * second side is a diagonal, and then as many whose first side is. Returns the list.
 */
export function markWoven<List extends object>(triangles: List, quads: number): List {
  quadsOf.set(triangles, quads);
  return triangles;
}

/** Returns the number of quads per row of a list that `markWoven` noted, else 0. */
export function quadsPerRow(triangles: object): number {
  return quadsOf.get(triangles) ?? 0;
}
