/** The stage of the first chapters: 700 by 500 pixels with y down, a floor, and open sides. */
import {
  boxWalls,
  createPhysicsWorld,
  type PhysicsWorld,
  type PhysicsWorldOptions,
  type Random,
  uniformGravity,
} from '@principia/physics';
import { wrapAround } from '../../edges.ts';
import { COLORS, type Point, type ViewBox } from '../picture.ts';

/** Radius of the balls, px. */
export const RADIUS = 20;

export const STAGE: ViewBox = { minX: 0, maxX: 700, minY: 0, maxY: 500 };

/** A view of the stage with a little ground, whose edges are a ball's width beyond the sides. */
export const STAGE_VIEW: ViewBox = { minX: 0, maxX: 700, minY: 0, maxY: 515 };

/** The ground below the floor. */
export const GROUND = { shape: { minX: -700, maxX: 1400, minY: STAGE.maxY, maxY: 800 }, color: COLORS.ground } as const;

/** A world with gravity, px/s², and the floor of the stage. */
export function stageWorld(gravity: number, options: PhysicsWorldOptions): PhysicsWorld {
  const walls = [boxWalls({ max: { y: STAGE.maxY } })];
  return createPhysicsWorld({ capacity: 64, forces: [uniformGravity({ y: gravity })], walls, ...options });
}

/** The stage with a ball's width beyond the sides, where a ball is out of sight. */
const SIDES = { min: { x: STAGE.minX - RADIUS }, max: { x: STAGE.maxX + RADIUS } };

/** Bodies that have left the stage at a side come back at the other. */
export function comeBack(world: PhysicsWorld, bodies: readonly number[]): void {
  world.phases.input.push(wrapAround(SIDES, bodies));
}

/** A random velocity, px/s: up to 300 to the right, and up to 120 up or down. */
export function randomLaunch(random: Random): Point {
  return { x: random.uniform(0, 300), y: random.uniform(-120, 120) };
}
