import type { PointInput } from '../collision/shapes/2d/shape.ts';
import { checkKeys, checkPoint, mustBe } from '../errors/validate.ts';
import { placeParts } from '../solver/refresh-parts.ts';
import type { PhysicsWorld } from '../world/types.ts';
import {
  allHits,
  assertPlanar,
  checkFilter,
  firstHit,
  type Hit,
  openQuery,
  type Probe,
  type QueryFilter,
  type RunningQuery,
  treesOf,
} from './body-query.ts';

/**
 * Returns the first body or wall that a ray enters, and where. A ray that starts inside one does not enter it; a segment or a chain is
 * met from both sides. Bodies with a collider are met where they are now; those far from the ray cost little where trees find them.
 * @param from start of the ray, m
 * @param to end of the ray, m
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_UNKNOWN, E_RANGE (also in three dimensions), E_CAPACITY, E_DESTROYED
 */
export function rayCast(
  world: PhysicsWorld,
  from: PointInput,
  to: PointInput,
  filter: QueryFilter = {},
): Hit | undefined {
  const query = openRay(world, from, to, filter, 'rayCast');
  return firstHit(query, rayProbe(query));
}

/**
 * Returns all bodies and walls that a ray enters, the nearest to its start first; otherwise as `rayCast`.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_UNKNOWN, E_RANGE (also in three dimensions), E_CAPACITY, E_DESTROYED
 */
export function rayCastAll(world: PhysicsWorld, from: PointInput, to: PointInput, filter: QueryFilter = {}): Hit[] {
  const query = openRay(world, from, to, filter, 'rayCastAll');
  return allHits(query, rayProbe(query));
}

/** A ray of `rayCastMany`. */
export interface Ray {
  /** Its start, m. */
  readonly from: PointInput;
  /** Its end, m. */
  readonly to: PointInput;
}

/**
 * Returns what `rayCast` returns for each of many rays. Between two queries anything may have been written to the columns, and each looks
 * whether it was, which in a world of 60 000 bodies takes longer than a ray does. Many rays look once.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_UNKNOWN, E_RANGE (also in three dimensions), E_CAPACITY, E_DESTROYED
 */
export function rayCastMany(world: PhysicsWorld, rays: readonly Ray[], filter: QueryFilter = {}): (Hit | undefined)[] {
  assertPlanar(world, 'rayCastMany');
  if (!Array.isArray(rays)) throw mustBe('an array of { from, to }', rays, 'rayCastMany: rays');
  placeParts(world);
  const trees = treesOf(world, rays.length);
  return rays.map((ray, i) => {
    const name = `rayCastMany: rays[${i}]`;
    checkKeys(ray, name, ['from', 'to'], 'field');
    const query = openRay(world, ray.from, ray.to, filter, name, trees);
    return firstHit(query, rayProbe(query));
  });
}

const rayProbe = ({ kernels, at }: RunningQuery): Probe => ({
  next: (row) => kernels.nextRayHit(at, row),
  meetsWall: () => kernels.rayMeetsWall(at),
});

function openRay(
  world: PhysicsWorld,
  from: PointInput,
  to: PointInput,
  filter: QueryFilter,
  caller: string,
  trees?: number,
): RunningQuery {
  assertPlanar(world, caller);
  const start = checkPoint(from, `${caller}: from`);
  const end = checkPoint(to, `${caller}: to`);
  checkFilter(filter, caller);
  const path = { x: start.x, y: start.y, angle: 0, dx: end.x - start.x, dy: end.y - start.y };
  return openQuery(world, path, 0, filter, undefined, trees);
}
