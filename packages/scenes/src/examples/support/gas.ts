/** Balls of different size in a room, as the molecules of a gas. */
import {
  boxWalls,
  createPhysicsWorld,
  type Integrator,
  type PhysicsWorld,
  particleContacts,
  rgba,
  spawn,
} from '@principia/physics';
import type { Point } from '../picture.ts';

export const GAS_ROOM = { minX: 0, maxX: 700, minY: 0, maxY: 500 };

/** A room in which nothing loses energy. */
export function gasWorld(options: { capacity: number; integrator?: Integrator }): PhysicsWorld {
  const { minX, maxX, minY, maxY } = GAS_ROOM;
  const walls = [boxWalls({ min: { x: minX, y: minY }, max: { x: maxX, y: maxY }, restitution: 1 })];
  return createPhysicsWorld({ preset: particleContacts, walls, ...options });
}

/** A molecule with a mass that grows with its volume. */
export function addMolecule(world: PhysicsWorld, position: Point, velocity: Point, radius: number): number {
  const mass = 0.01 * radius * radius * radius;
  const appearance = rgba(1 - radius / 50, 0.75, 0.35 + radius / 60);
  return spawn(world, { position, velocity, mass, collider: { radius, restitution: 1 }, appearance });
}
