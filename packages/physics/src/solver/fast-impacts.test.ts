// Bodies meet what is in their way where and when they should, fast or slow: the normal is that of the impact.
import { box, createPhysicsWorld, rigidBodies, softStep, spawn, step } from '@principia/physics';
import { describe, expect, test } from 'vitest';

const DT = 1 / 60;
const DEGREE = Math.PI / 180;

/** The direction in which a ball of radius r leaves a round body at rest of radius R that it meets at a distance b from its middle. */
function deflect(
  precision: 'f32' | 'f64',
  { r, R, b, speed, x }: Record<'r' | 'R' | 'b' | 'speed' | 'x', number>,
): number {
  const world = createPhysicsWorld({ preset: rigidBodies, precision, capacity: 10 });
  spawn(world, { position: {}, collider: { radius: R, restitution: 1 } });
  const ball = spawn(world, { position: { x, y: b }, velocity: { x: speed }, collider: { radius: r, density: 100 } });
  const { Velocity } = world.components;
  for (let i = 0; i < 60 && Velocity.y[ball] === 0; i++) step(world, DT);
  // Where it comes near in the last sub-step it is only slowed, and bounces in the next step.
  step(world, DT);
  return Math.atan2(Velocity.y[ball], Velocity.x[ball]);
}

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  test.each([25, 40, 100])(
    'a ball of 0.1 m at %d m/s leaves a static disc as the normal of the impact says',
    (speed) => {
      const r = 0.1;
      const R = 0.4;
      for (let k = 0; k < 24; k++) {
        const b = (0.05 + 0.07 * (k % 12)) * (r + R);
        const angle = Math.asin(b / (r + R));
        const direction = deflect(precision, { r, R, b, speed, x: -5 - 0.13 * k });
        // An impact counts where the surfaces come within the slop of 5 mm, met to a quarter.
        const early = Math.asin(b / (r + R)) - Math.asin(b / (r + R + 1.25 * 0.005));
        expect(Math.abs(direction - (Math.PI - 2 * angle)), `at ${b} m`).toBeLessThan(2 * early + 0.1 * DEGREE);
      }
    },
  );

  test('a bullet stays in front of a plank that comes towards it', () => {
    for (const speed of [20, 100]) {
      for (const approach of [10, 30]) {
        for (let k = 0; k < 12; k++) {
          const world = createPhysicsWorld({ preset: rigidBodies, precision, capacity: 10 });
          const { Position, Velocity } = world.components;
          const plank = spawn(world, {
            position: { x: 3 },
            velocity: { x: -approach },
            collider: { shape: box(0.05, 2), density: 500, ...(k % 2 === 0 ? {} : { bullet: true }) },
          });
          const ball = spawn(world, {
            position: { x: -1 - 0.13 * k, y: 0.3 },
            velocity: { x: speed },
            collider: { radius: 0.05, density: 50, bullet: true },
          });
          for (let i = 0; i < 20; i++) {
            step(world, DT);
            if (Velocity.x[ball] < 0) break;
            expect(Position.x[ball], `${speed} and ${approach} m/s, ${k}`).toBeLessThan(Position.x[plank]);
          }
          expect(Velocity.x[ball]).toBeLessThan(0.5 * speed);
        }
      }
    }
  });

  test('small bullets meet, also where they only graze each other', () => {
    const r = 0.02625;
    for (let k = 0; k < 60; k++) {
      const b = (k % 20) * 0.049 * 2 * r;
      const world = createPhysicsWorld({ preset: rigidBodies, precision, capacity: 10 });
      const { Velocity } = world.components;
      const collider = { radius: r, restitution: 1, bullet: true } as const;
      spawn(world, { position: { x: -1 - 0.0037 * k, y: -b }, velocity: { x: 21 }, mass: 0.14, collider });
      const struck = spawn(world, { position: {}, mass: 0.14, collider });
      for (let i = 0; i < 12; i++) step(world, DT);
      // Equal masses and e = 1: it takes the velocity along the line of centres.
      const expected = 21 * Math.sqrt(1 - (b / (2 * r)) ** 2);
      const speed = Math.hypot(Velocity.x[struck], Velocity.y[struck]);
      expect(Math.abs(speed - expected), `at ${b} m`).toBeLessThan(0.1 * 21);
    }
  });

  /** A world in which slow impacts bounce, too. */
  const slowWorld = () =>
    createPhysicsWorld({
      preset: rigidBodies,
      precision,
      capacity: 10,
      integrator: softStep({ restitutionThreshold: 0.01 }),
    });

  // Two discs meet where the surfaces are 0.1 mm apart, so that the line of centres is turned by as much as it will turn until they touch.
  const early = (b: number, radii: number) => Math.asin(Math.abs(b) / radii) - Math.asin(Math.abs(b) / (radii + 1e-4));

  test.each([0.3, 0.6, 1, 1.5, 2, 3, 6, 12].flatMap((speed) => [60, 120].map((rate) => [speed, rate] as const)))(
    'a snooker ball that is struck at %d m/s leaves along the line of centres, at %d Hz',
    (speed, rate) => {
      const r = 0.02625;
      for (let k = 0; k < 40; k++) {
        const b = ((k % 20) - 9.5) * 0.09 * 2 * r;
        const world = slowWorld();
        const { Velocity } = world.components;
        const collider = { radius: r, restitution: 0.95, friction: 0 } as const;
        const start = -0.2 - ((speed / rate) * (k % 13)) / 13;
        spawn(world, { position: { x: start, y: -b }, velocity: { x: speed }, mass: 0.14, collider });
        const struck = spawn(world, { position: {}, mass: 0.14, collider });
        for (let i = 0; i < (0.25 * rate) / speed + 6; i++) step(world, 1 / rate);
        const angle = Math.atan2(Velocity.y[struck], Velocity.x[struck]);
        const error = Math.abs(angle - Math.asin(b / (2 * r)));
        expect(error, `at ${b} m`).toBeLessThan(early(b, 2 * r) + 0.1 * DEGREE);
      }
    },
  );

  test.each([0.3, 0.6, 1, 1.19, 1.5])('a slow ball at %d m/s leaves a bumper by the law of reflection', (speed) => {
    for (const r of [0.05, 0.1, 0.15]) {
      for (let k = 0; k < 20; k++) {
        const b = (0.5 + 0.4 * (k % 2)) * 2 * r;
        const world = slowWorld();
        const { Velocity } = world.components;
        const collider = { radius: r, restitution: 1 };
        const start = -2 * r - 0.1 - ((speed / 60) * k) / 20;
        const ball = spawn(world, { position: { x: start, y: b }, velocity: { x: speed }, mass: 1, collider });
        spawn(world, { position: {}, collider });
        for (let i = 0; i < (60 * (2 * r + 0.15)) / speed; i++) step(world, DT);
        const direction = Math.atan2(Velocity.y[ball], Velocity.x[ball]);
        const error = Math.abs(direction - (Math.PI - 2 * Math.asin(b / (2 * r))));
        expect(error, `a ball of ${r} m at ${b} m`).toBeLessThan(2 * early(b, 2 * r) + 0.1 * DEGREE);
        expect(Math.hypot(Velocity.x[ball], Velocity.y[ball])).toBeCloseTo(speed, 5);
      }
    }
  });
});
