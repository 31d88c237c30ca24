// What the narrow phase reads, the poses of two shapes, and what it finds.
@unmanaged
export class Manifold {
  ax: real;
  ay: real;
  ac: real;
  as: real;
  bx: real;
  by: real;
  bc: real;
  bs: real;
  speculative: real;
  nx: real;
  ny: real;
  x0: real;
  y0: real;
  separation0: real;
  x1: real;
  y1: real;
  separation1: real;
  count: i32;
  id0: u32;
  id1: u32;
}
