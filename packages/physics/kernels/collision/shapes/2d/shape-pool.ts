// The shapes of a world, by the index that `Collider.shape` holds.
import { columns, get } from '../../../memory/columns';
import { SHAPE_BYTES, Shape } from './shape';

// The record of a shape of the pool.
// @ts-ignore: decorator
@inline export function poolShape(index: u32): Shape {
  return changetype<Shape>(columns().shapes + <usize>index * SHAPE_BYTES);
}

// Fills a record with a circle, for colliders that are only a radius.
export function makeCircle(into: Shape, radius: real): void {
  into.kind = 0;
  into.count = 1;
  into.radius = radius;
  into.area = <real>3.141592653589793 * radius * radius;
  into.inertiaPerMass = <real>0.5 * radius * radius;
  into.extent = radius;
  into.minExtent = radius;
  into.x0 = 0;
  into.y0 = 0;
}

// The radius by which the shape of a body is rounded.
// @ts-ignore: decorator
@inline export function roundingOf(row: i32): real {
  const c = columns();
  const index = load<u32>(c.shape + ((<usize>row) << 2));
  return index > 0 && index < <u32>c.shapeCount ? poolShape(index).radius : get(c.radius, row);
}

// The greatest distance of the surface of a body's shape from its position. It is not `Collider.radius` for all of them:
// anything may have been written there beside a shape.
// @ts-ignore: decorator
@inline export function extentOf(row: i32): real {
  const c = columns();
  const index = load<u32>(c.shape + ((<usize>row) << 2));
  return index > 0 && index < <u32>c.shapeCount ? poolShape(index).extent : get(c.radius, row);
}

// The shape of a body. Where the column names no shape of the pool it is the circle of `Collider.radius`, which is then
// written to `spare`.
// @ts-ignore: decorator
@inline export function shapeOf(row: i32, spare: Shape): Shape {
  const c = columns();
  const index = load<u32>(c.shape + ((<usize>row) << 2));
  if (index > 0 && index < <u32>c.shapeCount) return poolShape(index);
  makeCircle(spare, get(c.radius, row));
  return spare;
}
