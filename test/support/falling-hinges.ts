/**
 * Columns of boxes joined by hinges with springs, limits and motors, which fall on the ground and come to rest: the scene by
 * which Box2D shows that it is deterministic.
 */
import {
  asleepCount,
  box,
  createJoint,
  createPhysicsWorld,
  type PhysicsWorld,
  type Precision,
  revolute,
  rigidBodies,
  spawn,
  step,
  uniformGravity,
} from '@principia/physics';
import { motionHash } from './chaos.ts';

const COLUMNS = 4;
const ROWS = 20;
const SIZE = 0.5;

export function fallingHinges(precision: Precision): PhysicsWorld {
  const world = createPhysicsWorld({ preset: rigidBodies, precision, capacity: 300, forces: [uniformGravity()] });
  spawn(world, { position: { y: -1 }, collider: { shape: box(80, 2), friction: 0.3 } });
  const collider = { shape: box(SIZE, SIZE, { rounding: 0.05 }), density: 1, friction: 0.3 };
  for (let column = 0; column < COLUMNS; column++) {
    let last = 0;
    for (let row = 0; row < ROWS; row++) {
      const x = (column - 1.5) * 2.5 + 0.2 * SIZE * row;
      const y = SIZE * (row + 0.5);
      const body = spawn(world, { position: { x, y }, rotation: row % 2 === 0 ? 0 : -0.1, collider });
      if (row % 2 === 1) {
        const anchor = { x: x - 0.5 * SIZE, y: y - 0.5 * SIZE };
        const limits = { lower: -0.1 * Math.PI, upper: 0.2 * Math.PI };
        const drive = { spring: { hertz: 1, dampingRatio: 1 }, motor: { speed: 0, max: 0.25 } };
        createJoint(world, revolute({ a: last, b: body, anchor, limits, ...drive, collide: true }));
      }
      last = body;
    }
  }
  return world;
}

/** The number of steps until all bodies sleep, and the hash of their state then, by precision. */
export function hingeHashes(): Record<string, string> {
  const hashes: Record<string, string> = {};
  for (const precision of ['f32', 'f64'] as const) {
    const world = fallingHinges(precision);
    while (asleepCount(world) < COLUMNS * ROWS && world.tick < 2000) step(world, 1 / 60);
    hashes[precision] = `${world.tick} ${motionHash(world)}`;
  }
  return hashes;
}
