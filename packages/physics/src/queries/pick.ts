import { partsOf } from '../bodies/parts.ts';
import { distanceToShape } from '../collision/shapes/2d/distance-to-shape.ts';
import type { Shape } from '../collision/shapes/2d/shape.ts';
import { shapeAt } from '../collision/shapes/shape-pool.ts';
import { assertUsable } from '../ecs/guards.ts';
import { bodies } from '../ecs/ranges.ts';
import { withoutWaiting } from '../emitters/waiting.ts';
import { checkKeys, checkNumber, checkPoint, type VectorInput } from '../errors/validate.ts';
import { cos, sin } from '../math/elementary.ts';
import { placeParts } from '../solver/refresh-parts.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { type BodyFilter, type CheckedFilter, checkBodyFilter } from './body-filter.ts';

/** Options of picking a body by a point. */
export interface PickOptions extends BodyFilter {
  /** Tolerance around a body, m: touch input is imprecise. Default 0. */
  readonly margin?: number;
}

/**
 * Returns the body at a point: of the bodies whose collider or drawn size contains it, the one with the nearest centre;
 * of equally near bodies, the one with the smaller id. Leaves sensors out, unless `sensors` says otherwise. Includes bodies created since the last step, and of the entities of an
 * emitter its living particles. Tests every body.
 * @param point metres; in 2D only x and y are used
 * @returns its entity id, or 0 if there is none
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN, E_DESTROYED
 */
export function bodyAt(world: PhysicsWorld, point: VectorInput, options: PickOptions = {}): number {
  assertUsable(world);
  const { x, y, z } = checkPoint(point, 'point');
  checkKeys(options, 'bodyAt', ['margin', 'mask', 'ignore', 'sensors']);
  const margin = checkNumber(options.margin ?? 0, 'margin', { min: 0 });
  const filter = checkBodyFilter(options);
  placeParts(world);
  const { ids, count } = withoutWaiting(world, bodies(world));
  const { Position, Collider, Appearance } = world.components;
  const depth = world.dimensions === 3 ? 1 : 0;
  let nearest = Infinity;
  let found = 0;
  for (let i = 0; i < count; i++) {
    const id = ids[i];
    const dx = Position.x[id] - x;
    const dy = Position.y[id] - y;
    const dz = (Position.z[id] - z) * depth;
    const distance = Math.sqrt(dx * dx + dy * dy + dz * dz);
    if (!(distance < nearest) || !isSeen(world, id, filter)) continue;
    const shape = Collider.shape[id] > 0 ? shapeAt(world, Collider.shape[id]) : undefined;
    const size = Math.max(shape?.extent ?? Collider.radius[id], Appearance.size[id]);
    if (distance <= size + margin && isNearShape(world, id, shape, -dx, -dy, margin)) {
      // Of a compound body the parts are there to be picked.
      if (size === 0 && partsOf(world, id).length > 0) continue;
      nearest = distance;
      found = id;
    }
  }
  return found;
}

/** What has no collider is on all layers. */
function isSeen({ components }: PhysicsWorld, id: number, { mask, ignored, seesSensors }: CheckedFilter): boolean {
  const { Attachment, Collider } = components;
  const { radius, layers, sensor } = Collider;
  if (radius[id] > 0 && ((layers[id] & mask) === 0 || (sensor[id] !== 0 && !seesSensors))) return false;
  return ignored.length === 0 || !(ignored.includes(id) || ignored.includes(Attachment.body[id]));
}

/** Whether a point, given from the centre of a body, is within a distance of its shape; discs and balls have none. */
function isNearShape(
  { components: { Rotation } }: PhysicsWorld,
  id: number,
  shape: Shape | undefined,
  x: number,
  y: number,
  margin: number,
): boolean {
  if (shape === undefined) return true;
  const angle = Rotation.angle[id];
  const [c, s] = [cos(angle), sin(angle)];
  return distanceToShape(shape, c * x + s * y, c * y - s * x) <= margin;
}
