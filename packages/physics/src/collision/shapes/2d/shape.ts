import type { VectorInput } from '../../../errors/validate.ts';
import { markImmutable } from '../../../memory/resource.ts';
import { massProperties } from './mass-properties.ts';

/** Kinds of shapes, as kernels/collision/shapes/2d/shape.ts numbers them. */
export const ShapeKind = { circle: 0, capsule: 1, polygon: 2, segment: 3 } as const;

/**
 * A convex shape of two dimensions: all points within `radius` of a point, a segment or a polygon. It is an immutable
 * value that any number of bodies and worlds may use. Its frame is that of a body: the origin is its centroid.
 */
export interface Shape {
  readonly kind: keyof typeof ShapeKind;
  /** x and y of each vertex, m, anticlockwise: one of a circle, two of a capsule or a segment, up to eight of a polygon. */
  readonly vertices: readonly number[];
  /** x and y of the unit outward normal of the edge from each vertex to the next. */
  readonly normals: readonly number[];
  /** Radius of a circle or of the caps of a capsule, rounding of a polygon, m. */
  readonly radius: number;
  /** Area, m²; 0 for a segment. */
  readonly area: number;
  /** Moment of inertia about the centroid for each kilogram, m². */
  readonly inertiaPerMass: number;
  /** Greatest distance of the surface from the centroid, m. */
  readonly extent: number;
  /** Least distance of the surface from the centroid, m. */
  readonly minExtent: number;
  /** Of a segment of a chain: x and y of the far ends of its neighbours, the one before and the one after. */
  readonly neighbours?: readonly number[] | undefined;
  /** Centroid in the coordinates of the points that made the shape, m. */
  readonly centre: { readonly x: number; readonly y: number };
}

/** A point as shapes are made from. */
export type PointInput = Pick<VectorInput, 'x' | 'y'>;

const made = new WeakSet<object>();

/** Returns whether a value was made by `circle`, `box`, `capsule`, `polygon`, `segment` or `chain`. */
export function isShape(value: unknown): value is Shape {
  return typeof value === 'object' && value !== null && made.has(value);
}

/** Makes a shape of checked vertices, anticlockwise, and moves its centroid to the origin. */
export function makeShape(
  kind: Shape['kind'],
  points: readonly number[],
  radius: number,
  neighbours?: readonly number[],
): Shape {
  const normals = normalsOf(points);
  const { area, centreX, centreY, inertiaPerMass } = massProperties(points, normals, radius);
  const fromCentre = (value: number, i: number) => value - (i % 2 === 0 ? centreX : centreY);
  const vertices = points.map(fromCentre);
  const distances: number[] = [];
  for (let i = 0; i < vertices.length; i += 2) distances.push(lengthOf(vertices[i], vertices[i + 1]));
  const shape: Shape = {
    kind,
    vertices: Object.freeze(vertices),
    normals: Object.freeze(normals),
    radius,
    area,
    inertiaPerMass,
    extent: Math.max(...distances) + radius,
    minExtent: inradius(vertices, normals) + radius,
    neighbours: neighbours && Object.freeze(neighbours.map(fromCentre)),
    centre: Object.freeze({ x: centreX, y: centreY }),
  };
  made.add(shape);
  return markImmutable(Object.freeze(shape));
}

/** Length of a vector. */
export function lengthOf(x: number, y: number): number {
  return Math.sqrt(x * x + y * y);
}

/** A single point has no edge, and its normal is never read. */
function normalsOf(points: readonly number[]): number[] {
  const normals: number[] = [];
  const { length } = points;
  for (let i = 0; i < length && length > 2; i += 2) {
    const [dx, dy] = [points[(i + 2) % length] - points[i], points[(i + 3) % length] - points[i + 1]];
    const distance = lengthOf(dx, dy);
    // Subtracted from zero, because equal shapes must not differ by a zero with a sign.
    normals.push(dy / distance, (0 - dx) / distance);
  }
  return normals;
}

/** Distance of the nearest edge from the origin. */
function inradius(vertices: readonly number[], normals: readonly number[]): number {
  let least = normals.length === 0 ? 0 : Infinity;
  for (let i = 0; i < normals.length; i += 2) {
    least = Math.min(least, vertices[i] * normals[i] + vertices[i + 1] * normals[i + 1]);
  }
  return Math.max(0, least);
}
