// A motor that cannot reach its speed is a torque, also when its speed changes sign: what learns to walk gives torques so.
import {
  box,
  createJoint,
  createPhysicsWorld,
  destroyWorld,
  revolute,
  rigidBodies,
  spawn,
  step,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';

const DT = 1 / 60;
const TORQUE = 1;

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  it.each([4, 100, 1000])(
    'a motor whose speed of %d rad/s changes sign in every step turns a rod by its torque',
    (speed) => {
      const world = createPhysicsWorld({ preset: rigidBodies, precision, capacity: 10, forces: [] });
      const rod = spawn(world, { position: { x: 0.5 }, mass: 1, collider: { shape: box(1, 0.05), mask: 0 } });
      const joint = createJoint(world, revolute({ b: rod, anchor: {}, motor: { speed, max: TORQUE } }));
      const { AngularVelocity, Inertia, Joint, Position } = world.components;
      // About the hinge, by Steiner's theorem. The hinge is a spring of 72 Hz: the rod turns as if its centre were 1e-3 farther out.
      const inertia = Inertia.value[rod] + 0.5 ** 2;
      for (let i = 0; i < 120; i++) {
        const sign = i % 3 === 0 ? -1 : 1;
        Joint.motorSpeed[joint] = sign * speed;
        const before = AngularVelocity.z[rod];
        step(world, DT);
        const change = (sign * TORQUE * DT) / inertia;
        expect(Math.abs(AngularVelocity.z[rod] - before - change)).toBeLessThan(2e-3 * Math.abs(change));
      }
      expect(Math.abs(Math.hypot(Position.x[rod], Position.y[rod]) - 0.5)).toBeLessThan(1e-3);
      destroyWorld(world);
    },
  );
});
