// A tree for queries alone, of the bodies as they are between two steps, where the trees of the broad phase do not tell where they are:
// before the first step, after a snapshot was taken back, where many moved, or after steps that did not prepare for queries.
import { columns, get } from '../../../memory/columns';
import { word } from '../../../solver/2d/body';
import { RigidTable } from '../../../solver/2d/rigid-table';
import { buildNodes, joinBoxes, nodeAt, treeRowAt } from '../../broad-phase/2d/box-tree';
import { extentOf } from '../../shapes/2d/shape-pool';

// Makes the tree of all rows that have the components `required`.
export function makeOwnTree(t: RigidTable, rows: i32, required: u32): void {
  const c = columns();
  let count = 0;
  for (let row = 1; row < rows; row++) {
    if ((<u32>word(c.members, row) & required) != required) continue;
    const item = treeRowAt(t, count++);
    item.x = 2 * get(c.positionX, row);
    item.y = 2 * get(c.positionY, row);
    item.row = row;
  }
  t.ownNodeCount = buildNodes(t, t.ownNodes, count);
  for (let i = t.ownNodeCount - 1; i >= 0; i--) {
    if (nodeAt(t.ownNodes, i).row == 0) joinBoxes(t.ownNodes, i);
    else fitLeaf(t, i);
  }
}

// The box about the circle of a body, and a little more, because sums are rounded.
function fitLeaf(t: RigidTable, i: i32): void {
  const slack: real = sizeof<real>() == 4 ? 1e-6 : 1e-14;
  const c = columns();
  const node = nodeAt(t.ownNodes, i);
  const x = get(c.positionX, node.row);
  const y = get(c.positionY, node.row);
  const extent = extentOf(node.row);
  const reach = extent + slack * (abs<real>(x) + abs<real>(y) + extent);
  node.minX = x - reach;
  node.minY = y - reach;
  node.maxX = x + reach;
  node.maxY = y + reach;
}
