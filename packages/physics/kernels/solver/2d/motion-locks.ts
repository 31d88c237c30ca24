// Bodies that do not move along an axis. Contacts and joints give them no velocity there, and what forces give is cleared after
// each pass of the solver; effective masses know that along it they are immovable, so that the impulses of a pass are right:
//
//   1/m(n) = (nx² fx + ny² fy)/m      f: 0 along a locked axis, otherwise 1
//
// A locked angle is an inverse moment of inertia of 0.
import { DYNAMIC, LOCKED, flagsOf, poseOf, putWord, stateOf, word } from './body';
import { RigidTable } from './rigid-table';

// Lists the bodies that are awake and locked along an axis.
export function listLocked(t: RigidTable): void {
  let count = 0;
  for (let i = 0; i < t.awakeCount; i++) {
    const row = word(t.awake, i);
    if ((flagsOf(t, row) & (LOCKED | DYNAMIC)) == (LOCKED | DYNAMIC)) putWord(t.locked, count++, row);
  }
  t.lockedCount = count;
}

// Clears the velocities of all bodies along their locked axes.
export function holdLocked(table: usize): void {
  const t = changetype<RigidTable>(table);
  for (let i = 0; i < t.lockedCount; i++) {
    const row = word(t.locked, i);
    const state = stateOf(t, row);
    if (word(t.lockX, row) != 0) state.vx = 0;
    if (word(t.lockY, row) != 0) state.vy = 0;
  }
}

// Which axes of a body with these flags are locked, in bits.
export function locksOf(t: RigidTable, row: i32, flags: u32): i32 {
  if ((flags & LOCKED) == 0) return 0;
  const x = word(t.lockX, row) != 0 ? 1 : 0;
  const y = word(t.lockY, row) != 0 ? 2 : 0;
  return x | y | (word(t.lockAngle, row) != 0 ? 4 : 0);
}

// The inverse masses of a body along the axes.
// @ts-ignore: decorator
@inline export function inverseMassX(t: RigidTable, row: i32): real {
  return (flagsOf(t, row) & LOCKED) != 0 && word(t.lockX, row) != 0 ? <real>0 : poseOf(t, row).inverseMass;
}

// @ts-ignore: decorator
@inline export function inverseMassY(t: RigidTable, row: i32): real {
  return (flagsOf(t, row) & LOCKED) != 0 && word(t.lockY, row) != 0 ? <real>0 : poseOf(t, row).inverseMass;
}

// How many axes a body can move along, 0 to 2.
export function openAxes(t: RigidTable, row: i32): i32 {
  return (inverseMassX(t, row) > 0 ? 1 : 0) + (inverseMassY(t, row) > 0 ? 1 : 0);
}

// The inverse mass of a body along a unit vector.
export function inverseMassAlong(t: RigidTable, row: i32, nx: real, ny: real): real {
  const inverseMass = poseOf(t, row).inverseMass;
  if ((flagsOf(t, row) & LOCKED) == 0) return inverseMass;
  const x: real = word(t.lockX, row) != 0 ? 0 : nx;
  const y: real = word(t.lockY, row) != 0 ? 0 : ny;
  return inverseMass * (x * x + y * y);
}
