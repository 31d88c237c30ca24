import type { PointInput, Shape } from '../collision/shapes/2d/shape.ts';
import { checkNumber, checkPoint } from '../errors/validate.ts';
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
  visitBodies,
} from './body-query.ts';
import { visitWalls } from './walls.ts';

/** Options of `nearestPoint`. */
export interface NearestPointOptions extends QueryFilter {
  /** Distance beyond which bodies and walls are left out, m. Default Infinity. */
  readonly maxDistance?: number;
}

/** The nearest point of a body or of a wall. What wants a place takes it as it is, as it does a `Hit`. */
export interface NearestPoint {
  /** Entity id of the body or the wall; 0 for a wall of `boxWalls` that is no entity, as in `wallContacts`. */
  readonly body: number;
  /** Whether it is a wall. */
  readonly isWall: boolean;
  /** Distance from the point that was given, m; 0 inside. */
  readonly distance: number;
  /** Point of the body or the wall, m: the given one if that is inside. */
  readonly x: number;
  readonly y: number;
}

const POINT = { kind: 'circle', vertices: [0, 0], normals: [], radius: 0, area: 0, inertiaPerMass: 0 } as const;

/** A disc without radius, which no body may have. */
const POINT_SHAPE: Shape = { ...POINT, extent: 0, minExtent: 0, centre: { x: 0, y: 0 } };

/**
 * Returns the point of any body or wall that is nearest to a point, and of equally near ones that of the smaller id. Bodies
 * are where they are now.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_UNKNOWN, E_RANGE (also in three dimensions), E_CAPACITY, E_DESTROYED
 */
export function nearestPoint(
  world: PhysicsWorld,
  point: PointInput,
  options: NearestPointOptions = {},
): NearestPoint | undefined {
  assertPlanar(world, 'nearestPoint');
  const { x, y } = checkPoint(point, 'nearestPoint: point');
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
  const { kernels, at, shapeAt } = query;
  const next = (row: number) => kernels.nextNearBody(at, shapeAt, row);
  let nearest: NearestPoint | undefined;
  const consider = (body: number, isWall: boolean) => {
    const hit = readHit(query, body, isWall);
    const distance = hit.fraction;
    if (
      nearest !== undefined &&
      (distance > nearest.distance || (distance === nearest.distance && body >= nearest.body))
    )
      return;
    const isInside = distance === 0;
    nearest = { body, isWall, distance, x: isInside ? x : hit.x, y: isInside ? y : hit.y };
    setReach(query, distance);
  };
  visitBodies(query, next, (row) => consider(row, false));
  visitWalls(query, (id) => {
    if (kernels.isNearWall(at, shapeAt) === 1) consider(id, true);
  });
  return nearest;
}
