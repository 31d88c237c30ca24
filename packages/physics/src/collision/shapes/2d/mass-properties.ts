// Area, centroid and moment of inertia of a convex polygon whose outline is moved outward by a radius. The area is cut
// into the polygon, a rectangle on each edge and a sector at each vertex, so that the sums are exact. Source of the
// polygon's integrals: Green's theorem, as in Steger, On the calculation of arbitrary moments of polygons (1996).
import { atan2 } from '../../../math/elementary.ts';

/** What follows from a shape of uniform density. */
export interface MassProperties {
  /** m². */
  readonly area: number;
  readonly centreX: number;
  readonly centreY: number;
  /** About the centroid, m². */
  readonly inertiaPerMass: number;
}

/** Area, its first moments, and its polar second moment, about the origin. */
interface Moments {
  area: number;
  x: number;
  y: number;
  polar: number;
}

/**
 * Computes the properties of a polygon of three or more vertices, of a segment of two, or of one point, all rounded by
 * `radius`. A segment without radius counts as a thin rod.
 * @param points x and y of each vertex, anticlockwise
 * @param normals x and y of each edge's unit outward normal
 */
export function massProperties(points: readonly number[], normals: readonly number[], radius: number): MassProperties {
  const count = points.length / 2;
  // Sums about a point inside lose fewer digits when the outline is far from the origin.
  const meanX = sumOfAxis(points, 0) / count;
  const meanY = sumOfAxis(points, 1) / count;
  const local = points.map((value, i) => value - (i % 2 === 0 ? meanX : meanY));
  if (count === 1) {
    return { area: Math.PI * radius * radius, centreX: meanX, centreY: meanY, inertiaPerMass: (radius * radius) / 2 };
  }
  if (count === 2 && radius === 0) {
    const [halfX, halfY] = local;
    return { area: 0, centreX: meanX, centreY: meanY, inertiaPerMass: (halfX * halfX + halfY * halfY) / 3 };
  }
  const sum: Moments = { area: 0, x: 0, y: 0, polar: 0 };
  for (let i = 0; i < local.length; i += 2) {
    const next = (i + 2) % local.length;
    addTriangle(sum, local[i], local[i + 1], local[next], local[next + 1]);
    if (radius === 0) continue;
    addRectangle(sum, local, i, next, normals, radius);
    addSector(sum, local, next, normals, i, radius);
  }
  const [x, y] = [sum.x / sum.area, sum.y / sum.area];
  const inertiaPerMass = sum.polar / sum.area - (x * x + y * y);
  return { area: sum.area, centreX: meanX + x, centreY: meanY + y, inertiaPerMass };
}

function sumOfAxis(points: readonly number[], axis: 0 | 1): number {
  return points.reduce((sum, value, i) => (i % 2 === axis ? sum + value : sum), 0);
}

/** The triangle between the origin and an edge, of negative area where the edge runs clockwise. */
function addTriangle(sum: Moments, ax: number, ay: number, bx: number, by: number): void {
  const area = 0.5 * (ax * by - ay * bx);
  sum.area += area;
  sum.x += (area * (ax + bx)) / 3;
  sum.y += (area * (ay + by)) / 3;
  sum.polar += (area * (ax * ax + ax * bx + bx * bx + ay * ay + ay * by + by * by)) / 6;
}

/** The strip of width `radius` on the outside of an edge. */
function addRectangle(
  sum: Moments,
  points: readonly number[],
  from: number,
  to: number,
  normals: readonly number[],
  radius: number,
): void {
  const [dx, dy] = [points[to] - points[from], points[to + 1] - points[from + 1]];
  const lengthSquared = dx * dx + dy * dy;
  const area = Math.sqrt(lengthSquared) * radius;
  const x = points[from] + 0.5 * (dx + radius * normals[from]);
  const y = points[from + 1] + 0.5 * (dy + radius * normals[from + 1]);
  sum.area += area;
  sum.x += area * x;
  sum.y += area * y;
  sum.polar += area * ((lengthSquared + radius * radius) / 12 + x * x + y * y);
}

/** The sector about a vertex between the normals of the edge before it and of the edge that begins there. */
function addSector(
  sum: Moments,
  points: readonly number[],
  at: number,
  normals: readonly number[],
  edge: number,
  radius: number,
): void {
  const [nx, ny, mx, my] = [normals[edge], normals[edge + 1], normals[at], normals[at + 1]];
  // The outline turns left; the sign is dropped because a zero with a minus would give -π at the ends of a capsule.
  const angle = atan2(Math.abs(nx * my - ny * mx), nx * mx + ny * my);
  const [x, y] = [points[at], points[at + 1]];
  const area = 0.5 * angle * radius * radius;
  // First moments about the vertex: the integral of the direction over the angle, times radius³/3.
  const cubed = (radius * radius * radius) / 3;
  const [ownX, ownY] = [cubed * (my - ny), cubed * (nx - mx)];
  sum.area += area;
  sum.x += area * x + ownX;
  sum.y += area * y + ownY;
  sum.polar += 0.5 * area * radius * radius + 2 * (x * ownX + y * ownY) + area * (x * x + y * y);
}
