import type { PointInput, Shape } from '../collision/shapes/2d/shape.ts';
import { checkNumber, checkVector } from '../errors/validate.ts';
import type { PhysicsWorld } from '../world/types.ts';
import {
  assertPlanar,
  checkFilter,
  confine,
  openQuery,
  type QueryFilter,
  type RunningQuery,
  readHit,
  setReach,
} from './body-query.ts';

/** Options of `nearestPoint`. */
export interface NearestPointOptions extends QueryFilter {
  /** Distance beyond which bodies are left out, m. Default Infinity. */
  readonly maxDistance?: number;
}

/** The nearest point of a body. */
export interface NearestPoint {
  /** Entity id. */
  readonly body: number;
  /** Distance from the point that was given, m; 0 inside the body. */
  readonly distance: number;
  /** Point of the body, m: the given one if that is inside. */
  readonly x: number;
  readonly y: number;
}

const POINT = { kind: 'circle', vertices: [0, 0], normals: [], radius: 0, area: 0, inertiaPerMass: 0 } as const;

/** A disc without radius, which no body may have. */
const POINT_SHAPE: Shape = { ...POINT, extent: 0, minExtent: 0, centre: { x: 0, y: 0 } };

/**
 * Returns the point of any body that is nearest to a point, and of equally near ones that of the smaller id. Bodies are
 * where they are now.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_UNKNOWN, E_RANGE (also in three dimensions), E_CAPACITY, E_DESTROYED
 */
export function nearestPoint(
  world: PhysicsWorld,
  point: PointInput,
  options: NearestPointOptions = {},
): NearestPoint | undefined {
  assertPlanar(world, 'nearestPoint');
  const { x, y } = checkVector(point, 'nearestPoint: point');
  checkFilter(options, 'nearestPoint', ['maxDistance']);
  const { maxDistance = Infinity } = options;
  const reach = maxDistance === Infinity ? Infinity : checkNumber(maxDistance, 'maxDistance', { min: 0 });
  const query = openQuery(world, { x, y, angle: 0, dx: 0, dy: 0 }, reach, options, POINT_SHAPE);
  for (const confined of query.trees === 0 ? [] : REACHES) {
    if (confined >= reach) break;
    confine(query, confined);
    const found = nearestOf(query, x, y);
    if (found !== undefined) return found;
  }
  if (query.trees !== 0) confine(query, reach);
  return nearestOf(query, x, y);
}

/** Distances up to which a tree is searched before a larger one is tried, m. */
const REACHES = [1, 8, 64, 512, 4096, 32768];

function nearestOf(query: RunningQuery, x: number, y: number): NearestPoint | undefined {
  const next = (row: number) => query.kernels.nextNearBody(query.at, query.shapeAt, row);
  let nearest: NearestPoint | undefined;
  for (let row = next(1); row > 0; row = next(row + 1)) {
    const hit = readHit(query, row);
    const distance = hit.fraction;
    if (nearest !== undefined && distance >= nearest.distance) continue;
    const isInside = distance === 0;
    nearest = { body: row, distance, x: isInside ? x : hit.x, y: isInside ? y : hit.y };
    setReach(query, distance);
  }
  return nearest;
}
