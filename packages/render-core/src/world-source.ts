import { bodies, type PhysicsWorld } from '@principia/physics';
import type { BodySource } from './body-source.ts';

/** The columns of a world as renderers take them. Nothing is copied: the source is a view that follows the world. */
export function worldSource(world: PhysicsWorld): BodySource {
  const { components, previous } = world;
  const { Position, Rotation, Orientation, Collider, Appearance } = components;
  return {
    dimensions: world.dimensions,
    rows: world.rows,
    position: Position,
    previousPosition: previous.Position,
    angle: Rotation.angle,
    previousAngle: previous.Rotation.angle,
    orientation: Orientation,
    previousOrientation: previous.Orientation,
    radius: Collider.radius,
    size: Appearance.size,
    color: Appearance.color,
    shape: Appearance.shape,
    get ids() {
      return bodies(world).ids;
    },
    get count() {
      return bodies(world).count;
    },
    get lastId() {
      return world.lastId;
    },
    versions: world.versions,
  };
}
