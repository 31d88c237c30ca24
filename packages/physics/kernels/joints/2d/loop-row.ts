// The directions of mechanisms that are in no tree (close-loops.ts).
import { JointTable } from './joint-table';

// A direction that a joint of a mechanism locks and that is in no tree: what it has of the velocity of each body.
@unmanaged
export class LoopRow {
  ax: f64;
  ay: f64;
  aw: f64;
  bx: f64;
  by: f64;
  bw: f64;
  // Both bodies, class ArticulatedBody; 0 for one that joints do not move.
  a: usize;
  b: usize;
  // Where its impulse stands.
  impulse: usize;
  pad: usize;
  // The inverse mass of both bodies along it, 1/kg.
  inverseMass: f64;
  // How much it gives way, 1/kg.
  compliance: f64;
  // How fast it is to close: what closes the gap, the chord (chords.ts), and how fast a body moves that joints do not move, m/s.
  wanted: f64;
  // How fast it moves otherwise, then the impulse along it, N s.
  value: f64;
}

export const LOOP_ROW: usize = offsetof<LoopRow>();

// @ts-ignore: decorator
@inline export function loopRow(t: JointTable, i: i32): LoopRow {
  return changetype<LoopRow>(t.loopRows + <usize>i * LOOP_ROW);
}

// Makes it a direction in which nothing moves.
export function clearDirection(row: LoopRow): void {
  row.ax = 0;
  row.ay = 0;
  row.aw = 0;
  row.bx = 0;
  row.by = 0;
  row.bw = 0;
  row.inverseMass = 0;
  row.compliance = 0;
  row.wanted = 0;
}
