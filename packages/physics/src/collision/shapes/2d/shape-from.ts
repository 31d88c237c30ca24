import { isRecord, mustBe } from '../../../errors/validate.ts';
import { capsule } from './capsule.ts';
import { chain } from './chain.ts';
import { circle } from './circle.ts';
import { polygon } from './polygon.ts';
import { segment } from './segment.ts';
import { lengthOf, type PointInput, type Shape } from './shape.ts';

/** What of a shape says all: the rest follows from it. */
export type ShapeRecord = Pick<Shape, 'kind' | 'vertices' | 'radius' | 'neighbours'>;

/**
 * Makes a shape of what JSON or a structured clone keeps of one, also of a segment of a chain. Other fields of the record are not read. Its
 * `centre` is the origin, because that is where the vertices of a shape are counted from.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE for what no shape says of itself
 */
export function shapeFrom(record: ShapeRecord): Shape {
  if (!isRecord(record)) throw mustBe('what JSON keeps of a shape', record, 'shapeFrom');
  const { kind, radius, neighbours } = record;
  const points = pointsOf(record.vertices, 'vertices');
  const count = points.length;
  if (kind === 'circle') return circle(radius);
  if (kind === 'polygon') return polygon(points, { rounding: radius });
  if ((kind === 'capsule' || kind === 'segment') && count !== 2)
    throw mustBe('x and y of two points', record.vertices, 'shapeFrom: vertices', 'E_RANGE');
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
