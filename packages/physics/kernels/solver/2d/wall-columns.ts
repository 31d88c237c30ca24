// Addresses of the columns of walls.
@unmanaged
export class WallColumns {
  ax: usize;
  ay: usize;
  bx: usize;
  by: usize;
  segmentRestitution: usize;
  segmentFriction: usize;
  nx: usize;
  ny: usize;
  offset: usize;
  planeRestitution: usize;
  planeFriction: usize;
}
