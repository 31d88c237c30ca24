/** Rooms with inclined walls. */
import {
  createPhysicsWorld,
  type Integrator,
  type PhysicsWorld,
  particleContacts,
  spawn,
  uniformGravity,
} from '@principia/physics';
import { COLORS, type Line } from '../picture.ts';

/** The ends of a wall: x and y of the first, x and y of the second. */
export type Ends = readonly [ax: number, ay: number, bx: number, by: number];

/** The sides of a rectangle. */
export const boxOf = (minX: number, minY: number, maxX: number, maxY: number): readonly Ends[] => [
  [minX, minY, maxX, minY],
  [maxX, minY, maxX, maxY],
  [maxX, maxY, minX, maxY],
  [minX, maxY, minX, minY],
];

/** The room of 500 by 350 px with four inclined walls. */
export const ROOM: readonly Ends[] = [
  ...boxOf(50, 50, 550, 400),
  [100, 100, 200, 120],
  [350, 170, 450, 140],
  [130, 200, 260, 300],
  [370, 310, 470, 280],
];

/** A world with gravity downwards and walls, in which balls meet walls only. */
export function worldWithWalls(
  walls: readonly Ends[],
  options: { gravity: number; capacity: number; integrator?: Integrator },
): PhysicsWorld {
  const { gravity, ...more } = options;
  const world = createPhysicsWorld({ preset: particleContacts, forces: [uniformGravity({ y: gravity })], ...more });
  world.phases.collide.length = 0;
  for (const [ax, ay, bx, by] of walls) spawn(world, { segmentWall: { ax, ay, bx, by, friction: 0 } });
  return world;
}

/** The walls as lines of a picture. */
export function linesOf(walls: readonly Ends[]): Line[] {
  return walls.map(([ax, ay, bx, by]) => ({
    from: { x: ax, y: ay },
    to: { x: bx, y: by },
    color: COLORS.white,
    width: 3,
  }));
}
