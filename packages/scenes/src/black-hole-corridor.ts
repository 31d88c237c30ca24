import type { Hole } from './black-hole-types.ts';

// Decides on a grid whether a ship can fly through a layout of holes.
// |
// A cell is open if its distance from every hole exceeds the hole's radius by `CLEARANCE` radii, so that the escape
// speed from a single hole is below three quarters of that at its horizon. A breadth-first search visits open cells
// along the axes, as the thrust does, and computes the energy of a ship at full thrust:
// |
// | ½ v² = Φ(start) - Φ(cell) + a L Φ = -Σ μ / d, or -Σ μ / (d - r) in the Paczyński–Wiita potential
// | a thrust, m/s² L length of the path, m
// |
// A cell with negative energy is out of reach. The shortest path has the least thrust to spend, so the result is
// conservative.

/** The properties of the stage that the search needs. */
export interface CorridorStage {
  readonly width: number;
  readonly height: number;
  readonly start: { readonly x: number; readonly y: number };
  readonly goal: number;
  readonly lightSpeed: number;
  readonly thrust: number;
}

const CELL = 10;
/** Clear distance from the horizon in radii, and its minimum, m: the length of a ship. */
const CLEARANCE = 0.8;
const MIN_CLEARANCE = 14;

/**
 * Finds the cells from the start to the goal, as centres x, y, x, y…; undefined if there is no path.
 * @param isSteep uses the Paczyński–Wiita potential
 */
export function findCorridor(holes: readonly Hole[], stage: CorridorStage, isSteep = false): Float64Array | undefined {
  const columns = Math.floor(stage.width / CELL);
  const rows = Math.floor(stage.height / CELL);
  const from = new Int32Array(columns * rows).fill(-1);
  const steps = new Int32Array(columns * rows);
  const queue = new Int32Array(columns * rows);
  const start = Math.floor(stage.start.y / CELL) * columns + Math.floor(stage.start.x / CELL);
  const level = potential(holes, stage, isSteep, stage.start.x, stage.start.y);
  from[start] = start;
  queue[0] = start;
  for (let next = 0, end = 1; next < end; next++) {
    const cell = queue[next];
    const column = cell % columns;
    const row = (cell - column) / columns;
    if ((row + 0.5) * CELL > stage.goal) return pathTo(cell, from, columns);
    for (let side = 0; side < 4; side++) {
      const c = column + (side === 0 ? 1 : side === 1 ? -1 : 0);
      const r = row + (side === 2 ? 1 : side === 3 ? -1 : 0);
      const there = r * columns + c;
      if (c < 0 || c >= columns || r < 0 || r >= rows || from[there] >= 0) continue;
      const x = (c + 0.5) * CELL;
      const y = (r + 0.5) * CELL;
      steps[there] = steps[cell] + 1;
      const work = stage.thrust * CELL * steps[there];
      if (!isClear(holes, x, y) || level - potential(holes, stage, isSteep, x, y) + work < 0) continue;
      from[there] = cell;
      queue[end++] = there;
    }
  }
  return undefined;
}

/** Whether a point keeps its clearance from every hole, wherever the hole is on its orbit. */
export function isClear(holes: readonly Hole[], x: number, y: number): boolean {
  for (const hole of holes) {
    const reach = hole.orbit + hole.radius + Math.max(MIN_CLEARANCE, CLEARANCE * hole.radius);
    const dx = x - hole.x;
    const dy = y - hole.y;
    if (dx * dx + dy * dy < reach * reach) return false;
  }
  return true;
}

/** Φ of all holes, m²/s². */
function potential(
  holes: readonly Hole[],
  { lightSpeed }: CorridorStage,
  isSteep: boolean,
  x: number,
  y: number,
): number {
  let sum = 0;
  for (const hole of holes) {
    const dx = x - hole.x;
    const dy = y - hole.y;
    const d = Math.sqrt(dx * dx + dy * dy + 1);
    // Open cells are farther from a hole than its radius; other cells are not evaluated.
    sum -= (0.5 * lightSpeed * lightSpeed * hole.radius) / (isSteep ? Math.max(1, d - hole.radius) : d);
  }
  return sum;
}

function pathTo(goal: number, from: Int32Array, columns: number): Float64Array {
  const cells: number[] = [];
  for (let cell = goal; ; cell = from[cell]) {
    cells.push(cell);
    if (from[cell] === cell) break;
  }
  const way = new Float64Array(2 * cells.length);
  for (const [i, cell] of cells.reverse().entries()) {
    way[2 * i] = ((cell % columns) + 0.5) * CELL;
    way[2 * i + 1] = (Math.floor(cell / columns) + 0.5) * CELL;
  }
  return way;
}
