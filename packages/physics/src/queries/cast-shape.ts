import { checkShape } from '../bodies/collider-shape.ts';
import type { PointInput, Shape } from '../collision/shapes/2d/shape.ts';
import { checkVector } from '../errors/validate.ts';
import type { PhysicsWorld } from '../world/types.ts';
import {
  allHits,
  assertPlanar,
  checkFilter,
  checkPose,
  firstHit,
  type Hit,
  openQuery,
  type PoseInput,
  type Probe,
  type QueryFilter,
  type RunningQuery,
} from './body-query.ts';

/**
 * Returns the first body or wall that a shape meets when it moves along a line without turning, and where. It has met one
 * when the surfaces are 0.1 mm apart. What it overlaps at the start is met at fraction 0.
 * @param pose where the shape starts
 * @param motion where it moves to from there, m
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_UNKNOWN, E_RANGE (also in three dimensions), E_CAPACITY, E_DESTROYED
 */
export function castShape(
  world: PhysicsWorld,
  shape: Shape,
  pose: PoseInput,
  motion: PointInput,
  filter: QueryFilter = {},
): Hit | undefined {
  const query = openCast(world, shape, pose, motion, filter, 'castShape');
  return firstHit(query, castProbe(query));
}

/**
 * Returns all bodies and walls that a shape would meet if it passed through them, the earliest first; otherwise as `castShape`.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_UNKNOWN, E_RANGE (also in three dimensions), E_CAPACITY, E_DESTROYED
 */
export function castShapeAll(
  world: PhysicsWorld,
  shape: Shape,
  pose: PoseInput,
  motion: PointInput,
  filter: QueryFilter = {},
): Hit[] {
  const query = openCast(world, shape, pose, motion, filter, 'castShapeAll');
  return allHits(query, castProbe(query));
}

const castProbe = ({ kernels, at, shapeAt }: RunningQuery): Probe => ({
  next: (row) => kernels.nextShapeHit(at, shapeAt, row),
  meetsWall: () => kernels.castMeetsWall(at, shapeAt),
});

function openCast(
  world: PhysicsWorld,
  shape: Shape,
  pose: PoseInput,
  motion: PointInput,
  filter: QueryFilter,
  caller: string,
): RunningQuery {
  assertPlanar(world, caller);
  const checked = checkShape(world, shape, `${caller}: shape`);
  const start = checkPose(pose, `${caller}: pose`);
  const { x: dx, y: dy } = checkVector(motion, `${caller}: motion`);
  checkFilter(filter, caller);
  return openQuery(world, { ...start, dx, dy }, checked.extent, filter, checked);
}
