// Four reals of each of LANES bodies as four vectors with a lane for each body, and back: a transposition.
//
// In f32 four bodies have one vector each. In f64 two bodies have two vectors each: first their first halves, then their
// second. Either way four vectors go in, four come out, and going back is the same.

@unmanaged
class Quads {
  q0: v128;
  q1: v128;
  q2: v128;
  q3: v128;
}

// What was read.
export const quads = changetype<Quads>(memory.data(64, 16));

// Address of vector j, where `list` holds the addresses of the bodies.
// @ts-ignore: decorator
@inline function quadAt(list: usize, j: i32): usize {
  if (sizeof<real>() == 4) return load<u32>(list + ((<usize>j) << 2));
  return load<u32>(list + ((<usize>(j & 1)) << 2)) + ((<usize>(j >> 1)) << 4);
}

// Reads the reals that lie `offset` bytes into the bodies.
// @ts-ignore: decorator
@inline export function readQuads(list: usize, offset: usize): void {
  transpose(
    v128.load(quadAt(list, 0) + offset),
    v128.load(quadAt(list, 1) + offset),
    v128.load(quadAt(list, 2) + offset),
    v128.load(quadAt(list, 3) + offset),
  );
}

// @ts-ignore: decorator
@inline export function writeQuads(list: usize, offset: usize, x: v128, y: v128, z: v128, w: v128): void {
  transpose(x, y, z, w);
  v128.store(quadAt(list, 0) + offset, quads.q0);
  v128.store(quadAt(list, 1) + offset, quads.q1);
  v128.store(quadAt(list, 2) + offset, quads.q2);
  v128.store(quadAt(list, 3) + offset, quads.q3);
}

// @ts-ignore: decorator
@inline function transpose(e0: v128, e1: v128, e2: v128, e3: v128): void {
  if (sizeof<real>() == 8) {
    quads.q0 = i64x2.shuffle(e0, e1, 0, 2);
    quads.q1 = i64x2.shuffle(e0, e1, 1, 3);
    quads.q2 = i64x2.shuffle(e2, e3, 0, 2);
    quads.q3 = i64x2.shuffle(e2, e3, 1, 3);
    return;
  }
  const low01 = i32x4.shuffle(e0, e1, 0, 4, 1, 5);
  const low23 = i32x4.shuffle(e2, e3, 0, 4, 1, 5);
  const high01 = i32x4.shuffle(e0, e1, 2, 6, 3, 7);
  const high23 = i32x4.shuffle(e2, e3, 2, 6, 3, 7);
  quads.q0 = i64x2.shuffle(low01, low23, 0, 2);
  quads.q1 = i64x2.shuffle(low01, low23, 1, 3);
  quads.q2 = i64x2.shuffle(high01, high23, 0, 2);
  quads.q3 = i64x2.shuffle(high01, high23, 1, 3);
}
