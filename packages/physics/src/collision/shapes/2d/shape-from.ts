import { isRecord, mustBe } from '../../../errors/validate.ts';
import { adoptShape } from '../store-shape.ts';
import { capsule } from './capsule.ts';
import { chain } from './chain.ts';
import { circle } from './circle.ts';
import { checkPoint } from './convex-outline.ts';
import { polygon } from './polygon.ts';
import { segment } from './segment.ts';
import { lengthOf, type PointInput, type Shape } from './shape.ts';

/** What of a shape says all, and what follows from it. */
export type ShapeRecord = Pick<Shape, 'kind' | 'vertices' | 'radius' | 'neighbours'> & Partial<Shape>;

/** What follows from the vertices, and the vertices, which are counted from their centroid. */
const LENGTHS = ['vertices', 'radius', 'extent', 'minExtent', 'neighbours'] as const;

/** Far above the rounding of a double, and no more than that of an f32. */
const ROUNDING = 1e-7;

/**
 * Makes a shape of what JSON or a structured clone keeps of one, also of a segment of a chain: the same to the last bit. Where the
 * record has only kind, vertices, radius and neighbours, or where they were changed, the rest is computed anew. A record without
 * `centre` has that of its vertices.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE for what no shape says of itself
 */
export function shapeFrom(record: ShapeRecord): Shape {
  if (!isRecord(record)) throw mustBe('what JSON keeps of a shape', record, 'shapeFrom');
  const made = computed(record);
  // Of an older place, to which the vertices were moved by `made.centre` once more.
  const { x, y } = record.centre === undefined ? { x: 0, y: 0 } : checkPoint(record.centre, 'shapeFrom: centre');
  if (!saysTheSame(record, made))
    return adoptShape({ ...made, centre: { x: x + made.centre.x, y: y + made.centre.y } });
  const { kind, vertices, normals, radius, area, inertiaPerMass, extent, minExtent, neighbours } = record;
  return adoptShape({
    kind,
    vertices: [...vertices],
    normals: [...normals],
    radius,
    area,
    inertiaPerMass,
    extent,
    minExtent,
    neighbours: neighbours && [...neighbours],
    centre: { x, y },
  });
}

/** Whether a record has all numbers of a shape, but for rounding: then those of the record are the ones that it came from. */
function saysTheSame(record: ShapeRecord, made: Shape): record is Shape {
  const { extent, area, inertiaPerMass } = made;
  const isNear = (a: unknown, b: unknown, scale: number): boolean => {
    if (typeof b === 'number') return typeof a === 'number' && Math.abs(a - b) <= ROUNDING * scale;
    if (!Array.isArray(b)) return a === b;
    return Array.isArray(a) && a.length === b.length && b.every((value, i) => isNear(a[i], value, scale));
  };
  return (
    LENGTHS.every((name) => isNear(record[name], made[name], extent)) &&
    isNear(record.normals, made.normals, 1) &&
    isNear(record.area, area, area) &&
    isNear(record.inertiaPerMass, inertiaPerMass, inertiaPerMass)
  );
}

/** The shape that kind, vertices, radius and neighbours say. */
function computed({ kind, radius, neighbours, vertices }: ShapeRecord): Shape {
  const points = pointsOf(vertices, 'vertices');
  const count = points.length;
  if (kind === 'circle') return circle(radius);
  if (kind === 'polygon') return polygon(points, { rounding: radius });
  if ((kind === 'capsule' || kind === 'segment') && count !== 2)
    throw mustBe('x and y of two points', vertices, 'shapeFrom: vertices', 'E_RANGE');
  if (kind === 'capsule') return capsule(distance(points[0], points[1]), radius);
  if (kind !== 'segment') throw mustBe("'circle', 'capsule', 'polygon' or 'segment'", kind, 'shapeFrom: kind');
  if (neighbours === undefined) return segment(points[0], points[1]);
  const [before, after] = pointsOf(neighbours, 'neighbours');
  return chain([before, ...points, after])[1];
}

function pointsOf(coordinates: unknown, field: string): Required<PointInput>[] {
  if (!Array.isArray(coordinates)) throw mustBe('an array of numbers', coordinates, `shapeFrom: ${field}`);
  return Array.from({ length: coordinates.length >> 1 }, (_, i) => {
    return { x: coordinates[2 * i], y: coordinates[2 * i + 1] };
  });
}

function distance(a: Required<PointInput>, b: Required<PointInput>): number {
  return lengthOf(b.x - a.x, b.y - a.y);
}
