// The states of the bodies of LANES contacts as vectors with a lane for each contact, and back. Four reals of a body are one
// vector in f32 and two in f64; turning four vectors (xpbd/packed-bodies.ts) is its own inverse.
import { transpose0, transpose1, transpose2, transpose3 } from '../../xpbd/packed-bodies';

// Byte offset of the second four reals of a body's state: distances moved.
export const MOVEMENT: usize = 4 * sizeof<real>();

// Address of the j-th of the four vectors at byte `offset` of the bodies that a list of addresses names.
// @ts-ignore: decorator
@inline function vectorAt(list: usize, offset: usize, j: i32): usize {
  if (sizeof<real>() == 4) return <usize>load<u32>(list + ((<usize>j) << 2)) + offset;
  return <usize>load<u32>(list + ((<usize>(j & 1)) << 2)) + offset + ((<usize>(j >> 1)) << 4);
}

@unmanaged
class Gathered {
  x: v128;
  y: v128;
  z: v128;
  w: v128;
}

// What `gather` read last.
export const gathered = changetype<Gathered>(memory.data(64, 16));

// @ts-ignore: decorator
@inline export function gather(list: usize, offset: usize): void {
  const a = v128.load(vectorAt(list, offset, 0));
  const b = v128.load(vectorAt(list, offset, 1));
  const c = v128.load(vectorAt(list, offset, 2));
  const d = v128.load(vectorAt(list, offset, 3));
  gathered.x = transpose0(a, b, c, d);
  gathered.y = transpose1(a, b, c, d);
  gathered.z = transpose2(a, b, c, d);
  gathered.w = transpose3(a, b, c, d);
}

// @ts-ignore: decorator
@inline export function scatter(list: usize, x: v128, y: v128, z: v128, w: v128): void {
  v128.store(vectorAt(list, 0, 0), transpose0(x, y, z, w));
  v128.store(vectorAt(list, 0, 1), transpose1(x, y, z, w));
  v128.store(vectorAt(list, 0, 2), transpose2(x, y, z, w));
  v128.store(vectorAt(list, 0, 3), transpose3(x, y, z, w));
}
