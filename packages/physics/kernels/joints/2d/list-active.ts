// The joints that act in a step, and what each of them does. As long as these are those of the step before, their trees and
// colors are, too.
import { get } from '../../memory/columns';
import { ASLEEP, LOCKED, MOVES, flagsOf, isPushed, putWord, word } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import {
  DISTANCE,
  FILTER,
  IMPULSES_SIZE,
  JointImpulses,
  JointTable,
  REVOLUTE,
  WELD,
  impulsesOf,
  isCoupling,
  isSolvedApart,
} from './joint-table';

// What a joint does: it locks directions; it is a hinge; it has a spring, a motor or limits, or is a motor joint, pulley or
// gear.
export const LOCKS: i32 = 1;
export const HINGE: i32 = 2;
export const SPRING: i32 = 4;
export const POWERED: i32 = 8;
export const LIMITED: i32 = 16;
const SPECIAL: i32 = 32;
export const AXES: i32 = SPRING | POWERED | LIMITED | SPECIAL;

// Which of the two bodies moves, be it kinematic.
export const A_MOVES: i32 = 64;
export const B_MOVES: i32 = 128;
// One of them does not move along some axis.
export const LOCKED_END: i32 = 256;
// It is a rod with limits, without spring: it locks its direction while one of them bears (engage-limits.ts).
export const ROPE: i32 = 512;
// It is a pulley or a gear.
export const COUPLES: i32 = 1024;
// Above these bits stands the kind: a joint that becomes another is laid out anew.
const KIND: i32 = 2048;

// @ts-ignore: decorator
@inline export function isPlainHinge(role: i32): bool {
  return (role & (LOCKS | HINGE | AXES)) == (LOCKS | HINGE);
}

// Whether it holds both bodies as if they were one.
// @ts-ignore: decorator
@inline export function isRigid(role: i32): bool {
  return role / KIND == <i32>WELD && (role & AXES) == 0;
}

// Returns whether the list has changed.
export function listActive(t: JointTable, rigid: RigidTable): bool {
  let count = 0;
  let changed = false;
  for (let i = 0; i < t.count; i++) {
    const id = word(t.ids, i);
    if (word(t.started, id) == 0) {
      memory.fill(changetype<usize>(impulsesOf(t, id)), 0, IMPULSES_SIZE);
      putWord(t.started, id, 1);
      changed = true;
    }
    const kind = <u32>word(t.kind, id);
    if (kind == FILTER) continue;
    const a = word(t.a, id);
    const b = word(t.b, id);
    const flagsA = flagsOf(rigid, a);
    const flagsB = flagsOf(rigid, b);
    if (!isPushed(flagsA) && !isPushed(flagsB)) {
      if (((flagsA | flagsB) & ASLEEP) == 0) forgetForces(impulsesOf(t, id));
      continue;
    }
    let role = roleOf(t, id, kind) | (KIND * <i32>kind);
    if ((flagsA & MOVES) != 0) role |= A_MOVES;
    if ((flagsB & MOVES) != 0) role |= B_MOVES;
    if (((flagsA | flagsB) & LOCKED) != 0) role |= LOCKED_END;
    if (replaces(t.active, count, id)) changed = true;
    if (replaces(t.roles, count, role)) changed = true;
    if (replaces(t.ends, 2 * count, a)) changed = true;
    if (replaces(t.ends, 2 * count + 1, b)) changed = true;
    if (replaces(t.nodes, 2 * count, isPushed(flagsA) ? a : 0)) changed = true;
    if (replaces(t.nodes, 2 * count + 1, isPushed(flagsB) ? b : 0)) changed = true;
    count++;
  }
  if (count != t.activeCount) changed = true;
  t.activeCount = count;
  return changed;
}

// Of a joint that has nothing to hold. One whose bodies sleep goes on to bear what it bore.
// @ts-ignore: decorator
@inline function forgetForces(impulses: JointImpulses): void {
  impulses.force = 0;
  impulses.torque = 0;
}

// Writes a word, and returns whether it was another.
// @ts-ignore: decorator
@inline function replaces(list: usize, i: i32, value: i32): bool {
  const before = word(list, i);
  if (before == value) return false;
  putWord(list, i, value);
  return true;
}

// A rod with a spring locks nothing, and one with limits only while they bear, or while its motor holds its speed.
// @ts-ignore: decorator
@inline function roleOf(t: JointTable, id: i32, kind: u32): i32 {
  if (isSolvedApart(kind)) return isCoupling(kind) ? SPECIAL | COUPLES : SPECIAL;
  let axes = 0;
  if (get(t.hertz, id) > 0) axes |= SPRING;
  if (get(t.maxMotor, id) > 0) axes |= POWERED;
  if (word(t.hasLimits, id) != 0) axes |= LIMITED;
  if (kind == REVOLUTE) return LOCKS | HINGE | axes;
  if (kind != DISTANCE || (axes & (SPRING | LIMITED)) == 0) return LOCKS | axes;
  return (axes & SPRING) == 0 ? ROPE | axes : axes;
}

// Clears the impulses of springs, motors and limits that were switched off.
export function dropUnused(t: JointTable): void {
  for (let i = 0; i < t.activeCount; i++) {
    const role = word(t.roles, i);
    if ((role & SPECIAL) != 0) continue;
    const impulses = impulsesOf(t, word(t.active, i));
    if ((role & SPRING) == 0) impulses.spring = 0;
    if ((role & POWERED) == 0) impulses.motor = 0;
    if ((role & LIMITED) != 0) continue;
    impulses.lower = 0;
    impulses.upper = 0;
  }
}
