// A world of rigid bodies as most of their tests use it.
import {
  box,
  circle,
  createPhysicsWorld,
  type PhysicsWorld,
  type PhysicsWorldOptions,
  rigidBodies,
  spawn,
  step,
  uniformGravity,
} from '@principia/physics';

/** The world's gravity, m/s². */
export const G = 9.80665;
/** The step, s. */
export const DT = 1 / 60;
/** Overlap that contacts leave, m. */
export const SLOP = 0.005;

/** Under standard gravity, unless the options say otherwise. */
export function rigidWorld(options: PhysicsWorldOptions = {}): PhysicsWorld {
  return createPhysicsWorld({ preset: rigidBodies, forces: [uniformGravity()], capacity: 500, ...options });
}

export function run(world: PhysicsWorld, seconds: number): void {
  for (let i = 0; i < Math.round(seconds / DT); i++) step(world, DT);
}

/** Options of `disc`. */
export interface Disc {
  readonly x?: number;
  readonly y?: number;
  readonly vx?: number;
  readonly vy?: number;
  readonly mass?: number;
  readonly radius?: number;
  readonly restitution?: number;
  readonly friction?: number;
}

/** A disc of 1 kg and 0.5 m, with a restitution of 1 and without friction, unless the options say otherwise. */
export function disc(world: PhysicsWorld, options: Disc): number {
  const { x = 0, y = 0, vx = 0, vy = 0, mass = 1, radius = 0.5, restitution = 1, friction = 0 } = options;
  const collider = { shape: circle(radius), restitution, friction };
  return spawn(world, { position: { x, y }, velocity: { x: vx, y: vy }, mass, collider });
}

/** A point, m. */
export type Point = readonly [x: number, y: number];

/** A bar of the width 0.1 m between two points, which collides with nothing. */
export function addBar(world: PhysicsWorld, [x, y]: Point, [toX, toY]: Point, mass: number, more: object = {}): number {
  const length = Math.hypot(toX - x, toY - y);
  return spawn(world, {
    position: { x: (x + toX) / 2, y: (y + toY) / 2 },
    rotation: Math.atan2(toY - y, toX - x),
    collider: { shape: box(length, 0.1), density: mass / (0.1 * length), mask: 0 },
    ...more,
  });
}
