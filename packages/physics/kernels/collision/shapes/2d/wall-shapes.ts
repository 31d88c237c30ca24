// The shapes of walls: a segment about its middle and a half-plane at its edge.
import { PLANE, SEGMENT, Shape } from './shape';

// From (-halfX, -halfY) to (halfX, halfY); half is the length of that.
export function makeSegment(shape: Shape, halfX: real, halfY: real, half: real): void {
  shape.kind = SEGMENT;
  shape.count = 2;
  shape.extent = half;
  shape.x0 = -halfX;
  shape.y0 = -halfY;
  shape.x1 = halfX;
  shape.y1 = halfY;
  shape.nx0 = halfY / half;
  shape.ny0 = -halfX / half;
  shape.nx1 = -shape.nx0;
  shape.ny1 = -shape.ny0;
}

// Solid behind the origin, where n·x < 0.
export function makePlane(shape: Shape, nx: real, ny: real): void {
  shape.kind = PLANE;
  shape.count = 1;
  shape.extent = 0;
  shape.x0 = 0;
  shape.y0 = 0;
  shape.nx0 = nx;
  shape.ny0 = ny;
}
