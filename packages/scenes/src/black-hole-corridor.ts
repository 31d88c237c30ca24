import type { Hole } from './black-hole-types.ts';

// Whether a layout of holes can be flown through, judged on a grid.
//
// A cell is open if it keeps clear of every hole by most of the hole's radius, so that the escape speed from any one
// hole is below three quarters of that at its rim. From the start the search goes from open cell to open cell along the
// axes, as the thrust does, and keeps the energy of a ship on that way at full thrust:
//
//   ½ v² = Φ(start) - Φ(cell) + a L        Φ = -Σ μ / d, or -Σ μ / (d - r) for a pull after Paczyński and Wiita
//   a  thrust, m/s²        L  length of the way, m
//
// A cell where that would be negative is beyond the ship's strength. The shortest way has the least thrust to spend, so
// the judgement errs on the safe side.

/** What the search has to know of the stage. */
export interface CorridorStage {
  readonly width: number;
  readonly height: number;
  readonly start: { readonly x: number; readonly y: number };
  readonly goal: number;
  readonly lightSpeed: number;
  readonly thrust: number;
}

const CELL = 10;
/** Clear distance from the rim, in radii, and the least of it, m: a ship's length. */
const CLEARANCE = 0.8;
const LEAST_CLEARANCE = 14;

/**
 * Cells from the start to the goal, as centres x, y, x, y…; undefined where there is no way.
 * @param isSteep the holes pull after Paczyński and Wiita
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
    if ((row + 0.5) * CELL > stage.goal) return wayTo(cell, from, columns);
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

/** Whether a point keeps clear of every hole, wherever on its circle that is. */
export function isClear(holes: readonly Hole[], x: number, y: number): boolean {
  for (const hole of holes) {
    const reach = hole.orbit + hole.radius + Math.max(LEAST_CLEARANCE, CLEARANCE * hole.radius);
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
    // Open cells are farther from a hole than its radius; the others are not asked for.
    sum -= (0.5 * lightSpeed * lightSpeed * hole.radius) / (isSteep ? Math.max(1, d - hole.radius) : d);
  }
  return sum;
}

function wayTo(goal: number, from: Int32Array, columns: number): Float64Array {
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
