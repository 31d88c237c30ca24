// What flies closely past a corner and touches nothing goes on as it was.
import {
  box,
  capsule,
  circle,
  createPhysicsWorld,
  type PhysicsWorld,
  rigidBodies,
  type Shape,
  spawn,
  spawnChain,
  step,
} from '@principia/physics';
import { describe, expect, test } from 'vitest';

/** Obstacles whose right side is at x = 0, around the height 0. */
const OBSTACLES: Readonly<Record<string, (world: PhysicsWorld) => unknown>> = {
  'a corner of a box': (world) => spawn(world, { position: { x: -1 }, collider: { shape: box(2, 0.2) } }),
  'the end of a capsule': (world) => spawn(world, { position: { x: -0.75 }, collider: { shape: capsule(1, 0.25) } }),
  'a corner of a chain': (world) => {
    const corners = [
      { x: -2, y: -0.2 },
      { x: 0, y: -0.2 },
      { x: 0, y: 0 },
      { x: -2, y: 0 },
    ];
    spawnChain(world, corners, {}, { closed: true });
  },
};

const SHAPES: Readonly<Record<string, Shape>> = {
  disc: circle(0.25),
  box: box(0.5, 0.5),
  'rounded box': box(0.5, 0.5, { rounding: 0.05 }),
};

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  for (const [obstacle, place] of Object.entries(OBSTACLES)) {
    test.each(Object.entries(SHAPES))(`a %s is not deflected by ${obstacle}`, (_, shape) => {
      for (const rate of [30, 60, 240]) {
        for (const clearance of [0.0005, 0.002, 0.0033, 0.005, 0.01]) {
          for (const [i, speed] of [1, 3, 7.5, 15, 40].entries()) {
            const world = createPhysicsWorld({ preset: rigidBodies, precision, capacity: 50 });
            place(world);
            // They come to the corner at all times of a step.
            const y = 1.5 + ((i * 0.618 + 100 * clearance) % 1) * (speed / rate);
            const velocity = { y: -speed };
            const body = spawn(world, {
              position: { x: 0.25 + clearance, y },
              velocity,
              collider: { shape, density: 1 },
            });
            for (let k = 0; k < Math.ceil((3 / speed) * rate); k++) step(world, 1 / rate);
            const { Velocity, AngularVelocity } = world.components;
            const at = `${speed} m/s, ${clearance} m to spare, ${rate} Hz`;
            expect([Velocity.x[body], Velocity.y[body], AngularVelocity.z[body]], at).toEqual([0, -speed, 0]);
          }
        }
      }
    });
  }
});
