// Contacts of bodies that turn together: their normals turn, too, also while a manifold is kept.
import { box, contactPoints, spawn, step } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, G, rigidWorld, run } from '../../../../test/support/rigid-world.ts';

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  /** A crate on a bed that is turned about its middle. */
  function tippingBed(friction: number, angularVelocity: number) {
    const world = rigidWorld({ precision });
    const collider = { shape: box(20, 1), friction };
    const bed = spawn(world, { position: {}, velocity: {}, angularVelocity, collider });
    const crate = spawn(world, { position: { y: 1 }, collider: { ...collider, shape: box(1, 1), density: 1 } });
    return { world, bed, crate };
  }

  it('a crate on a bed that tips slides from the angle of friction on, arctan μ', () => {
    const { world, bed, crate } = tippingBed(0.3, 0.02);
    const { Position, Rotation, Velocity } = world.components;
    // Relative to the bed, which carries it at ω r.
    const isSliding = () => Math.abs(Velocity.x[crate] + 0.02 * Position.y[crate]) > 0.02;
    while (!isSliding() && Rotation.angle[bed] < 0.5) step(world, DT);
    // At 0.02 rad/s it has the speed v by which it is seen to slide after t = √(2 v (1 + μ²)^½ / (g ω)).
    const late = 0.02 * Math.sqrt((2 * 0.02) / (G * 0.02));
    expect(Rotation.angle[bed]).toBeGreaterThan(Math.atan(0.3));
    expect(Rotation.angle[bed]).toBeLessThan(Math.atan(0.3) + 2 * late);
  });

  it('the normal of a contact is that of the bed, at every angle', () => {
    const { world, bed, crate } = tippingBed(10, 0.1);
    for (let i = 0; i < 240; i++) {
      step(world, DT);
      const { nx, ny } = contactPoints(world);
      const angle = world.components.Rotation.angle[bed];
      // The points are those from which the last step started, and the crate may turn by a hair against the bed.
      expect(Math.abs(Math.atan2(-nx[0], ny[0]) - angle)).toBeLessThan(0.1 * DT + 1e-3);
    }
    expect(world.components.Rotation.angle[crate]).toBeCloseTo(0.4, 2);
  });

  it('a crate on a bed that has stopped at a slope too steep for it slides with g (sin θ - μ cos θ)', () => {
    const { world, bed, crate } = tippingBed(0.1, 0.1);
    const { AngularVelocity, Velocity } = world.components;
    run(world, 1.9);
    AngularVelocity.z[bed] = 0;
    const speed = () => Math.hypot(Velocity.x[crate], Velocity.y[crate]);
    run(world, 0.1);
    const before = speed();
    run(world, 1);
    expect(speed() - before).toBeCloseTo(G * (Math.sin(0.19) - 0.1 * Math.cos(0.19)), 2);
  });
});

describe.each([0.03, 0.5])('a disc of radius %d m that flies against', (radius) => {
  it.each(['f32', 'f64'] as const)(
    'a floor gets the moment of friction by its radius, in %s: I Δω = r m Δv',
    (precision) => {
      const world = rigidWorld({ precision });
      const collider = { friction: 0.2, restitution: 1 };
      spawn(world, { position: { y: -0.5 }, collider: { ...collider, shape: box(40, 1) } });
      const position = { y: 1.5 + radius };
      const spin = { velocity: { x: 1 }, angularVelocity: 30 };
      const ball = spawn(world, { position, ...spin, collider: { ...collider, radius, density: 1 } });
      const { AngularVelocity, Inertia, Mass, Velocity } = world.components;
      run(world, 0.8);
      expect(Velocity.y[ball]).toBeGreaterThan(0);
      const moment = Inertia.value[ball] * (AngularVelocity.z[ball] - 30);
      const momentum = Mass.value[ball] * (Velocity.x[ball] - 1);
      expect(Math.abs(momentum)).toBeGreaterThan(0);
      expect(moment / momentum / radius).toBeCloseTo(1, 4);
    },
  );
});
