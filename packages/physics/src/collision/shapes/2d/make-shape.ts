import { adoptShape } from '../store-shape.ts';
import { massProperties } from './mass-properties.ts';
import { lengthOf, type Shape } from './shape.ts';

/** Makes a shape of checked vertices, anticlockwise, and moves its centroid to the origin. */
export function makeShape(
  kind: Shape['kind'],
  points: readonly number[],
  radius: number,
  neighbours?: readonly number[],
): Shape {
  const normals = normalsOf(points);
  const { area, centreX, centreY, inertiaPerMass } = massProperties(points, normals, radius);
  // Added to zero, because JSON does not keep the sign of a zero.
  const fromCentre = (value: number, i: number) => 0 + value - (i % 2 === 0 ? centreX : centreY);
  const vertices = points.map(fromCentre);
  const distances: number[] = [];
  for (let i = 0; i < vertices.length; i += 2) distances.push(lengthOf(vertices[i], vertices[i + 1]));
  return adoptShape({
    kind,
    vertices,
    normals,
    radius,
    area,
    inertiaPerMass,
    extent: Math.max(...distances) + radius,
    minExtent: inradius(vertices, normals) + radius,
    neighbours: neighbours?.map(fromCentre),
    centre: { x: centreX, y: centreY },
  });
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
