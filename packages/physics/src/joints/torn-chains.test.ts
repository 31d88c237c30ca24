// Chains that are torn apart come together again: a jerk of a heavy load, or a body that is put elsewhere, is not the end of them.
import {
  box,
  capsule,
  circle,
  createJoint,
  energy,
  type PhysicsWorld,
  revolute,
  spawn,
  step,
} from '@principia/physics';
import { describe, expect, it, test } from 'vitest';
import { DT, rigidWorld, run } from '../../../../test/support/rigid-world.ts';

const LENGTH = 0.2;

/** A chain from a peg at the origin, let go at an angle, with a load of `density` at its end. Returns its bodies, the peg first, and joints. */
function chainWithLoad(world: PhysicsWorld, links: number, angle: number, density: number) {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const bodies = [spawn(world, { position: {}, collider: { shape: circle(0.1), mask: 0 } })];
  const joints: number[] = [];
  const hang = (body: number, at: number) => {
    const anchor = { x: at * c, y: at * s };
    joints.push(createJoint(world, revolute({ a: bodies.at(-1) as number, b: body, anchor })));
    bodies.push(body);
  };
  for (let i = 0; i < links; i++) {
    const at = (i + 0.5) * LENGTH;
    const collider = { shape: capsule(0.8 * LENGTH, 0.03), density: 100, mask: 0 };
    hang(spawn(world, { position: { x: at * c, y: at * s }, rotation: angle, collider }), i * LENGTH);
  }
  const end = links * LENGTH;
  const position = { x: (end + 0.2) * c, y: (end + 0.2) * s };
  hang(spawn(world, { position, rotation: angle, collider: { shape: circle(0.25), density, mask: 0 } }), end);
  return { bodies, joints, length: end + 0.2 };
}

/** The largest gap of hinges, m. */
function largestGap(world: PhysicsWorld, joints: readonly number[]): number {
  const { Joint, Position, Rotation } = world.components;
  const place = (body: number, x: number, y: number) => {
    const [c, s] = [Math.cos(Rotation.angle[body]), Math.sin(Rotation.angle[body])];
    return [Position.x[body] + c * x - s * y, Position.y[body] + s * x + c * y];
  };
  const gaps = joints.map((joint) => {
    const [ax, ay] = place(Joint.a[joint], Joint.ax[joint], Joint.ay[joint]);
    const [bx, by] = place(Joint.b[joint], Joint.bx[joint], Joint.by[joint]);
    return Math.hypot(bx - ax, by - ay);
  });
  return Math.max(...gaps);
}

describe.each(['f32', 'f64'] as const)('a chain whose slack a heavy load takes up with a jerk, %s', (precision) => {
  it.each([
    [40, 0, 500],
    [22, 0.3, 500],
    [46, 0.7, 500],
    [30, 0, 2500],
    [50, 0.3, 2500],
  ])('of %d links from %d rad, with a density of %d, keeps the load', (links, angle, density) => {
    const world = rigidWorld({ precision });
    const { bodies, joints, length } = chainWithLoad(world, links, angle, density);
    const load = bodies.at(-1) as number;
    const { x, y } = world.components.Position;
    const start = energy(world).total;
    let reach = 0;
    for (let i = 0; i < 900; i++) {
      step(world, DT);
      reach = Math.max(reach, Math.hypot(x[load], y[load]));
      expect(energy(world).total).toBeLessThan(start + 1e-3 * Math.abs(start) + 1);
    }
    // Some centimetres of gaps at a few dozen joints, for a moment.
    expect(reach).toBeLessThan(1.1 * length);
    // Of a swinging chain gaps are below 1 mm, and in f32 not far above.
    expect(largestGap(world, joints)).toBeLessThan(0.005);
  });
});

test('what is pulled apart in free space keeps its centre of mass, and gets no speed', () => {
  const world = rigidWorld({ precision: 'f64', forces: [] });
  const at = (x: number, density: number) =>
    spawn(world, { position: { x }, collider: { shape: circle(0.25), density, mask: 0 } });
  const [a, b, c] = [at(0, 1), at(1, 2), at(2, 5)];
  const joints = [
    createJoint(world, revolute({ a, b, anchor: { x: 0.5 } })),
    createJoint(world, revolute({ a: b, b: c, anchor: { x: 1.5 } })),
  ];
  run(world, 0.1);
  const { Position, Mass, Velocity } = world.components;
  Position.y[c] += 1.5;
  const middle = (axis: 'x' | 'y') => [a, b, c].reduce((sum, id) => sum + Mass.value[id] * Position[axis][id], 0);
  const before = [middle('x'), middle('y')];
  run(world, 3);
  expect(largestGap(world, joints)).toBeLessThan(0.001);
  expect(middle('x')).toBeCloseTo(before[0], 9);
  expect(middle('y')).toBeCloseTo(before[1], 9);
  // Only the last two centimetres are pulled together by velocities, which end with them.
  for (const id of [a, b, c]) expect(Math.hypot(Velocity.x[id], Velocity.y[id])).toBeLessThan(0.05);
});

test('a ball is not moved through a wall after the chain that is drawn out of a slit', () => {
  const world = rigidWorld({ precision: 'f64' });
  for (const side of [-1, 1]) spawn(world, { position: { y: 1.1 * side }, collider: { shape: box(0.3, 2) } });
  const ball = spawn(world, { position: { x: -0.6 }, collider: { shape: circle(0.25), density: 100 } });
  let last = ball;
  for (let i = 0; i < 12; i++) {
    const x = -0.35 + i * LENGTH;
    const collider = { shape: capsule(0.7 * LENGTH, 0.03), density: 100, group: -1 };
    const b = spawn(world, { position: { x: x + LENGTH / 2 }, collider });
    createJoint(world, revolute({ a: last, b, anchor: { x } }));
    last = b;
  }
  // It goes on for a metre after the ball has come to the wall, whatever that takes.
  const hand = spawn(world, {
    position: { x: 2.05 },
    velocity: { x: 2 },
    kinematic: {},
    collider: { radius: 0.01, mask: 0 },
  });
  createJoint(world, revolute({ a: hand, b: last, anchor: { x: 2.05 } }));
  const { Position, Velocity } = world.components;
  for (let i = 0; i < 200; i++) {
    if (Position.x[hand] > 3) Velocity.x[hand] = 0;
    step(world, DT);
    expect(Position.x[ball]).toBeLessThan(-0.15);
  }
});
