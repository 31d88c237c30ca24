// Motors, limits and pulling joints along the axis that locks leave free: as of a body that is not locked.
import {
  box,
  createJoint,
  type JointInput,
  motorJoint,
  mouseJoint,
  prismatic,
  softStep,
  spawn,
  wheel,
} from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { G, rigidWorld, run } from '../../../../test/support/rigid-world.ts';

const LOCKS = { 'x is locked': { x: true }, 'x and the angle are locked': { x: true, angle: true } };

/** The height after two seconds of a body of 8 kg that begins at 0, m. */
function lift(precision: 'f32' | 'f64', motionLocks: object, join: (b: number) => JointInput): number {
  const world = rigidWorld({ precision, integrator: softStep({ sleepTime: 0 }) });
  const b = spawn(world, { position: { x: 2 }, motionLocks, collider: { shape: box(2, 0.4), density: 10 } });
  createJoint(world, join(b));
  run(world, 2);
  const { Position } = world.components;
  expect(Position.x[b]).toBe(2);
  return Position.y[b] as number;
}

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  describe.each(Object.entries(LOCKS))('where %s', (_, locks) => {
    const along = (more: object) => (b: number) => prismatic({ b, anchor: { x: 2 }, axis: { y: 1 }, ...more });

    test('a prismatic motor along y holds its speed', () => {
      // It gives way by what rounding and softness leave: a thousandth of the way.
      expect(Math.abs(lift(precision, locks, along({ motor: { speed: 0, max: 5000 } })))).toBeLessThan(1e-3);
      expect(Math.abs(lift(precision, locks, along({ motor: { speed: 1, max: 5000 } })) - 2)).toBeLessThan(2e-3);
    });

    test('limits of a prismatic joint and of a wheel along y hold within the slop', () => {
      const limits = { lower: -1, upper: 1 };
      expect(Math.abs(lift(precision, locks, along({ limits })) + 1)).toBeLessThan(0.005);
      // So weak a spring would sag by 25 m.
      const spring = { hertz: 0.1, dampingRatio: 1 };
      const onAxle = (b: number) => wheel({ b, anchor: { x: 2 }, axis: { y: 1 }, spring, limits });
      expect(Math.abs(lift(precision, locks, onAxle) + 1)).toBeLessThan(0.005);
    });

    test('a mouse joint and a motor joint hold the body', () => {
      const spring = { hertz: 5, dampingRatio: 1 };
      // A spring of this frequency is longer by g/(2 π f)² under the weight.
      const sag = G / (2 * Math.PI * spring.hertz) ** 2;
      const byMouse = lift(precision, locks, (b) => mouseJoint({ b, target: { x: 2 }, spring, maxForce: 5000 }));
      expect(Math.abs(byMouse + sag)).toBeLessThan(0.01 * sag);
      const byMotor = lift(precision, locks, (b) => motorJoint({ b, spring, maxForce: 5000, maxTorque: 5000 }));
      expect(Math.abs(byMotor + sag)).toBeLessThan(0.01 * sag);
    });
  });
});
