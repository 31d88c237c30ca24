// The trees of the broad phase, for queries about bodies as they are after a step. The boxes of the trees are those of the
// start of the step, so that a query is widened by as far as any body has moved in it. A checksum tells whether anything
// changed since; the rows that did are then listed once (changed-rows.ts), and the query visits them beside what it finds in the
// trees, or all rows if they are many. After a few queries that had to look at all rows they get a tree of their own (own-tree.ts).
import { columns } from '../../../memory/columns';
import { at } from '../../../memory/lanes';
import { COLLIDES, WALL, flagsOf, putWord, word } from '../../../solver/2d/body';
import { longestPath } from '../../../solver/2d/paths';
import { RigidTable } from '../../../solver/2d/rigid-table';
import { TreeNode, nodeAt } from '../../broad-phase/2d/box-tree';
import { BodyQuery, queryAt } from './body-query';
import { listChangedRows, rememberColumns } from './changed-rows';
import { makeOwnTree } from './own-tree';

// Steps without a query after which steps no longer prepare for one.
const PATIENCE: i32 = 60;

// Queries that look at all rows take as long as it takes to make a tree.
const LOOKS: i32 = 12;

// Ends a step: keeps what tells later which bodies the trees still hold for. `pool` is the version of the pool of shapes.
export function rememberPoses(table: usize, version: i32, pool: i32): void {
  const t = changetype<RigidTable>(table);
  t.rememberedVersion = -1;
  t.ownTreeHolds = 0;
  t.looks = 0;
  if (t.queryPatience == 0) return;
  t.queryPatience--;
  rememberColumns(t, t.rows);
  t.rememberedPool = pool;
  noteVersion(t, t.rows, version, checksumOfPoses(t, t.rows));
  // A little more, because sums are rounded.
  t.longestPath = <f64>longestPath(t) * 1.0001;
}

// Whether trees and the list of rows that changed tell where all bodies are, before so many queries about rows with the components
// `required`. The first query after a while finds that they do not.
export function treesHold(table: usize, rows: i32, version: i32, pool: i32, required: u32, queries: i32): i32 {
  const t = changetype<RigidTable>(table);
  t.queryPatience = PATIENCE;
  const sum = checksumOfPoses(t, rows);
  if (isRemembered(t, pool)) {
    const known = ((<u64>t.rememberedHigh) << 32) | <u64>t.rememberedLow;
    if (t.rememberedVersion != version || t.checkedRows != rows || known != sum) {
      listChangedRows(t, rows);
      noteVersion(t, rows, version, sum);
    }
    if (t.changedRowCount >= 0) return 1;
  }
  t.looks += queries;
  if (t.looks < LOOKS) return 0;
  t.looks = 0;
  makeOwnTree(t, rows, required);
  t.ownTreeHolds = 1;
  rememberColumns(t, rows);
  t.rememberedPool = pool;
  noteVersion(t, rows, version, sum);
  return 1;
}

// @ts-ignore: decorator
@inline function isRemembered(t: RigidTable, pool: i32): bool {
  if (t.rememberedVersion == -1 || t.rememberedPool != pool) return false;
  return (t.ownTreeHolds | (t.staticTreeValid & t.movingTreeValid)) != 0;
}

// The bodies as they are now are those of the list of changed rows.
function noteVersion(t: RigidTable, rows: i32, version: i32, sum: u64): void {
  t.checkedRows = rows;
  t.rememberedVersion = version;
  t.rememberedLow = <u32>sum;
  t.rememberedHigh = <u32>(sum >> 32);
}

// A sum over the bits of all positions and angles, by rotation and exclusive or, which differs when any of them does.
function checksumOfPoses(t: RigidTable, rows: i32): u64 {
  const c = columns();
  const end = at((rows + 15) & ~15);
  const sum = addColumn(addColumn(addColumn(i64x2.splat(0), c.positionX, end), c.positionY, end), t.angle, end);
  return <u64>i64x2.extract_lane(sum, 0) ^ ((<u64>i64x2.extract_lane(sum, 1)) << 1);
}

// @ts-ignore: decorator
@inline function mix(sum: v128, value: v128): v128 {
  return v128.xor(v128.or(i32x4.shl(sum, 5), i32x4.shr_u(sum, 27)), value);
}

// Blocks of 64 bytes in four sums, which do not wait for each other.
function addColumn(start: v128, column: usize, end: usize): v128 {
  let a = start;
  let b = start;
  let c = start;
  let d = start;
  for (let p = column; p < column + end; p += 64) {
    a = mix(a, v128.load(p));
    b = mix(b, v128.load(p, 16));
    c = mix(c, v128.load(p, 32));
    d = mix(d, v128.load(p, 48));
  }
  return mix(mix(mix(a, b), c), d);
}

// Lists the bodies whose boxes come within reach of the path of a query, and those that changed, in ascending order.
export function collectCandidates(query: usize, table: usize): void {
  const t = changetype<RigidTable>(table);
  const q = queryAt(query);
  q.candidates = t.treeRows;
  q.candidateCount = 0;
  if (t.ownTreeHolds != 0) collectIn(t, q, t.ownNodes, t.ownNodeCount, 0);
  else {
    collectIn(t, q, t.staticNodes, t.staticNodeCount, COLLIDES | WALL);
    collectIn(t, q, t.movingNodes, t.movingNodeCount, COLLIDES | WALL);
  }
  for (let i = 0; i < t.changedRowCount; i++) putWord(q.candidates, q.candidateCount++, word(t.changedRows, i));
  sortRows(q.candidates, q.candidateCount);
}

// Of the flags of a row in a tree of the broad phase those of `checked` are to be those of a body with a collider.
function collectIn(t: RigidTable, q: BodyQuery, nodes: usize, count: i32, checked: u32): void {
  const reach = q.reach + <real>(checked == 0 ? 0 : t.longestPath);
  let i = 0;
  while (i < count) {
    const node = nodeAt(nodes, i);
    if (!meetsPath(q, node, reach)) {
      i = node.skip;
      continue;
    }
    i++;
    const row = node.row;
    if (row <= 0 || (flagsOf(t, row) & checked) != (COLLIDES & checked)) continue;
    putWord(q.candidates, q.candidateCount++, row);
  }
}

// Whether a box comes within reach of the path, which is a segment: along both axes, and across the segment.
// @ts-ignore: decorator
@inline function meetsPath(q: BodyQuery, box: TreeNode, reach: real): bool {
  const endX = q.x + q.limit * q.dx;
  const endY = q.y + q.limit * q.dy;
  if (max<real>(q.x, endX) + reach < box.minX || min<real>(q.x, endX) - reach > box.maxX) return false;
  if (max<real>(q.y, endY) + reach < box.minY || min<real>(q.y, endY) - reach > box.maxY) return false;
  const halfX = <real>0.5 * (box.maxX - box.minX) + reach;
  const halfY = <real>0.5 * (box.maxY - box.minY) + reach;
  const toX = <real>0.5 * (box.minX + box.maxX) - q.x;
  const toY = <real>0.5 * (box.minY + box.maxY) - q.y;
  // Twice the rounding of the products, for what just touches.
  const slack: real = sizeof<real>() == 4 ? 1e-5 : 1e-13;
  const across = abs<real>(toX * q.dy - toY * q.dx);
  const size = abs<real>(q.dy) * (halfX + slack * abs<real>(toX)) + abs<real>(q.dx) * (halfY + slack * abs<real>(toY));
  return !(across > size);
}

// Shell's sort, with the gaps of Ciura (2001) continued by a factor of 2.25.
function sortRows(list: usize, count: i32): void {
  let gap = 1;
  while (gap < count) gap = (gap * 9) / 4 + 1;
  while (gap > 1) {
    gap = max<i32>(1, (gap * 4) / 9);
    for (let i = gap; i < count; i++) {
      const row = word(list, i);
      let j = i;
      for (; j >= gap && word(list, j - gap) > row; j -= gap) putWord(list, j, word(list, j - gap));
      putWord(list, j, row);
    }
  }
}
