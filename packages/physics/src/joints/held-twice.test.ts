// Two joints of the same two bodies hold them as one would: they neither press against each other nor give energy.
import {
  box,
  boxWalls,
  createJoint,
  createRandom,
  energy,
  type JointInput,
  jointForce,
  type PhysicsWorld,
  revolute,
  spawn,
  step,
  weld,
  wheel,
} from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { DT, G, rigidWorld, run } from '../../../../test/support/rigid-world.ts';

type Pair = (a: number, b: number) => readonly [JointInput, JointInput];

const PAIRS: Record<string, Pair> = {
  'two hinges': (a, b) => [revolute({ a, b, anchor: { x: 0, y: 0 } }), revolute({ a, b, anchor: { x: 0.1, y: 0.2 } })],
  'two hinges one above the other': (a, b) => [
    revolute({ a, b, anchor: { x: 0, y: -0.2 } }),
    revolute({ a, b, anchor: { x: 0, y: 0.2 } }),
  ],
  'a weld and a wheel far from it': (a, b) => [
    weld({ a, b, anchor: { y: 0 } }),
    wheel({ a, b, anchor: { x: 2 }, axis: { x: 1, y: 1 } }),
  ],
  'a wheel and a weld': (a, b) => [
    wheel({ a, b, anchor: { x: 0.2 }, axis: { x: 1, y: 1 } }),
    weld({ a, b, anchor: { y: 0 } }),
  ],
};

const joined = (world: PhysicsWorld, pair: Pair, mass: number, velocity = {}) => {
  const collider = { shape: box(0.7, 0.5), friction: 0.5 };
  const a = spawn(world, { position: { x: -0.4 }, velocity, mass, collider });
  const b = spawn(world, { position: { x: 0.4 }, velocity, mass: 1, collider });
  const joints = pair(a, b).map((joint) => createJoint(world, joint));
  return { a, b, joints };
};

const CASES = Object.keys(PAIRS).flatMap((name) => [1, 16, 64].map((ratio) => [name, ratio] as const));

describe.each(CASES)('%s, of bodies of 1 : %s', (name, ratio) => {
  test('thrown about a room gain no energy, and do not press against each other', () => {
    const random = createRandom(5);
    for (let k = 0; k < 20; k++) {
      const walls = boxWalls({ min: { x: -6, y: -6 }, max: { x: 6, y: 6 }, restitution: 0.5, friction: 0.5 });
      const world = rigidWorld({ walls: [walls] });
      const { joints } = joined(world, PAIRS[name], ratio, { x: random.uniform(-5, 5), y: random.uniform(-5, 5) });
      let least = energy(world).total;
      // Free fall of 12 m adds less than 9 m/s to 7 m/s. No blow takes more than this momentum, times 1.5 for e, in a sub-step of 1/240 s.
      const blow = (ratio + 1) * 16 * 1.5 * 240;
      for (let i = 0; i < 300; i++) {
        step(world, DT);
        const now = energy(world).total;
        // Joints that gave way in a blow lift what hangs on them when they close: by some centimetres.
        expect(now - least).toBeLessThan((ratio + 1) * G * 0.1);
        least = Math.min(least, now);
        for (const joint of joints) expect(jointForce(world, joint)).toBeLessThan(blow);
      }
    }
  });

  test('bear the weight of the second body, and no more', () => {
    const world = rigidWorld();
    spawn(world, { position: { x: -0.56, y: -0.5 }, collider: { shape: box(1.2, 0.5) } });
    // Only the first body lies on it: two equal ones would tip.
    const { a, b, joints } = joined(world, PAIRS[name], Math.max(2, ratio));
    run(world, 2);
    const { y } = world.components.Position;
    for (const id of [a, b]) expect(Math.abs(y[id])).toBeLessThan(0.01);
    // The weight of 1 kg, and its moment about the joint, at 0.4 m, by levers of 0.1 m at least.
    const most = G + (G * 0.4) / 0.1;
    for (const joint of joints) expect(jointForce(world, joint)).toBeLessThan(most);
  });
});

test('two hinges hold the angle of two bodies', () => {
  const world = rigidWorld();
  const wall = spawn(world, { position: { x: -0.4 }, collider: { shape: box(0.7, 0.5) } });
  const arm = spawn(world, { position: { x: 0.4 }, mass: 1, collider: { shape: box(0.7, 0.5) } });
  const tip = spawn(world, { position: { x: 1.2 }, mass: 1, collider: { shape: box(0.7, 0.5) } });
  createJoint(world, weld({ a: wall, b: arm, anchor: { x: 0 } }));
  for (const y of [-0.2, 0.2]) createJoint(world, revolute({ a: arm, b: tip, anchor: { x: 0.8, y } }));
  run(world, 2);
  const { Rotation } = world.components;
  // Joints give way by load/(m ω²) at 60 Hz: 1 kg at 0.4 m over 0.4 m, some 1e-4 m.
  expect(Math.abs(Rotation.angle[tip] - Rotation.angle[arm])).toBeLessThan(1e-3);
});

test('two hinges hold a body to one that may only turn', () => {
  const world = rigidWorld({ forces: [] });
  const locks = { x: true, y: true };
  const wheel = spawn(world, {
    position: {},
    angularVelocity: { z: 2 },
    motionLocks: locks,
    collider: { shape: box(1, 1), density: 10 },
  });
  const bar = spawn(world, {
    position: { x: 1 },
    velocity: { y: 2 },
    angularVelocity: { z: 2 },
    mass: 1,
    collider: { shape: box(1, 0.2) },
  });
  for (const y of [-0.1, 0.1]) createJoint(world, revolute({ a: wheel, b: bar, anchor: { x: 0.5, y } }));
  const { Position, Rotation } = world.components;
  for (let i = 0; i < 120; i++) {
    step(world, DT);
    // A rigid body about the origin: the bar stays a metre from it, and turns as the wheel does; joints give way by m ω² r/(m ω₀²), 3e-5 m.
    expect(Math.hypot(Position.x[bar], Position.y[bar])).toBeCloseTo(1, 3);
    expect(Rotation.angle[bar]).toBeCloseTo(Rotation.angle[wheel], 3);
  }
  expect(Rotation.angle[wheel]).toBeGreaterThan(3);
});
