// Bits of a row's flags that say how its collider takes part in collisions. Few worlds use them: a step first finds out
// whether any row of their columns is not zero.
import { get } from '../../memory/columns';
import { at } from '../../memory/lanes';
import { COMBINES, GROUPED, ONE_WAY, SENSOR, word } from './body';
import { RigidTable } from './rigid-table';

export function findColliderFlags(t: RigidTable): void {
  // Columns have whole blocks of 16 rows.
  const words = (<usize>((t.rows + 15) & ~15)) << 2;
  const reals = at((t.rows + 15) & ~15);
  const any =
    isUsed(t.sensor, words) ||
    isUsed(t.oneWay, words) ||
    isUsed(t.group, reals) ||
    isUsed(t.frictionCombine, words) ||
    isUsed(t.restitutionCombine, words);
  t.usesColliderFlags = any ? 1 : 0;
  t.usesResistance = isUsed(t.rollingResistance, reals) ? 1 : 0;
}

function isUsed(column: usize, bytes: usize): bool {
  let sum = i32x4.splat(0);
  for (let p = column; p < column + bytes; p += 64) {
    const low = v128.or(v128.load(p), v128.load(p, 16));
    sum = v128.or(sum, v128.or(low, v128.or(v128.load(p, 32), v128.load(p, 48))));
  }
  return v128.any_true(sum);
}

// @ts-ignore: decorator
@inline export function colliderFlags(t: RigidTable, row: i32): u32 {
  return t.usesColliderFlags == 0 ? 0 : readColliderFlags(t, row);
}

function readColliderFlags(t: RigidTable, row: i32): u32 {
  let flags: u32 = word(t.sensor, row) != 0 ? SENSOR : 0;
  if (word(t.oneWay, row) != 0) flags |= ONE_WAY;
  if (get(t.group, row) != 0) flags |= GROUPED;
  if ((word(t.frictionCombine, row) | word(t.restitutionCombine, row)) != 0) flags |= COMBINES;
  return flags;
}

// What tells whether layers, mask or group have changed. Odd factors: a change of one of them changes the sum.
// @ts-ignore: decorator
@inline export function filterOf(t: RigidTable, row: i32): i32 {
  return word(t.layers, row) + word(t.masks, row) * MASK_FACTOR + <i32>get(t.group, row) * GROUP_FACTOR;
}

// Of the golden ratio and of the plastic number, so that changes of two of them hardly cancel.
const MASK_FACTOR: i32 = 0x9e3779b1;
const GROUP_FACTOR: i32 = 0xc13fa9a9;
