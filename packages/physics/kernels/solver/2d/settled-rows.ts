// Groups of rows of which nothing moves, and nothing has changed since the last step: a step has nothing to find out about them. Users may
// write to any column, so that a step looks at all of them, but at 16 rows at once: hashes tell whether any differs from what it was.
//
//   h' = (h xor v) p        for the values v of all columns in turn, in 32 bits
//
// A single value that changes always changes the hash, because each turn can be undone; of changes of several values one in 2^32 would
// go unseen. Source of the hash: Fowler, Noll and Vo, FNV-1a (IETF draft-eastlake-fnv).
import { Columns } from '../../memory/columns';
import { COLLIDES, SLEEPLESS, STATIC } from './body';
import { RigidTable } from './rigid-table';

// Rows that are looked at together: columns end with a multiple of them.
export const GROUP: i32 = 16;

const PRIME: i32 = 0x01000193;
const START: i32 = <i32>0x811c9dc5;

// What rows may be that a step need not look at: bodies that stand, with or without a collider, or none.
const PLAIN: u32 = STATIC | COLLIDES | SLEEPLESS;

@unmanaged
export class RowGroup {
  // The hash, four words.
  hash0: u32;
  hash1: u32;
  hash2: u32;
  hash3: u32;
  // Whether it is that of rows which are plain; and whether this step passes them over.
  isPlain: i32;
  isPassed: i32;
}

const SIZE: usize = offsetof<RowGroup>();

// @ts-ignore: decorator
@inline function groupAt(t: RigidTable, first: i32): RowGroup {
  return changetype<RowGroup>(t.rowGroups + <usize>(first / GROUP) * SIZE);
}

// Whether this step passes a group over.
// @ts-ignore: decorator
@inline export function isPassed(t: RigidTable, first: i32): bool {
  return groupAt(t, first).isPassed != 0;
}

// Finds out whether it does.
export function passOver(c: Columns, t: RigidTable, first: i32): bool {
  const group = groupAt(t, first);
  group.isPassed = 0;
  if (group.isPlain == 0) return false;
  const known = v128.load(changetype<usize>(group));
  if (v128.any_true(v128.xor(hashOf(c, t, first), known))) return false;
  group.isPassed = 1;
  return true;
}

// Keeps the hash of a group that this step looked at, if its rows are plain and did not change in it.
export function settle(c: Columns, t: RigidTable, first: i32): void {
  const group = groupAt(t, first);
  if (group.isPassed != 0) return;
  group.isPlain = arePlain(t, first) ? 1 : 0;
  if (group.isPlain != 0) v128.store(changetype<usize>(group), hashOf(c, t, first));
}

function arePlain(t: RigidTable, first: i32): bool {
  const flags = t.flags + ((<usize>first) << 2);
  const all = v128.or(
    v128.or(v128.load(flags), v128.load(flags, 16)),
    v128.or(v128.load(flags, 32), v128.load(flags, 48)),
  );
  return !v128.any_true(v128.and(all, i32x4.splat(<i32>~PLAIN)));
}

function hashOf(c: Columns, t: RigidTable, first: i32): v128 {
  let hash = i32x4.splat(START + t.usesColliderFlags + 2 * t.usesResistance);
  // Four rows at a time, in hashes of their own, which do not wait for each other.
  for (let row = first; row < first + GROUP; row += 4) {
    let h = i32x4.splat(START);
    const words = (<usize>row) << 2;
    h = mix(h, v128.load(t.flags + words));
    h = mix(h, v128.load(t.members + words));
    h = mix(h, v128.load(t.generations + words));
    h = mix(h, v128.load(c.shape + words));
    h = mix(h, v128.load(t.layers + words));
    h = mix(h, v128.load(t.masks + words));
    h = mixReals(h, c.positionX, row);
    h = mixReals(h, c.positionY, row);
    h = mixReals(h, t.angle, row);
    h = mixReals(h, c.radius, row);
    h = mixReals(h, c.friction, row);
    h = mixReals(h, t.tangentSpeed, row);
    h = mixReals(h, c.velocityX, row);
    h = mixReals(h, c.velocityY, row);
    h = mixReals(h, c.angularVelocityZ, row);
    h = mixReals(h, c.mass, row);
    if (t.usesColliderFlags != 0) {
      h = mix(h, v128.load(t.sensor + words));
      h = mix(h, v128.load(t.oneWay + words));
      h = mix(h, v128.load(t.frictionCombine + words));
      h = mix(h, v128.load(t.restitutionCombine + words));
      h = mixReals(h, t.group, row);
    }
    if (t.usesResistance != 0) h = mixReals(h, t.rollingResistance, row);
    hash = mix(hash, h);
  }
  return hash;
}

// @ts-ignore: decorator
@inline function mix(hash: v128, values: v128): v128 {
  return i32x4.mul(v128.xor(hash, values), i32x4.splat(PRIME));
}

// @ts-ignore: decorator
@inline function mixReals(hash: v128, column: usize, row: i32): v128 {
  const from = column + <usize>row * sizeof<real>();
  const h = mix(hash, v128.load(from));
  return sizeof<real>() == 4 ? h : mix(h, v128.load(from, 16));
}
