import { checkShape } from '../bodies/collider-shape.ts';
import type { Shape } from '../collision/shapes/2d/shape.ts';
import type { PhysicsWorld } from '../world/types.ts';
import {
  assertPlanar,
  checkFilter,
  checkPose,
  openQuery,
  type PoseInput,
  type QueryFilter,
  visitBodies,
} from './body-query.ts';
import { visitWalls } from './walls.ts';

/**
 * Returns the ids of all bodies and walls that a shape overlaps or touches, ascending; 0 stands for walls of `boxWalls`
 * that are no entities. Bodies are where they are now.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_UNKNOWN, E_RANGE (also in three dimensions), E_CAPACITY, E_DESTROYED
 */
export function overlapShape(world: PhysicsWorld, shape: Shape, pose: PoseInput, filter: QueryFilter = {}): number[] {
  assertPlanar(world, 'overlapShape');
  const checked = checkShape(world, shape, 'overlapShape: shape');
  const start = checkPose(pose, 'overlapShape: pose');
  checkFilter(filter, 'overlapShape');
  const query = openQuery(world, { ...start, dx: 0, dy: 0 }, checked.extent, filter, checked);
  const { kernels, at, shapeAt } = query;
  const next = (row: number) => kernels.nextNearBody(at, shapeAt, row);
  const ids: number[] = [];
  visitBodies(query, next, (row) => ids.push(row));
  const bodyCount = ids.length;
  visitWalls(query, (id) => {
    // Two walls of a box are listed once.
    if (kernels.isNearWall(at, shapeAt) === 1 && !(id === 0 && ids.includes(0))) ids.push(id);
  });
  return ids.length > bodyCount ? ids.sort((a, b) => a - b) : ids;
}
