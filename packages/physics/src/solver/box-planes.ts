// boxWalls in a world of rigid bodies: each wall of the box is an entity with PlaneWall, made before the first step with that
// box. They follow the box that is in the phase `walls`.
import { despawn, spawn } from '../bodies/spawn.ts';
import type { BoxSystem } from '../dynamics/fused-step.ts';
import { FAR } from '../dynamics/loop-checks.ts';
import type { Box } from '../dynamics/step-features.ts';
import { isOpen } from '../ecs/rows.ts';
import { namedResource } from '../memory/resource.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** Numbers of a plane: nx, ny, offset, restitution, friction. */
export const PLANE_SIZE = 5;

/** The planes of the boxes of a world. */
interface BoxPlanes {
  /** What the entities were made from, and what the boxes ask for now: PLANE_SIZE numbers for each plane. */
  values: number[];
  readonly wanted: number[];
  ids: number[];
  /** Of the rows of these ids: an id whose plane was despawned may be that of another wall. */
  generations: number[];
}

const boxPlanes = namedResource('box planes', (): BoxPlanes => ({ values: [], wanted: [], ids: [], generations: [] }));

/**
 * Makes the planes of all boxes of the world, or changes them.
 * @throws PhysicsError E_CAPACITY when there is no room for their entities
 */
export function refreshBoxes(world: PhysicsWorld): void {
  const planes = boxPlanes(world);
  const { wanted, ids } = planes;
  const count = listPlanes(world, wanted);
  if (count === ids.length && isCurrent(world, planes)) return;
  const left = ids.filter((_, i) => isThere(world, planes, i));
  planes.ids = [];
  planes.generations = [];
  planes.values = [];
  for (const id of left) despawn(world, id);
  for (let i = 0; i < PLANE_SIZE * count; i += PLANE_SIZE) {
    const [nx, ny, offset, restitution, friction] = wanted.slice(i, i + PLANE_SIZE);
    const id = spawn(world, { planeWall: { nx, ny, offset, restitution, friction: Math.max(friction, 0) } });
    // Of a box without a coefficient of its own the body's is that of the contact.
    world.components.PlaneWall.friction[id] = friction;
    planes.ids.push(id);
    planes.generations.push(world.internal.generations[id]);
  }
  planes.values = wanted.slice(0, PLANE_SIZE * count);
}

function isCurrent(world: PhysicsWorld, planes: BoxPlanes): boolean {
  const { values, wanted, ids } = planes;
  for (let i = 0; i < values.length; i++) if (values[i] !== wanted[i]) return false;
  for (let i = 0; i < ids.length; i++) if (!isThere(world, planes, i)) return false;
  return true;
}

/** Whether the plane at this index of the list is still the one that was made. */
function isThere(world: PhysicsWorld, { ids, generations }: BoxPlanes, index: number): boolean {
  const id = ids[index];
  return isOpen(world, id, 'PlaneWall') && world.internal.generations[id] === generations[index];
}

/**
 * Writes the planes of all boxes that are no entities to a list, PLANE_SIZE numbers each, and returns their number: those of
 * worlds without rigid bodies, and of others before the first step.
 */
export function listVirtualPlanes(world: PhysicsWorld, into: number[]): number {
  return boxPlanes(world).ids.length > 0 ? 0 : listPlanes(world, into);
}

/** Writes the planes of all boxes to a list, and returns their number. */
function listPlanes({ phases }: PhysicsWorld, into: number[]): number {
  let count = 0;
  for (let s = 0; s < phases.walls.length; s++) {
    const system = phases.walls[s];
    if (typeof system === 'function' || system.role !== 'box') continue;
    const { box } = system as BoxSystem;
    if (box.low.x > -FAR) writePlane(into, count++, box, 1, 0, box.low.x);
    if (box.high.x < FAR) writePlane(into, count++, box, -1, 0, -box.high.x);
    if (box.low.y > -FAR) writePlane(into, count++, box, 0, 1, box.low.y);
    if (box.high.y < FAR) writePlane(into, count++, box, 0, -1, -box.high.y);
  }
  return count;
}

function writePlane(into: number[], index: number, box: Box, nx: number, ny: number, offset: number): void {
  const at = PLANE_SIZE * index;
  into[at] = nx;
  into[at + 1] = ny;
  into[at + 2] = offset;
  into[at + 3] = box.restitution;
  into[at + 4] = box.friction;
}
