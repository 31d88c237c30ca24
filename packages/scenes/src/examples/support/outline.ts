/** The corners of a body with a shape, and the lines between points that move. */
import { cos, type PhysicsWorld, shapeAt, sin } from '@principia/physics';
import type { Color, Dot, Line, Point } from '../picture.ts';
import { positionOf } from './read.ts';

/** Where a point of a body is: given in the frame of the body. */
export function placeOn(world: PhysicsWorld, body: number, point: Point): Required<Point> {
  const [{ x, y }, angle] = [positionOf(world, body), world.components.Rotation.angle[body]];
  const [c, s] = [cos(angle), sin(angle)];
  return { x: x + c * point.x - s * point.y, y: y + s * point.x + c * point.y, z: 0 };
}

/** The corners of a polygon, as they are now. */
export function cornersOf(world: PhysicsWorld, body: number): Required<Point>[] {
  const vertices = shapeAt(world, world.components.Collider.shape[body])?.vertices ?? [];
  return Array.from({ length: vertices.length / 2 }, (_, i) =>
    placeOn(world, body, { x: vertices[2 * i], y: vertices[2 * i + 1] }),
  );
}

/** Area of a polygon, by the shoelace formula. */
export function areaOf(corners: readonly Point[]): number {
  let sum = 0;
  corners.forEach(({ x, y }, i) => {
    const next = corners[(i + 1) % corners.length];
    sum += x * next.y - y * next.x;
  });
  return Math.abs(sum) / 2;
}

/** Lines from the middle of a body to the given points of it, such as spokes and blades. */
export function spokes(world: PhysicsWorld, body: number, points: readonly Point[], line: Partial<Line>): Line[] {
  return points.map((point) => ({
    ...line,
    from: () => positionOf(world, body),
    to: () => placeOn(world, body, point),
  }));
}

/** Dots on a body that show how it turns. */
export function marks(world: PhysicsWorld, body: number, points: readonly Point[], color: Color): Dot[] {
  return points.map((point) => ({ at: () => placeOn(world, body, point), radius: 3, color }));
}

/** Points on a circle about the origin, at equal angles from the given one on, rad. */
export function star(count: number, radius: number, from = 0): Point[] {
  return Array.from({ length: count }, (_, i) => ({
    x: radius * cos(from + (2 * Math.PI * i) / count),
    y: radius * sin(from + (2 * Math.PI * i) / count),
  }));
}
