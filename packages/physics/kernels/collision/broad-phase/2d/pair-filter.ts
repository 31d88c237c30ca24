// Which two shapes may be in contact: by the kinds of their bodies, their layers and groups, and joints.
import { get } from '../../../memory/columns';
import { DYNAMIC, GROUPED, MAY_MOVE, MOVES, SENSOR, WALL, flagsOf, word } from '../../../solver/2d/body';
import { RigidTable } from '../../../solver/2d/rigid-table';
import { keyAt } from './sort-keys';

// Bodies that no contact moves do not meet, and sensors do not sense each other. What never moves senses what does, or may.
// @ts-ignore: decorator
@inline export function kindsMeet(a: u32, b: u32): bool {
  if (((a | b) & SENSOR) == 0) return ((a | b) & DYNAMIC) != 0;
  return ((a | b) & (MOVES | MAY_MOVE)) != 0 && (a & b & SENSOR) == 0;
}

// Two shapes of one group collide always if it is positive and never if it is negative. Otherwise they collide where each is
// on a layer of the other's mask. Walls are on all layers.
// @ts-ignore: decorator
@inline export function filtersMeet(t: RigidTable, a: i32, b: i32): bool {
  const flagsA = flagsOf(t, a);
  const flagsB = flagsOf(t, b);
  if (((flagsA | flagsB) & WALL) != 0) return true;
  if ((flagsA & flagsB & GROUPED) != 0) {
    const group = get(t.group, a);
    if (group == get(t.group, b)) return group > 0;
  }
  return layersMeet(t, a, b);
}

// @ts-ignore: decorator
@inline export function layersMeet(t: RigidTable, a: i32, b: i32): bool {
  return (word(t.layers, a) & word(t.masks, b)) != 0 && (word(t.layers, b) & word(t.masks, a)) != 0;
}

// Whether a joint keeps two bodies from colliding: a binary search.
export function areJoined(t: RigidTable, a: i32, b: i32): bool {
  if (t.jointPairCount == 0) return false;
  const key = keyOf(a, b);
  let low = 0;
  let high = t.jointPairCount;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (keyAt(t.jointPairs, middle) < key) low = middle + 1;
    else high = middle;
  }
  return low < t.jointPairCount && keyAt(t.jointPairs, low) == key;
}

// Sorts by the smaller id, then by the larger.
// @ts-ignore: decorator
@inline export function keyOf(a: i32, b: i32): u64 {
  return ((<u64>min<i32>(a, b)) << 32) | <u64>max<i32>(a, b);
}

// The smaller and the larger id of a key.
// @ts-ignore: decorator
@inline export function firstOf(key: u64): i32 {
  return <i32>(key >> 32);
}

// @ts-ignore: decorator
@inline export function secondOf(key: u64): i32 {
  return <i32>key;
}
