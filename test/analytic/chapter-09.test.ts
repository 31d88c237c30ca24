// Circular motion.
import { discInertia, discMass, energy } from '@principia/physics';
import { expect, test } from 'vitest';
import angularKinematics from '../../packages/scenes/src/examples/ch09/angular-kinematics.ts';
import carBend from '../../packages/scenes/src/examples/ch09/car-bend.ts';
import pendulum from '../../packages/scenes/src/examples/ch09/pendulum.ts';
import satelliteGravity from '../../packages/scenes/src/examples/ch09/satellite-gravity.ts';
import wheelShape from '../../packages/scenes/src/examples/ch09/wheel-shape.ts';
import { forceOn, run, started } from '../support/laws.ts';
import { crossings } from '../support/orbits.ts';

test('ch09-angular-kinematics: v = ωr = 100, T = 2π/ω, a = ω²r = 200', () => {
  const { world, eid, at } = started(angularKinematics);
  expect(forceOn(world, eid).x).toBe(-200);
  run(world, Math.PI, 1e-3);
  expect(at().x).toBeCloseTo(50, 8);
  expect(at().y).toBeCloseTo(0, 7);
});

test('ch09-wheel-shape: the rim turns with I = m (40² + 50²)/2, a disc less a disc', () => {
  const { world, eid } = started(wheelShape);
  const [outer, inner] = [50, 40].map((radius) => ({ mass: discMass(0.01, radius), radius }));
  const inertia = discInertia(outer.mass, outer.radius) - discInertia(inner.mass, inner.radius);
  const mass = outer.mass - inner.mass;
  expect(inertia / (mass * (40 ** 2 + 50 ** 2))).toBeCloseTo(1 / 2, 12);
  expect(world.components.Mass.value[eid] / mass).toBeCloseTo(1, 12);
  run(world, 3);
  expect(world.components.AngularVelocity.z[eid] / ((15_000 * 3) / inertia)).toBeCloseTo(1, 12);
});

test('ch09-satellite-gravity: ω = √(GM/r³), and the geostationary radius', () => {
  const at = (radius: number) => {
    // The Earth is the first body.
    const { world, eid } = started(satelliteGravity, { values: { radius } }, 2);
    return Math.sqrt(-forceOn(world, eid).x / radius);
  };
  expect(at(200)).toBeCloseTo(0.353553, 6);
  expect(at(200)).toBeCloseTo(Math.sqrt(1e6 / 200 ** 3), 9);
  expect((2 * Math.PI) / at(200)).toBeCloseTo(17.7715, 4);
  const geostationary = (1e6 / 0.16) ** (1 / 3);
  expect(geostationary).toBeCloseTo(184.2016, 4);
  expect(at(geostationary)).toBeCloseTo(0.4, 9);
});

test('ch09-car-bend: up to 27.386 it stays on the circle, and slides outwards at higher speed', () => {
  const car = (speed: number) => {
    const { world, eid, at } = started(carBend);
    world.components.Velocity.y[eid] = speed;
    return { world, eid, at, radius: () => Math.hypot(at().x - 200, at().y - 150) };
  };
  const slow = car(10);
  expect(forceOn(slow.world, slow.eid).x).toBeCloseTo(-120, 12);
  run(slow.world, 47.124);
  expect(slow.at().x).toBeCloseTo(275, 2);
  const most = car(100);
  expect(forceOn(most.world, most.eid).x).toBe(-900);
  expect(Math.sqrt(10 * 75)).toBeCloseTo(27.386, 3);
  const near = car(27);
  run(near.world, 20, 1 / 60, () => expect(Math.abs(near.radius() - 75)).toBeLessThan(0.05));
  const fast = car(28);
  run(fast.world, 20, 1 / 240);
  expect(fast.radius()).toBeCloseTo(87.7, 1);
});

test('ch09-pendulum: T = 9.04046 at 30°, v = 73.205, tension 86.60 to 126.79, length 200 for 100 s', () => {
  const { world, eid, at, speed } = started(pendulum);
  const tension = () => {
    const { x, y } = forceOn(world, eid);
    return Math.hypot(x, y - 100);
  };
  expect(tension()).toBeCloseTo(86.6, 2);
  const before = energy(world).total;
  let [fastest, tightest] = [0, 0];
  run(world, 9.04046, 1 / 60, () => {
    fastest = Math.max(fastest, speed());
    tightest = Math.max(tightest, tension());
  });
  expect(at().x).toBeCloseTo(450, 3);
  expect(fastest).toBeCloseTo(73.205, 2);
  expect(tightest).toBeCloseTo(126.79, 2);
  run(world, 91, 1 / 60, () => expect(Math.abs(Math.hypot(at().x - 350, at().y - 50) - 200)).toBeLessThan(0.01));
  expect(energy(world).total / before).toBeCloseTo(1, 6);
  const small = started(pendulum);
  const { Position } = small.world.components;
  [Position.x[small.eid], Position.y[small.eid]] = [350 + 200 * Math.sin(1e-3), 50 + 200 * Math.cos(1e-3)];
  const times = crossings(small.world, () => small.at().x, 350, 20, 1 / 240);
  expect(times[1] - times[0]).toBeCloseTo(8.88577, 4);
});
