import { bodies, type PhysicsWorld } from '@principia/physics';
import { checkOptions, type OptionNames } from './arguments.ts';
import type { BodySource } from './body-source.ts';
import { type BodyChoice, ChosenBodies } from './chosen-bodies.ts';
import { OutlineTable } from './outline-table.ts';

/** Restoring a snapshot resets the version counters; this offset keeps them unique for renderers. */
const RESTORE_OFFSET = 2 ** 32;

/** Options of `worldSource`. */
export interface WorldSourceOptions {
  /**
   * The bodies of the source, for layers of their own: ids, or a function such as `() => query(world, [Hero])`, which is asked at each
   * picture. Of a list that stays, those that are gone are left out, also when another body takes their id. Default all.
   */
  bodies?: BodyChoice;
}

const OPTION_NAMES: OptionNames<WorldSourceOptions> = { bodies: true };

/**
 * The columns of a world for renderers. Nothing is copied: the source is a live view of the world. Layers of one source share
 * what they send to the graphics card, those of two sources do not.
 *
 * @throws Error when it is not given a world, an option does not exist, or an id of `bodies` is none
 */
export function worldSource(world: PhysicsWorld, options: WorldSourceOptions = {}): BodySource {
  if (world?.components === undefined) {
    throw new Error('worldSource needs a world made by createPhysicsWorld: worldSource(world)');
  }
  checkOptions(options, OPTION_NAMES, 'worldSource');
  const chosen = options.bodies === undefined ? undefined : new ChosenBodies(world, options.bodies);
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
      return chosen?.refresh().ids ?? bodies(world).ids;
    },
    get count() {
      return chosen?.refresh().count ?? bodies(world).count;
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
        // Both only grow, so that their sum changes with either.
        const own = chosen?.refresh().version ?? 0;
        return versions.membership + versions.restored * RESTORE_OFFSET + own;
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
