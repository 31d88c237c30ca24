// Motors that press into the limits of their joints, however strong they are: what they press is answered and moves nothing, also when
// they are reversed, or when their limits are moved.
import {
  box,
  circle,
  createJoint,
  destroyWorld,
  distance,
  energy,
  type JointInput,
  jointForce,
  jointPosition,
  type PhysicsWorld,
  prismatic,
  revolute,
  spawn,
  step,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, G, rigidWorld, SLOP } from '../../../../test/support/rigid-world.ts';

/** Sub-steps of a step. */
const SUBSTEPS = 4;
/** A limit gives way to what is pressed, 100 m/s of its bodies in a sub-step, by this part (COMPLIANCE). */
const GIVES = 100 * 1e-4;

/** How far a motor of a speed may pass its limit, with sub-steps of h seconds: as it arrives, and as it presses. */
function beyond(speed: number, h: number): number {
  const omega = 2 * Math.PI * Math.min(72, 0.3 / h);
  const damping = 2 * 2 + omega * h;
  // A soft pass leaves a part of the speed for the positions of its sub-step, and what is beyond comes back at the rate ω/a.
  return (speed * h) / (1 + omega * h * damping) + (GIVES * damping) / omega;
}

/** A joint with a motor between two limits. */
interface Drive {
  readonly lower: number;
  readonly upper: number;
  readonly speed: number;
  /** m r²/I about the centre, for what turns about a hinge: in a sub-step a limit is foreseen with the speed v (1 - (v h)² m r²/I). */
  readonly foreseen: number;
  readonly join: (world: PhysicsWorld, max: number) => JointInput;
}

const DRIVES: Readonly<Record<string, Drive>> = {
  flipper: {
    lower: -0.5,
    upper: 0.5,
    speed: 20,
    foreseen: 3,
    join: (world, max) => {
      const b = spawn(world, { position: { x: 0.15 }, mass: 0.5, collider: { shape: box(0.3, 0.04) } });
      return revolute({ b, anchor: {}, limits: { lower: -0.5, upper: 0.5 }, motor: { speed: 20, max } });
    },
  },
  door: {
    lower: 0,
    upper: 2,
    speed: 2,
    foreseen: 0,
    join: (world, max) => {
      const b = spawn(world, { position: { y: 1 }, mass: 40, collider: { shape: box(0.2, 2) } });
      const limits = { lower: 0, upper: 2 };
      return prismatic({ b, anchor: { y: 1 }, axis: { y: 1 }, limits, motor: { speed: 2, max } });
    },
  },
  winch: {
    lower: 1,
    upper: 2,
    speed: 2,
    foreseen: 0,
    join: (world, max) => {
      const b = spawn(world, { position: { y: -2 }, mass: 40, collider: { shape: box(0.2, 0.2) } });
      return distance({ b, anchorA: {}, limits: { lower: 1, upper: 2 }, motor: { speed: -2, max } });
    },
  },
};

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  describe.each(Object.keys(DRIVES))('a %s', (name) => {
    const { lower, upper, speed, foreseen, join } = DRIVES[name] as Drive;

    it.each([30, 60, 120])(
      'that is reversed stays between its limits, and is no faster than its motor, at %d Hz',
      (hz) => {
        const h = 1 / (SUBSTEPS * hz);
        const most = beyond(speed, h) + foreseen * (speed * h) ** 3;
        for (const max of [1e3, 1e4, 1e6, 1e9, 1e12]) {
          const world = rigidWorld({ precision });
          const joint = createJoint(world, join(world, max));
          const { Joint } = world.components;
          let before = jointPosition(world, joint);
          for (let i = 0; i < 9 * hz; i++) {
            Joint.motorSpeed[joint] = i % (3 * hz) < 1.5 * hz ? -speed : speed;
            step(world, 1 / hz);
            const position = jointPosition(world, joint);
            expect(position).toBeGreaterThan(lower - most);
            expect(position).toBeLessThan(upper + most);
            // What falls is caught a sub-step later; and what is beyond its limit comes back.
            expect(Math.abs(position - before) * hz).toBeLessThan(speed + G * h + most * hz);
            before = position;
          }
          // It ends where its motor led.
          expect(Math.abs(before - upper)).toBeLessThan(most);
          destroyWorld(world);
        }
      },
    );
  });

  it.each([30, 60, 120])('a lift whose stop is moved goes on at its speed, at %d Hz', (hz) => {
    const h = 1 / (SUBSTEPS * hz);
    for (const max of [3e3, 1e4, 1e6, 1e9, 1e12]) {
      const world = rigidWorld({ precision });
      const b = spawn(world, { position: {}, mass: 100, collider: { shape: box(1, 1) } });
      const limits = { lower: 0, upper: 1 };
      const joint = createJoint(world, prismatic({ b, anchor: {}, axis: { y: 1 }, limits, motor: { speed: 2, max } }));
      for (let i = 0; i < 2 * hz; i++) step(world, 1 / hz);
      // The limit answers what is pressed: the joint has to carry the weight.
      expect(Math.abs(jointForce(world, joint) / (100 * G) - 1)).toBeLessThan(1e-3);
      world.components.Joint.upper[joint] = 3;
      let before = jointPosition(world, joint);
      for (let i = 0; i < 2 * hz; i++) {
        step(world, 1 / hz);
        const position = jointPosition(world, joint);
        expect((position - before) * hz).toBeLessThan(2 + beyond(2, h) * hz);
        before = position;
      }
      expect(Math.abs(before - 3)).toBeLessThan(beyond(2, h));
      destroyWorld(world);
    }
  });

  it.each([20, 30, 60])('two bodies in free space get the energy of the speed of their motor, at %d Hz', (hz) => {
    for (const max of [1e5, 1e7, 1e9, 1e12]) {
      const world = rigidWorld({ precision, forces: [] });
      const a = spawn(world, { position: {}, mass: 20, collider: { shape: box(1, 1) } });
      const b = spawn(world, { position: { x: 3, y: 0.5 }, mass: 10, collider: { shape: box(1, 1) } });
      const motor = { speed: 2, max };
      const at = { anchor: { x: 3, y: 0.5 }, axis: { x: 1 } };
      const joint = createJoint(world, prismatic({ a, b, ...at, limits: { lower: -1, upper: 1 }, motor }));
      for (let i = 0; i < 9 * hz; i++) {
        world.components.Joint.motorSpeed[joint] = i % (3 * hz) < 1.5 * hz ? 2 : -2;
        step(world, 1 / hz);
        // ½ μ v² with the reduced mass of 20/3 kg; that the bodies turn makes it less.
        expect(energy(world).kinetic).toBeLessThan(((20 / 3) * 2 ** 2) / 2);
        expect(Math.abs(jointPosition(world, joint))).toBeLessThan(1 + beyond(2, 1 / (SUBSTEPS * hz)));
      }
      destroyWorld(world);
    }
  });

  // At rest on its stop a door throws a ball back as fast as it came; at the speed u of its motor by 2 u faster.
  it.each([30, 60, 120])('a door that presses and is struck throws nothing away, at %d Hz', (hz) => {
    for (const max of [1e4, 1e6, 1e9, 1e12]) {
      const world = rigidWorld({ precision, forces: [] });
      const b = spawn(world, { position: { y: 1 }, mass: 100, collider: { shape: box(2, 0.5), restitution: 1 } });
      const limits = { lower: -2, upper: 0 };
      const motor = { speed: 2, max };
      const joint = createJoint(world, prismatic({ b, anchor: { y: 1 }, axis: { y: 1 }, limits, motor }));
      const shape = circle(0.5);
      const ball = spawn(world, {
        position: { y: 6 },
        velocity: { y: -10 },
        mass: 1000,
        collider: { shape, restitution: 1 },
      });
      for (let i = 0; i < 3 * hz; i++) {
        step(world, 1 / hz);
        expect(Math.abs(world.components.Velocity.y[ball] as number)).toBeLessThan(10 + 2 * 2);
      }
      expect(Math.abs(jointPosition(world, joint))).toBeLessThan(beyond(2, 1 / (SUBSTEPS * hz)));
      destroyWorld(world);
    }
  });

  it.each([1e4, 1e6, 1e9, 1e12])(
    'a cylinder of %d N in a net, whose joints are solved one by one, keeps to its limits',
    (max) => {
      const world = rigidWorld({ precision });
      const n = 10;
      const nodes = Array.from({ length: n * n }, (_, i) =>
        spawn(world, { position: { x: i % n, y: -Math.floor(i / n) }, mass: 1, collider: { radius: 0.1, mask: 0 } }),
      );
      for (const [i, node] of nodes.entries()) {
        if (i < n) createJoint(world, distance({ b: node, anchorA: { x: i, y: 1 } }));
        else createJoint(world, distance({ a: nodes[i - n] as number, b: node }));
        if (i % n > 0 && i !== n + 2) createJoint(world, distance({ a: nodes[i - 1] as number, b: node }));
      }
      const [a, b] = [nodes[n + 1] as number, nodes[n + 2] as number];
      const joint = createJoint(
        world,
        distance({ a, b, limits: { lower: 0.8, upper: 1.2 }, motor: { speed: 1, max } }),
      );
      const { Joint } = world.components;
      for (let i = 0; i < 540; i++) {
        Joint.motorSpeed[joint] = i % 180 < 90 ? 1 : -1;
        if (i === 360) Joint.upper[joint] = 1.4;
        step(world, DT);
        expect(jointPosition(world, joint)).toBeGreaterThan(0.8 - SLOP);
        expect(jointPosition(world, joint)).toBeLessThan((Joint.upper[joint] as number) + SLOP);
      }
      destroyWorld(world);
    },
  );
});
