/** Rotations as matrices of three rows. */
import { cos, sin } from '@principia/physics';
import { cross, dot, type Point3, point } from './space.ts';

export type Matrix = readonly [Point3, Point3, Point3];

export const apply = (m: Matrix, v: Point3): Point3 => point(dot(m[0], v), dot(m[1], v), dot(m[2], v));

/** The rotation by an angle, rad, about an axis of the world. */
export function rotationMatrix(axis: 'x' | 'y' | 'z', angle: number): Matrix {
  const [c, s] = [cos(angle), sin(angle)];
  if (axis === 'x') return [point(1, 0, 0), point(0, c, -s), point(0, s, c)];
  if (axis === 'y') return [point(c, 0, s), point(0, 1, 0), point(-s, 0, c)];
  return [point(c, -s, 0), point(s, c, 0), point(0, 0, 1)];
}

const column = (m: Matrix, axis: 'x' | 'y' | 'z') => point(m[0][axis], m[1][axis], m[2][axis]);

/** The product a b, which is the rotation b followed by a. */
export function multiply(a: Matrix, b: Matrix): Matrix {
  const columns = [column(b, 'x'), column(b, 'y'), column(b, 'z')];
  const row = (of: Point3) => point(dot(of, columns[0]), dot(of, columns[1]), dot(of, columns[2]));
  return [row(a[0]), row(a[1]), row(a[2])];
}

export const determinant = ([a, b, c]: Matrix): number => dot(a, cross(b, c));

/** Largest difference of the elements of two matrices. */
export function difference(a: Matrix, b: Matrix): number {
  return Math.max(...a.flatMap((row, i) => [row.x - b[i].x, row.y - b[i].y, row.z - b[i].z].map(Math.abs)));
}

/** Largest difference of Rᵀ R from 1: the columns of a rotation have the length 1 and right angles between them. */
export function orthogonalityError(m: Matrix): number {
  const columns: Matrix = [column(m, 'x'), column(m, 'y'), column(m, 'z')];
  return difference(multiply(columns, m), [point(1, 0, 0), point(0, 1, 0), point(0, 0, 1)]);
}
