// What rocks on a corner without slipping turns about it as about a hinge, and loses and gains nothing.
import {
  box,
  destroyWorld,
  type PhysicsWorld,
  type Precision,
  polygon,
  spawn,
  spawnCompound,
  step,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, rigidWorld, run } from '../../../../test/support/rigid-world.ts';

const ANGLE = 0.2;
const SECONDS = 30;

/** A wedge with its point at the origin, `depth` high, in a world with ground. */
function wedgeWorld(precision: Precision, depth: number, density?: number): PhysicsWorld {
  const world = rigidWorld({ precision });
  const shape = polygon([{ x: -1.5, y: -depth }, { x: 1.5, y: -depth }, {}]);
  const collider = { shape, friction: 1, ...(density === undefined ? {} : { density }) };
  spawn(world, { position: { y: (-2 / 3) * depth }, collider });
  spawn(world, { position: { y: -depth - 0.5 }, collider: { shape: box(20, 1), friction: 1 } });
  return world;
}

/** A plank on the point with a weight below each end. */
function balance(world: PhysicsWorld): number {
  const weight = { shape: box(0.3, 0.3), y: -1.9, density: 10, friction: 1 };
  const parts = [
    { shape: box(3, 0.1), y: 0.05, density: 1, friction: 1 },
    { ...weight, x: -1.4 },
    { ...weight, x: 1.4 },
  ];
  return spawnCompound(world, { position: {}, rotation: ANGLE, neverSleep: {}, parts }).body;
}

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  // With levers of the start of each step, which lag by half a step, it swung by 0.24 rad in the end.
  it.each([
    ['stands still', undefined],
    ['weighs a hundred times as much', 100],
  ])('a toy that balances on a wedge that %s swings on', (_, density) => {
    const world = wedgeWorld(precision, 8, density);
    const toy = balance(world);
    const angle = world.components.Rotation.angle;
    run(world, SECONDS - 5);
    let largest = 0;
    for (let i = 0; i < 5 / DT; i++) {
      step(world, DT);
      largest = Math.max(largest, Math.abs(angle[toy] as number));
    }
    expect(Math.abs(largest / ANGLE - 1)).toBeLessThan(0.01);
    destroyWorld(world);
  });
});
