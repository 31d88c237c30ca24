// The contact of any two shapes. One order of kinds is implemented, with the disc last; the other is flipped.
import { CIRCLE, PLANE, POLYGON, Shape } from '../../shapes/2d/shape';
import { collideCapsuleCircle } from './capsule-circle';
import { collideChainSegment } from './chain-segment';
import { collideCircles } from './circle-circle';
import { Manifold, dropFar, swapShapes, toWorld } from './manifold';
import { collidePlane } from './plane-outline';
import { collidePolygonCircle } from './polygon-circle';
import { collidePolygons } from './polygon-polygon';

// Finds normal and points from the poses in the manifold.
export function collideShapes(m: Manifold, a: Shape, b: Shape): void {
  m.count = 0;
  m.edge = 0;
  m.corners = 0;
  m.room = 0;
  if ((a.isChained | b.isChained) != 0) {
    collideChained(m, a, b);
  } else if (b.kind == CIRCLE) {
    const dx = m.bx - m.ax;
    const dy = m.by - m.ay;
    collideWithCircle(m, a, b, m.ac * dx + m.as * dy, m.ac * dy - m.as * dx);
    toWorld(m, false);
  } else if (a.kind == CIRCLE) {
    const dx = m.ax - m.bx;
    const dy = m.ay - m.by;
    collideWithCircle(m, b, a, m.bc * dx + m.bs * dy, m.bc * dy - m.bs * dx);
    toWorld(m, true);
  } else {
    collidePolygons(m, a, b);
  }
  dropFar(m);
}

// Segments of chains do not meet each other, nor half-planes.
function collideChained(m: Manifold, a: Shape, b: Shape): void {
  if (a.kind == PLANE && b.isChained == 0) {
    collidePlane(m, a, b);
  } else if (b.kind == PLANE && a.isChained == 0) {
    swapShapes(m);
    collidePlane(m, b, a);
    swapShapes(m);
  } else if (b.isChained == 0) {
    collideChainSegment(m, a, b);
  } else if (a.isChained == 0) {
    swapShapes(m);
    collideChainSegment(m, b, a);
    swapShapes(m);
  }
}

// @ts-ignore: decorator
@inline function collideWithCircle(m: Manifold, shape: Shape, circle: Shape, x: real, y: real): void {
  if (shape.kind == CIRCLE) collideCircles(m, shape, circle, x, y);
  else if (shape.kind == POLYGON) collidePolygonCircle(m, shape, circle, x, y);
  else collideCapsuleCircle(m, shape, circle, x, y);
}

// For tests: the records of a manifold and of two shapes at these addresses.
export function collidePair(manifold: usize, a: usize, b: usize): void {
  collideShapes(changetype<Manifold>(manifold), changetype<Shape>(a), changetype<Shape>(b));
}
