// A block of hinges that close loops, which are solved side by side: one vector for each of these numbers, with a lane for
// each hinge.
import { JointTable } from './joint-table';

// @ts-ignore: decorator
@inline const V: usize = 16;

// Addresses of the states of the bodies a and b, their rows, and the id of the joint, -1 for a lane without one.
export const A: usize = 0;
export const B: usize = V;
export const ROW_A: usize = 2 * V;
export const ROW_B: usize = 3 * V;
export const JOINT: usize = 4 * V;
// Inverse masses, 0 along a locked axis, and moments of inertia.
export const MASS_AX: usize = 5 * V;
export const MASS_AY: usize = 6 * V;
export const MASS_BX: usize = 7 * V;
export const MASS_BY: usize = 8 * V;
export const INERTIA_A: usize = 9 * V;
export const INERTIA_B: usize = 10 * V;
// When the step began: anchors from the centres, and from the centre of a to that of b, m.
export const START_AX: usize = 11 * V;
export const START_AY: usize = 12 * V;
export const START_BX: usize = 13 * V;
export const START_BY: usize = 14 * V;
export const START_X: usize = 15 * V;
export const START_Y: usize = 16 * V;
// Now: anchors, how fast that of b is to come to that of a, m/s: by the chord, and by what closes the gap; and the inverse of the
// effective mass matrix.
export const AX: usize = 17 * V;
export const AY: usize = 18 * V;
export const BX: usize = 19 * V;
export const BY: usize = 20 * V;
export const WANTED_X: usize = 21 * V;
export const WANTED_Y: usize = 22 * V;
export const K00: usize = 23 * V;
export const K01: usize = 24 * V;
export const K11: usize = 25 * V;
// Impulse on b, and the largest of a sub-step, squared.
export const IMPULSE_X: usize = 26 * V;
export const IMPULSE_Y: usize = 27 * V;
export const LARGEST: usize = 28 * V;
// Bends of both bodies at the end of the last sub-step, and the chord between the anchors (chords.ts).
export const BEND_A: usize = 29 * V;
export const BEND_B: usize = 30 * V;
export const CHORD_X: usize = 31 * V;
export const CHORD_Y: usize = 32 * V;
// Half steps of both bodies (brace-joints.ts), s.
export const HALF_STEP_A: usize = 33 * V;
export const HALF_STEP_B: usize = 34 * V;
export const LOOP_BLOCK: usize = 35 * V;

// @ts-ignore: decorator
@inline export function blockOf(t: JointTable, i: i32): usize {
  return t.blocks + <usize>i * LOOP_BLOCK;
}
