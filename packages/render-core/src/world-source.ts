import { bodies, type PhysicsWorld } from '@principia/physics';
import type { BodySource } from './body-source.ts';
import { OutlineTable } from './outline-table.ts';

/** Restoring a snapshot resets the version counters; this offset keeps them unique for renderers. */
const RESTORE_OFFSET = 2 ** 32;

/**
 * The columns of a world for renderers. Nothing is copied: the source is a live view of the world.
 *
 * @throws Error when it is not given a world
 */
export function worldSource(world: PhysicsWorld): BodySource {
  if (world?.components === undefined) {
    throw new Error('worldSource needs a world made by createPhysicsWorld: worldSource(world)');
  }
  const { components, previous, versions } = world;
  const { Position, Rotation, Orientation, Collider, Appearance } = components;
  const outlines = new OutlineTable();
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
    outline: Collider.shape,
    get outlines() {
      return outlines.refresh(world);
    },
    get ids() {
      return bodies(world).ids;
    },
    get count() {
      return bodies(world).count;
    },
    get lastId() {
      return world.lastId;
    },
    generations: world.internal.generations,
    versions: {
      get pose() {
        return versions.pose + versions.restored * RESTORE_OFFSET;
      },
      get style() {
        return versions.style + versions.restored * RESTORE_OFFSET;
      },
      get membership() {
        return versions.membership + versions.restored * RESTORE_OFFSET;
      },
      get steps() {
        return world.tick;
      },
      get restored() {
        return versions.restored;
      },
    },
  };
}
