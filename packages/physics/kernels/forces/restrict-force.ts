// A force for some bodies only: what it did to the others is undone.
import { columns, get, put } from '../memory/columns';

// Where a force acts. A kind of region: 0 everywhere, 1 a box (a = lowest corner, b = highest), 2 a ball (a = centre,
// bx = radius squared). All f64.
@unmanaged
export class Limits {
  ax: f64;
  ay: f64;
  az: f64;
  bx: f64;
  by: f64;
  bz: f64;
  kind: i32;
  group: u32;
}

// @ts-ignore: decorator
@inline function within(l: Limits, row: i32): bool {
  const c = columns();
  if ((load<u32>(c.members + ((<usize>row) << 2)) & l.group) != l.group) return false;
  if (l.kind == 0) return true;
  const x = <f64>get(c.positionX, row);
  const y = <f64>get(c.positionY, row);
  const z = <f64>get(c.positionZ, row);
  if (l.kind == 1) return x >= l.ax && x <= l.bx && y >= l.ay && y <= l.by && z >= l.az && z <= l.bz;
  const dx = x - l.ax;
  const dy = y - l.ay;
  const dz = z - l.az;
  return dx * dx + dy * dy + dz * dz <= l.bx;
}

// Puts the saved values back on the rows where the force does not act; `shift` rows separate a row from its save.
export function restoreOutside(limits: usize, column: usize, saved: usize, first: i32, last: i32): void {
  const l = changetype<Limits>(limits);
  for (let row = first; row < last; row++) {
    if (!within(l, row)) put(column, row, get(saved, row));
  }
}

// Zeroes a column on the rows outside the group: bodies without coefficients have no potential.
export function zeroOutside(limits: usize, column: usize, first: i32, last: i32): void {
  const l = changetype<Limits>(limits);
  for (let row = first; row < last; row++) {
    if (!within(l, row)) put(column, row, 0);
  }
}
