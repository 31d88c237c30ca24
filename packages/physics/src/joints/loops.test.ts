// Hinges that close loops: a net that hangs, beside other mechanisms or alone.
import {
  box,
  createJoint,
  destroyWorld,
  energy,
  jointForce,
  type PhysicsWorld,
  revolute,
  softStep,
  spawn,
  step,
} from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { DT, G, rigidWorld, run } from '../../../../test/support/rigid-world.ts';

const EDGE = 6;
const MASS = 2;

/** A net of discs, one metre apart, whose upper corners hang from the world. Returns the discs and the two upper hinges. */
function addNet(world: PhysicsWorld, x: number): { readonly discs: number[]; readonly hangers: number[] } {
  const discs: number[] = [];
  for (let i = 0; i < EDGE * EDGE; i++) {
    const [column, row] = [Math.floor(i / EDGE), i % EDGE];
    const position = { x: x + column, y: -row };
    const disc = spawn(world, {
      position,
      rotation: 0,
      collider: { radius: 0.4, density: MASS / (Math.PI * 0.16), mask: 0 },
    });
    if (row > 0) createJoint(world, revolute({ a: discs[i - 1], b: disc, anchor: { x: x + column, y: 0.5 - row } }));
    if (column > 0)
      createJoint(world, revolute({ a: discs[i - EDGE], b: disc, anchor: { x: x + column - 0.5, y: -row } }));
    discs.push(disc);
  }
  const hangers = [0, EDGE * (EDGE - 1)].map((i) =>
    createJoint(world, revolute({ b: discs[i], anchor: { x: x + i / EDGE, y: 0.4 } })),
  );
  return { discs, hangers };
}

describe.each(['f32', 'f64'] as const)('nets of hinges in %s', (precision) => {
  test('a net at rest hangs from its corners by half its weight each', () => {
    const world = rigidWorld({ precision, integrator: softStep({ sleepTime: 0 }) });
    const { discs, hangers } = addNet(world, 0);
    const { Velocity, AngularVelocity } = world.components;
    // Damped, so that it comes to rest.
    for (let i = 0; i < 1200; i++) {
      step(world, DT);
      for (const disc of discs) {
        Velocity.x[disc] *= 0.97;
        Velocity.y[disc] *= 0.97;
        AngularVelocity.z[disc] *= 0.97;
      }
    }
    const { Position, Joint } = world.components;
    const half = (EDGE * EDGE * MASS * G) / 2;
    for (const hanger of hangers) {
      // The hinge also pulls inwards.
      expect(jointForce(world, hanger)).toBeGreaterThan(0.98 * half);
      expect(jointForce(world, hanger)).toBeLessThan(1.5 * half);
      const disc = Joint.b[hanger];
      expect(Math.abs(Position.y[disc])).toBeLessThan(1);
    }
    destroyWorld(world);
  });

  test('a net ends in the same bits beside a hinge with a spring and a bead with a locked axis', () => {
    const poses = [false, true].map((beside) => {
      const world = rigidWorld({ precision });
      if (beside) {
        const door = spawn(world, { position: { x: -20 }, rotation: 0, collider: { shape: box(1, 0.1), density: 10 } });
        createJoint(world, revolute({ b: door, anchor: { x: -20.5, y: 0 }, spring: { hertz: 2 } }));
        const bead = {
          position: { x: -30 },
          rotation: 0,
          motionLocks: { y: true },
          collider: { radius: 0.2, density: 10 },
        };
        createJoint(world, revolute({ a: door, b: spawn(world, bead), anchor: { x: -30, y: 0 } }));
      }
      const { discs } = addNet(world, 0);
      run(world, 2);
      const { Position, Rotation } = world.components;
      const pose = discs.map((disc) => [Position.x[disc], Position.y[disc], Rotation.angle[disc]]);
      destroyWorld(world);
      return pose;
    });
    expect(poses[1]).toEqual(poses[0]);
  });
});

// Bars of unlike masses, one of them on a pin, whose last hinge closes a loop: what it exerted is far off in the next sub-step.
const BARS = [
  { length: 0.9, density: 60, at: { x: 0, y: 0 } },
  { length: 1.4, density: 900, at: { x: 3, y: 1.8 } },
  { length: 0.5, density: 80, at: { x: 5.4, y: -1.2 } },
  { length: 1.2, density: 700, at: { x: 2.7, y: -4.5 } },
  { length: 0.4, density: 20, at: { x: -1.2, y: -3.6 } },
  { length: 0.6, density: 90, at: { x: -2.1, y: -0.9 } },
];

describe.each(['f32', 'f64'] as const)('a loop of bars of 2 to 250 kg in %s', (precision) => {
  test.each([22, 30, 74, 107, 118, 126])('that is thrown about (%i) gains no energy', (spin) => {
    const world = rigidWorld({ precision });
    const bars = BARS.map(({ length, density, at }, i) =>
      spawn(world, {
        position: at,
        rotation: i * spin,
        velocity: { x: 3 * Math.cos(i * spin), y: 3 * Math.sin(i * spin) },
        angularVelocity: 5 * Math.cos(2 * i + spin),
        collider: { shape: box(length, 0.2), density, mask: 0 },
      }),
    );
    createJoint(world, revolute({ b: bars[0], anchor: BARS[0].at }));
    bars.forEach((b, i) => {
      const [p, q] = [BARS[i].at, BARS[(i + 1) % 6].at];
      createJoint(world, revolute({ a: b, b: bars[(i + 1) % 6], anchor: { x: (p.x + q.x) / 2, y: (p.y + q.y) / 2 } }));
    });
    const before = energy(world).total;
    let most = Number.NEGATIVE_INFINITY;
    for (let i = 0; i < 600; i++) {
      step(world, DT);
      most = Math.max(most, energy(world).total);
    }
    expect(most).toBeLessThan(before);
  });
});
