// Limits in a heap: limbs that others press against their limits bear thousands of newtons, contacts move them by a little in each
// sub-step, and a limit that let go of one would fling it about. So a heap of ragdolls comes to rest and falls asleep.
import { asleepCount, box, capsule, createJoint, type PhysicsWorld, revolute, spawn, step } from '@principia/physics';
import { expect, it } from 'vitest';
import { DT, rigidWorld } from '../../../../test/support/rigid-world.ts';

/** A bone: its place from the middle of the doll, the length and radius of its capsule, a ball where it is 0, and whether it is upright. */
type Bone = readonly [x: number, y: number, length: number, radius: number, isUpright: boolean];

const BONES: readonly Bone[] = [
  [0, 0, 0.4, 0.12, true],
  [0, 0.47, 0, 0.13, true],
  ...[-1, 1].flatMap((side): Bone[] => [
    [0.25 * side, 0.2, 0.22, 0.05, false],
    [0.52 * side, 0.2, 0.22, 0.045, false],
    [0.08 * side, -0.5, 0.34, 0.07, true],
    [0.08 * side, -0.92, 0.34, 0.06, true],
  ]),
];

/** Hinges: two bones, the place, and limits, rad. */
const HINGES: readonly (readonly [a: number, b: number, x: number, y: number, lower: number, upper: number])[] = [
  [0, 1, 0, 0.33, -0.6, 0.6],
  [0, 2, -0.12, 0.2, -1.5, 1.5],
  [2, 3, -0.385, 0.2, -0.1, 2],
  [0, 4, -0.08, -0.28, -0.5, 1.2],
  [4, 5, -0.08, -0.71, -1.8, 0.05],
  [0, 6, 0.12, 0.2, -1.5, 1.5],
  [6, 7, 0.385, 0.2, -2, 0.1],
  [0, 8, 0.08, -0.28, -0.5, 1.2],
  [8, 9, 0.08, -0.71, -1.8, 0.05],
];

function addDoll(world: PhysicsWorld, x: number, y: number, speed: number, group: number): void {
  const bones = BONES.map(([dx, dy, length, radius, isUpright]) =>
    spawn(world, {
      position: { x: x + dx, y: y + dy },
      rotation: isUpright ? Math.PI / 2 : 0,
      velocity: { x: speed },
      collider: {
        ...(length > 0 ? { shape: capsule(length, radius) } : { radius }),
        density: 600,
        friction: 0.6,
        group,
      },
    }),
  );
  for (const [a, b, dx, dy, lower, upper] of HINGES) {
    const anchor = { x: x + dx, y: y + dy };
    const limits = { lower, upper };
    createJoint(
      world,
      revolute({ a: bones[a] as number, b: bones[b] as number, anchor, limits, motor: { speed: 0, max: 4 } }),
    );
  }
}

/** Seconds until thirty dolls that fall onto stairs are all asleep, at most `most`. */
function restsAfter(precision: 'f32' | 'f64', speed: number, most: number): number {
  const world = rigidWorld({ precision, capacity: 700 });
  for (let i = 0; i < 12; i++) {
    spawn(world, {
      position: { x: 0.5 * i, y: 0.3 * (12 - i) - 1.5 },
      collider: { shape: box(0.5, 3), friction: 0.6 },
    });
  }
  spawn(world, { position: { x: 20, y: -0.5 }, collider: { shape: box(60, 1), friction: 0.6 } });
  for (let i = 0; i < 30; i++) addDoll(world, 1.3 * (i % 10) - 2, 6 + 1.8 * Math.floor(i / 10), speed, -1 - i);
  let steps = 0;
  while (steps * DT < most && asleepCount(world) < 30 * BONES.length) {
    step(world, DT);
    steps++;
  }
  return steps * DT;
}

// A heap is chaotic, and a limb that lies on an edge may take longer: four of five.
it.each(['f32', 'f64'] as const)('thirty ragdolls thrown down stairs are asleep within 20 s, in %s', (precision) => {
  const times = [1.5, 1.65, 1.8, 1.95, 2.1].map((speed) => restsAfter(precision, speed, 20));
  expect(times.filter((time) => time < 20).length, times.join(', ')).toBeGreaterThanOrEqual(4);
});
