// What the solvers of taut chains (taut-chain.ts, dual-chain.ts) know of a body: where it is, and what it has to bear.
import { get } from '../memory/columns';
import { Symmetric } from './symmetric';
import { ConstraintTable, packedAt, packedComponent, putPackedComponent, word } from './table';

@unmanaged
export class ChainNode {
  // Position, and predicted position without springs.
  x: f64;
  y: f64;
  z: f64;
  toX: f64;
  toY: f64;
  toZ: f64;
  // Mobility P of the body and all before it: a symmetric matrix.
  xx: f64;
  xy: f64;
  xz: f64;
  yy: f64;
  yz: f64;
  zz: f64;
  // 0 for a body that does not move.
  mass: f64;
}

// @ts-ignore: decorator
@inline export function mobilityOf(node: ChainNode): Symmetric {
  return changetype<Symmetric>(changetype<usize>(node) + offsetof<ChainNode>('xx'));
}

// @ts-ignore: decorator
@inline function bodyOf(t: ConstraintTable, row: i32, last: i32): u32 {
  return row < last ? word(t.a, row) : word(t.b, row - 1);
}

// @ts-ignore: decorator
@inline export function readBody(t: ConstraintTable, row: i32, last: i32, node: ChainNode): void {
  const p = packedAt(t, bodyOf(t, row, last));
  const w = <f64>packedComponent(p, 3);
  node.mass = w > 0 ? 1 / w : 0;
  node.x = node.toX = <f64>packedComponent(p, 0);
  node.y = node.toY = <f64>packedComponent(p, 1);
  node.z = node.toZ = <f64>packedComponent(p, 2);
}

// @ts-ignore: decorator
@inline export function writeBody(t: ConstraintTable, row: i32, last: i32, node: ChainNode): void {
  if (node.mass == 0) return;
  const p = packedAt(t, bodyOf(t, row, last));
  putPackedComponent(p, 0, <real>node.x);
  putPackedComponent(p, 1, <real>node.y);
  putPackedComponent(p, 2, <real>node.z);
}

// The compliance of a row, 1/(k h^2), in the quantities of rows.ts.
// @ts-ignore: decorator
@inline export function complianceOf(t: ConstraintTable, row: i32): f64 {
  const gain = <f64>get(t.gain, row);
  return gain > 0 ? <f64>get(t.softness, row) / gain : 0;
}
