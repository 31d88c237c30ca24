// What falls into a gap as wide as itself falls through: the corners straight below its own do not hold it up.
import { box, capsule, createPhysicsWorld, rigidBodies, spawn, step, uniformGravity } from '@principia/physics';
import { describe, expect, test } from 'vitest';

const DT = 1 / 60;

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  const shapes = [
    { name: 'a box', shape: box(1, 1), width: 1, height: 1, angle: 0 },
    { name: 'a tall box', shape: box(1, 2), width: 1, height: 2, angle: 0 },
    { name: 'a capsule that lies', shape: capsule(1, 0.5), width: 2, height: 1, angle: 0 },
    { name: 'a capsule that stands', shape: capsule(1, 0.5), width: 1, height: 2, angle: Math.PI / 2 },
  ] as const;

  test.each(shapes)(
    '$name falls through gaps that it fits into, whatever its speed',
    ({ shape, width, height, angle }) => {
      for (const clearance of [0, 0.0005, 0.002, 0.005, 0.01, 0.02]) {
        for (const friction of [0, 0.6]) {
          for (let from = 2.6; from < 8; from += 0.731) {
            const world = createPhysicsWorld({ preset: rigidBodies, precision, forces: [uniformGravity({ y: -10 })] });
            const wall = { shape: box(1, 1), friction };
            spawn(world, { position: { y: -1 }, collider: { shape: box(60, 2), friction } });
            spawn(world, { position: { x: -(width + 1 + clearance) / 2, y: 1 }, collider: wall });
            spawn(world, { position: { x: (width + 1 + clearance) / 2, y: 1 }, collider: wall });
            const body = spawn(world, {
              position: { y: from },
              rotation: { angle },
              mass: 1,
              collider: { shape, friction },
            });
            for (let i = 0; i < 180; i++) step(world, DT);
            const { Position, Rotation } = world.components;
            const at = `${clearance} m to spare, friction ${friction}, from ${from} m`;
            // It rests on the floor within the slop of 5 mm, as upright as the gap and the slop of both walls let it: a corner of a box
            // of 1 m is then up by another slop.
            expect(Math.abs((Position.y[body] as number) - height / 2), at).toBeLessThan(2 * 0.005 + clearance);
            expect(Math.abs((Rotation.angle[body] as number) - angle), at).toBeLessThan(0.02);
          }
        }
      }
    },
  );
});
