// Symmetric 3 x 3 matrices of the chain solvers.

// A symmetric matrix, laid out as in the nodes.
@unmanaged
export class Symmetric {
  xx: f64;
  xy: f64;
  xz: f64;
  yy: f64;
  yz: f64;
  zz: f64;
}

// Inverts a positive definite matrix by its factors L D L'. If one direction is 1e9 times as stiff as the others, the
// determinant of the cofactor formula would be rounding error only.
// @ts-ignore: decorator
@inline export function invert(to: Symmetric, xx: f64, xy: f64, xz: f64, yy: f64, yz: f64, zz: f64): void {
  const a = 1 / xx;
  const yx = xy * a;
  const zx = xz * a;
  const b = 1 / (yy - yx * xy);
  const reducedZy = yz - zx * xy;
  const zy = reducedZy * b;
  const c = 1 / (zz - zx * xz - zy * reducedZy);
  const back = yx * zy - zx;
  to.zz = c;
  to.yz = -zy * c;
  to.yy = b + zy * zy * c;
  to.xz = back * c;
  to.xy = -yx * b - back * zy * c;
  to.xx = a + yx * yx * b + back * back * c;
}
