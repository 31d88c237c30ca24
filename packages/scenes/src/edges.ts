/** Rules at the edges of a region: bodies come back on the other side, start anew, or are removed. */
import { bodies, despawn, type GlobalSystem, PhysicsError, type PhysicsWorld } from '@principia/physics';

/** A box of which any side may be left out. Sides belong to the region. */
export interface Region {
  /** The sides at the smaller coordinates. Default open. */
  readonly min?: RegionCorner;
  /** The sides at the larger coordinates. Default open. */
  readonly max?: RegionCorner;
}

/** Places of three sides of a box along their axes, m. */
export interface RegionCorner {
  /** Default open. */
  readonly x?: number;
  /** Default open. */
  readonly y?: number;
  /** Default open. */
  readonly z?: number;
}

const AXES = ['x', 'y', 'z'] as const;
const lowOf = ({ min }: Region, axis: (typeof AXES)[number]) => min?.[axis] ?? Number.NEGATIVE_INFINITY;
const highOf = ({ max }: Region, axis: (typeof AXES)[number]) => max?.[axis] ?? Number.POSITIVE_INFINITY;

/** Whether the centre of a body is beyond a side. */
export function isOutside({ components: { Position } }: PhysicsWorld, id: number, region: Region): boolean {
  for (let i = 0; i < AXES.length; i++) {
    const at = Position[AXES[i]][id];
    if (at < lowOf(region, AXES[i]) || at > highOf(region, AXES[i])) return true;
  }
  return false;
}

/**
 * A system that lets bodies whose centre has left at a side come back at the opposite one, with the velocity that they
 * have. Their previous pose moves along, so that no picture shows them on the way. Bodies at opposite sides do not touch.
 * Put it into `world.phases.input` or `world.phases.finish`.
 * @param region axes of which both sides are given are closed to a ring
 * @param ids the bodies; default all
 * @throws PhysicsError E_RANGE if a side has no opposite, or not beyond itself
 */
export function wrapAround(region: Region, ids?: ArrayLike<number>): GlobalSystem {
  const rings = AXES.filter((axis) => region.min?.[axis] !== undefined || region.max?.[axis] !== undefined);
  for (const axis of rings) checkRing(axis, lowOf(region, axis), highOf(region, axis));
  return (world) => {
    const all = bodies(world);
    const list = ids ?? all.ids;
    const count = ids?.length ?? all.count;
    let moved = 0;
    for (let i = 0; i < rings.length; i++) {
      const axis = rings[i];
      const position = world.components.Position[axis];
      const previous = world.previous.Position[axis];
      moved += shiftInto(position, previous, list, count, lowOf(region, axis), highOf(region, axis));
    }
    if (moved > 0) world.versions.pose++;
  };
}

/** Shifts by whole lengths of the ring what has left it. @returns the number of bodies that were shifted */
function shiftInto(
  position: Float32Array | Float64Array,
  previous: Float32Array | Float64Array,
  ids: ArrayLike<number>,
  count: number,
  low: number,
  high: number,
): number {
  let moved = 0;
  for (let i = 0; i < count; i++) {
    const id = ids[i];
    const at = position[id];
    if (at >= low && at <= high) continue;
    // A fast body may go round several times in a step.
    const rounds = at < low ? Math.ceil((low - at) / (high - low)) : -Math.ceil((at - high) / (high - low));
    position[id] += rounds * (high - low);
    previous[id] += rounds * (high - low);
    moved++;
  }
  return moved;
}

/**
 * A system that calls `launch` for each of the bodies whose centre has left the region, for example to `teleport` it back
 * to where it began. Put it into `world.phases.input`.
 * @param launch gets the id of the body and its index in `ids`
 */
export function relaunchOutside(
  region: Region,
  ids: readonly number[],
  launch: (id: number, index: number) => void,
): GlobalSystem {
  return (world) => {
    for (let i = 0; i < ids.length; i++) if (isOutside(world, ids[i], region)) launch(ids[i], i);
  };
}

/** A system that removes every body whose centre has left the region. Put it into `world.phases.input`. */
export function removeOutside(region: Region): GlobalSystem {
  const gone: number[] = [];
  return (world) => {
    const { ids, count } = bodies(world);
    for (let i = 0; i < count; i++) if (isOutside(world, ids[i], region)) gone.push(ids[i]);
    while (gone.length > 0) despawn(world, gone.pop() as number);
  };
}

function checkRing(axis: string, low: number, high: number): void {
  if (low < high && high - low < Number.POSITIVE_INFINITY) return;
  throw new PhysicsError('E_RANGE', `wrapAround: the sides along ${axis} are ${low} and ${high}.`, {
    field: `region.${axis}`,
    hint: 'Give both min and max of an axis along which bodies come back, with min below max; leave both out of others.',
  });
}
