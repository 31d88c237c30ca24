// Transposes between four reals of each of LANES bodies and four vectors with one lane per body.
//
// In f32 each of four bodies is one vector. In f64 each of two bodies is two vectors; all first halves precede the
// second halves. In both cases the transposition maps four vectors to four vectors and is its own inverse.

@unmanaged
class Transposed {
  q0: v128;
  q1: v128;
  q2: v128;
  q3: v128;
}

// Results of the transposition.
export const transposed = changetype<Transposed>(memory.data(64, 16));

// Address of vector j; `list` holds the addresses of the bodies.
// @ts-ignore: decorator
@inline function vectorAt(list: usize, j: i32): usize {
  if (sizeof<real>() == 4) return load<u32>(list + ((<usize>j) << 2));
  return load<u32>(list + ((<usize>(j & 1)) << 2)) + ((<usize>(j >> 1)) << 4);
}

// Loads the four reals at byte `offset` of each body.
// @ts-ignore: decorator
@inline export function readTransposed(list: usize, offset: usize): void {
  transpose(
    v128.load(vectorAt(list, 0) + offset),
    v128.load(vectorAt(list, 1) + offset),
    v128.load(vectorAt(list, 2) + offset),
    v128.load(vectorAt(list, 3) + offset),
  );
}

// @ts-ignore: decorator
@inline export function writeTransposed(list: usize, offset: usize, x: v128, y: v128, z: v128, w: v128): void {
  transpose(x, y, z, w);
  v128.store(vectorAt(list, 0) + offset, transposed.q0);
  v128.store(vectorAt(list, 1) + offset, transposed.q1);
  v128.store(vectorAt(list, 2) + offset, transposed.q2);
  v128.store(vectorAt(list, 3) + offset, transposed.q3);
}

// @ts-ignore: decorator
@inline function transpose(e0: v128, e1: v128, e2: v128, e3: v128): void {
  if (sizeof<real>() == 8) {
    transposed.q0 = i64x2.shuffle(e0, e1, 0, 2);
    transposed.q1 = i64x2.shuffle(e0, e1, 1, 3);
    transposed.q2 = i64x2.shuffle(e2, e3, 0, 2);
    transposed.q3 = i64x2.shuffle(e2, e3, 1, 3);
    return;
  }
  const low01 = i32x4.shuffle(e0, e1, 0, 4, 1, 5);
  const low23 = i32x4.shuffle(e2, e3, 0, 4, 1, 5);
  const high01 = i32x4.shuffle(e0, e1, 2, 6, 3, 7);
  const high23 = i32x4.shuffle(e2, e3, 2, 6, 3, 7);
  transposed.q0 = i64x2.shuffle(low01, low23, 0, 2);
  transposed.q1 = i64x2.shuffle(low01, low23, 1, 3);
  transposed.q2 = i64x2.shuffle(high01, high23, 0, 2);
  transposed.q3 = i64x2.shuffle(high01, high23, 1, 3);
}
