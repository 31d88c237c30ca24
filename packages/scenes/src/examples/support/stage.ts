/** The stage of the first chapters: 700 by 500 pixels with y down, a floor, and open sides. */
import {
  boxWalls,
  createPhysicsWorld,
  type PhysicsWorld,
  type PhysicsWorldOptions,
  type Random,
  uniformGravity,
} from '@principia/physics';
import { teleport } from '../../teleport.ts';
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

/** A body that has left the stage on the right comes back on the left. */
export function wrapAround(world: PhysicsWorld, bodies: readonly number[]): void {
  const { Position, Velocity } = world.components;
  world.phases.input.push(() => {
    for (const id of bodies) {
      if (Position.x[id] <= STAGE.maxX + RADIUS) continue;
      const position = { x: Position.x[id] - (STAGE.maxX - STAGE.minX + 2 * RADIUS), y: Position.y[id] };
      teleport(world, id, position, { x: Velocity.x[id], y: Velocity.y[id] });
    }
  });
}

/** A random velocity, px/s: up to 300 to the right, and up to 120 up or down. */
export function randomLaunch(random: Random): Point {
  return { x: random.uniform(0, 300), y: random.uniform(-120, 120) };
}
