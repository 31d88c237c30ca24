// Restricts a force to some bodies by undoing its effect on all others.
import { columns, get, put } from '../memory/columns';

// The limits of a force. Kind of region: 0 none, 1 a box (a = minimum, b = maximum), 2 a ball (a = centre, bx =
// radius squared). All f64.
@unmanaged
export class Limits {
  ax: f64;
  ay: f64;
  az: f64;
  bx: f64;
  by: f64;
  bz: f64;
  kind: i32;
  // Bits of the required components in each of the two words of membership, and the column of the second.
  group: u32;
  moreGroup: u32;
  moreMembers: usize;
}

// @ts-ignore: decorator
@inline function isInside(l: Limits, row: i32): bool {
  const c = columns();
  if ((load<u32>(c.members + ((<usize>row) << 2)) & l.group) != l.group) return false;
  if ((load<u32>(l.moreMembers + ((<usize>row) << 2)) & l.moreGroup) != l.moreGroup) return false;
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

// Restores the saved values in the rows where the force does not act.
export function restoreOutside(limits: usize, column: usize, saved: usize, first: i32, last: i32): void {
  const l = changetype<Limits>(limits);
  for (let row = first; row < last; row++) {
    if (!isInside(l, row)) put(column, row, get(saved, row));
  }
}

// Zeroes a column in the rows outside the group: bodies without coefficients have no potential.
export function zeroOutside(limits: usize, column: usize, first: i32, last: i32): void {
  const l = changetype<Limits>(limits);
  for (let row = first; row < last; row++) {
    if (!isInside(l, row)) put(column, row, 0);
  }
}
