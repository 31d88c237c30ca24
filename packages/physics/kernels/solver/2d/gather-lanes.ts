// The states of the bodies of LANES contacts as vectors with a lane for each contact, and back. Four reals of a body are one
// vector in f32 and two in f64; turning four vectors (xpbd/packed-bodies.ts) is its own inverse. What several of these functions
// read is loaded once: the compiler sees that nothing is stored in between.
import { transpose0, transpose1, transpose2, transpose3 } from '../../xpbd/packed-bodies';

// Byte offset of the second four reals of a body's state: distances moved.
export const MOVEMENT: usize = 4 * sizeof<real>();

// Address of the j-th of the four vectors at byte `offset` of the bodies that a list of addresses names.
// @ts-ignore: decorator
@inline function vectorAt(list: usize, offset: usize, j: i32): usize {
  if (sizeof<real>() == 4) return <usize>load<u32>(list + ((<usize>j) << 2)) + offset;
  return <usize>load<u32>(list + ((<usize>(j & 1)) << 2)) + offset + ((<usize>(j >> 1)) << 4);
}

// The k-th of the four reals of each body.
// @ts-ignore: decorator
@inline function component(list: usize, offset: usize, k: i32): v128 {
  const a = v128.load(vectorAt(list, offset, 0));
  const b = v128.load(vectorAt(list, offset, 1));
  const c = v128.load(vectorAt(list, offset, 2));
  const d = v128.load(vectorAt(list, offset, 3));
  if (k == 0) return transpose0(a, b, c, d);
  if (k == 1) return transpose1(a, b, c, d);
  return k == 2 ? transpose2(a, b, c, d) : transpose3(a, b, c, d);
}

// @ts-ignore: decorator
@inline export function lanesX(list: usize, offset: usize): v128 {
  return component(list, offset, 0);
}

// @ts-ignore: decorator
@inline export function lanesY(list: usize, offset: usize): v128 {
  return component(list, offset, 1);
}

// @ts-ignore: decorator
@inline export function lanesZ(list: usize, offset: usize): v128 {
  return component(list, offset, 2);
}

// @ts-ignore: decorator
@inline export function lanesW(list: usize, offset: usize): v128 {
  return component(list, offset, 3);
}

// @ts-ignore: decorator
@inline export function scatter(list: usize, x: v128, y: v128, z: v128, w: v128): void {
  v128.store(vectorAt(list, 0, 0), transpose0(x, y, z, w));
  v128.store(vectorAt(list, 0, 1), transpose1(x, y, z, w));
  v128.store(vectorAt(list, 0, 2), transpose2(x, y, z, w));
  v128.store(vectorAt(list, 0, 3), transpose3(x, y, z, w));
}
