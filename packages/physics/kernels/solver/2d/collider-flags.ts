// Bits of a row's flags that say how its collider takes part in collisions.
import { get } from '../../memory/columns';
import { COMBINES, GROUPED, ONE_WAY, SENSOR, word } from './body';
import { RigidTable } from './rigid-table';

// @ts-ignore: decorator
@inline export function colliderFlags(t: RigidTable, row: i32): u32 {
  let flags: u32 = word(t.sensor, row) != 0 ? SENSOR : 0;
  if (word(t.oneWay, row) != 0) flags |= ONE_WAY;
  if (get(t.group, row) != 0) flags |= GROUPED;
  if ((word(t.frictionCombine, row) | word(t.restitutionCombine, row)) != 0) flags |= COMBINES;
  return flags;
}
