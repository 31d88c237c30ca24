// Segment walls, gathered from their columns once a step, and a coarse grid that finds the walls near a moving body.
// The grid has about as many cells as walls, at most 64 x 64; a cell lists the walls whose bounding boxes overlap it,
// in ascending id. A few walls share one cell.
import { get } from '../../memory/columns';
import { putWord, word } from '../table';

@unmanaged
export class Segment {
  minX: real;
  minY: real;
  maxX: real;
  maxY: real;
  ax: real;
  ay: real;
  // Unit vector from a to b (zero if the ends coincide), and the length.
  tx: real;
  ty: real;
  length: real;
  restitution: real;
  friction: real;
  id: i32;
}

export const SEGMENT_SIZE: usize = (offsetof<Segment>() + sizeof<real>() - 1) & ~(sizeof<real>() - 1);

// The gathered walls; src/particle-contacts/segment-walls.ts allocates the memory and sets the addresses.
@unmanaged
export class WallGrid {
  count: i32;
  segments: usize;
  starts: usize;
  items: usize;
  maxItems: i32;
  side: i32;
  // Columns of the component SegmentWall.
  ax: usize;
  ay: usize;
  bx: usize;
  by: usize;
  restitution: usize;
  friction: usize;
  // Columns of positions and velocities at the start of the step.
  previousX: usize;
  previousY: usize;
  startX: usize;
  startY: usize;
  // Bounds of all walls, m, and grid cells per metre; all are exact `real` values.
  minX: f64;
  minY: f64;
  maxX: f64;
  maxY: f64;
  cellsPerMetreX: f64;
  cellsPerMetreY: f64;
}

const MAX_WALLS_IN_ONE_CELL: i32 = 8;
const MAX_SIDE: i32 = 64;

// @ts-ignore: decorator
@inline export function segment(g: WallGrid, i: i32): Segment {
  return changetype<Segment>(g.segments + <usize>i * SEGMENT_SIZE);
}

// Returns the grid column of a coordinate, clamped to the grid.
function columnOf(x: real, low: real, cellsPerMetre: real, side: i32): i32 {
  const cell = (x - low) * cellsPerMetre;
  return cell > 0 ? min<i32>(side - 1, <i32>min<real>(cell, <real>MAX_SIDE)) : 0;
}

// @ts-ignore: decorator
@inline export function columnX(g: WallGrid, x: real): i32 {
  return columnOf(x, <real>g.minX, <real>g.cellsPerMetreX, g.side);
}

// @ts-ignore: decorator
@inline export function columnY(g: WallGrid, y: real): i32 {
  return columnOf(y, <real>g.minY, <real>g.cellsPerMetreY, g.side);
}

// Gathers the walls `ids` (ascending) and builds their grid.
export function gatherSegments(grid: usize, ids: usize, count: i32): void {
  const g = changetype<WallGrid>(grid);
  let n = 0;
  let minX = <real>Infinity;
  let minY = <real>Infinity;
  let maxX = -(<real>Infinity);
  let maxY = -(<real>Infinity);
  for (let i = 0; i < count; i++) {
    const id = word(ids, i);
    const x = get(g.ax, id);
    const y = get(g.ay, id);
    const dx = get(g.bx, id) - x;
    const dy = get(g.by, id) - y;
    const length = sqrt<real>(dx * dx + dy * dy);
    // A wall with an end that is not finite stops no body, and must not make the grid bounds infinite.
    if (!isFinite<real>(x + y + length)) continue;
    const s = segment(g, n++);
    s.minX = min<real>(x, x + dx);
    s.minY = min<real>(y, y + dy);
    s.maxX = max<real>(x, x + dx);
    s.maxY = max<real>(y, y + dy);
    s.ax = x;
    s.ay = y;
    s.tx = length > 0 ? dx / length : <real>0;
    s.ty = length > 0 ? dy / length : <real>0;
    s.length = length;
    s.restitution = get(g.restitution, id);
    s.friction = get(g.friction, id);
    s.id = id;
    minX = min<real>(minX, s.minX);
    minY = min<real>(minY, s.minY);
    maxX = max<real>(maxX, s.maxX);
    maxY = max<real>(maxY, s.maxY);
  }
  g.count = n;
  g.minX = minX;
  g.minY = minY;
  g.maxX = maxX;
  g.maxY = maxY;
  listWalls(g);
}

// Fills the cells; the grid becomes coarser if long walls would fill too many cells.
function listWalls(g: WallGrid): void {
  let side = 1;
  if (g.count > MAX_WALLS_IN_ONE_CELL) while (side < MAX_SIDE && side * side < g.count) side <<= 1;
  for (; ; side >>= 1) {
    g.side = side;
    const width = <real>g.maxX - <real>g.minX;
    const height = <real>g.maxY - <real>g.minY;
    g.cellsPerMetreX = width > 0 ? <real>side / width : <real>0;
    g.cellsPerMetreY = height > 0 ? <real>side / height : <real>0;
    memory.fill(g.starts, 0, (<usize>(side * side + 1)) << 2);
    if (visitCells(g, false) <= g.maxItems || side == 1) break;
  }
  let sum = 0;
  for (let cell = 0; cell < side * side; cell++) {
    const size = word(g.starts, cell + 1);
    putWord(g.starts, cell + 1, sum);
    sum += size;
  }
  visitCells(g, true);
}

// Counts the walls of each cell or, with `list`, stores them at the positions that the counts became. Returns the
// total.
function visitCells(g: WallGrid, list: bool): i32 {
  let total = 0;
  for (let i = 0; i < g.count; i++) {
    const s = segment(g, i);
    const right = columnX(g, s.maxX);
    const top = columnY(g, s.maxY);
    for (let y = columnY(g, s.minY); y <= top; y++) {
      for (let x = columnX(g, s.minX); x <= right; x++) {
        const cell = y * g.side + x;
        const position = word(g.starts, cell + 1);
        putWord(g.starts, cell + 1, position + 1);
        if (list) putWord(g.items, position, i);
        total++;
      }
    }
  }
  return total;
}
