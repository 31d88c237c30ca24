// Motors and springs of joints on which more hangs than their two bodies.
import {
  box,
  createJoint,
  destroyWorld,
  distance,
  energy,
  isAsleep,
  jointPosition,
  jointTorque,
  motorJoint,
  type PhysicsWorld,
  prismatic,
  revolute,
  softStep,
  spawn,
  step,
  weld,
  wheel,
} from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { addBar, DT, G, type Point, rigidWorld, run } from '../../../../test/support/rigid-world.ts';

const awake = softStep({ sleepTime: 0 });

/** A disc at the end of an arm of 1 m without mass that a motor at the origin turns, and a load on a hinge below it. */
function addArm(world: PhysicsWorld, load: number, motor: { speed: number; max: number }) {
  const arm = spawn(world, {
    position: { x: 1 },
    rotation: 0,
    mass: 1,
    inertia: 0.005,
    collider: { radius: 0.1, mask: 0 },
  });
  const hinge = createJoint(world, revolute({ b: arm, anchor: {}, motor }));
  if (load > 0) {
    const weight = spawn(world, {
      position: { x: 1, y: -1 },
      rotation: 0,
      mass: load,
      collider: { radius: 0.1, mask: 0 },
    });
    createJoint(world, revolute({ a: arm, b: weight, anchor: { x: 1 } }));
  }
  return { arm, hinge };
}

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  test.each([0, 5, 30, 300])('a motor that is strong enough holds an arm with %i kg where it is', (load) => {
    const world = rigidWorld({ precision, integrator: awake });
    const needed = G * (1 + load);
    const { arm, hinge } = addArm(world, load, { speed: 0, max: 2 * needed });
    run(world, 5);
    const { x, y } = world.components.Position;
    expect(Math.abs(jointPosition(world, hinge))).toBeLessThan(1e-3);
    expect(Math.hypot(x[arm] - 1, y[arm])).toBeLessThan(1e-3);
    // The load swings a little from the start on.
    expect(Math.abs(jointTorque(world, hinge) / needed - 1)).toBeLessThan(0.01);
    destroyWorld(world);
  });

  test.each([
    [1, 300],
    [10, 10],
  ])('a bar of %i kg with a load of %i kg welded to its end, which a motor holds, does not creep', (bar, load) => {
    const world = rigidWorld({ precision, integrator: awake });
    const arm = spawn(world, { position: { x: 0.5 }, mass: bar, collider: { shape: box(1, 0.1) } });
    const hinge = createJoint(world, revolute({ b: arm, anchor: {}, motor: { speed: 0, max: 1e5 } }));
    const weight = spawn(world, { position: { x: 1 }, mass: load, collider: { shape: box(0.3, 0.3) } });
    createJoint(world, weld({ a: arm, b: weight, anchor: { x: 1 } }));
    run(world, 20);
    expect(Math.abs(jointPosition(world, hinge))).toBeLessThan(1e-4);
    destroyWorld(world);
  });

  test.each([30, 60, 240])('a weight on a rail stays where a motor holds it, at %i steps a second', (rate) => {
    const world = rigidWorld({ precision, integrator: awake });
    const weight = spawn(world, { position: { y: -2 }, rotation: 0, mass: 300, collider: { radius: 0.1 } });
    createJoint(world, prismatic({ b: weight, anchor: { y: -2 }, axis: { y: 1 }, motor: { speed: 0, max: 1e5 } }));
    for (let i = 0; i < 10 * rate; i++) step(world, 1 / rate);
    expect(Math.abs(world.components.Position.y[weight] + 2)).toBeLessThan(1e-5);
    destroyWorld(world);
  });

  test('a winch that holds lets go of no rope, and the ball on it keeps its energy', () => {
    const world = rigidWorld({ precision, integrator: awake });
    const ball = spawn(world, { position: { y: -2 }, velocity: { x: 10 }, mass: 2, collider: { radius: 0.3 } });
    const winch = createJoint(world, distance({ b: ball, anchorA: {}, motor: { speed: 0, max: 1e6 } }));
    const before = energy(world).total;
    run(world, 30);
    // At the bottom it pulls with m (g + v²/r); below, both are pendulums that turn over.
    expect(Math.abs(jointPosition(world, winch) - 2)).toBeLessThan(0.005);
    expect(Math.abs(energy(world).total / before - 1)).toBeLessThan(0.02);
    destroyWorld(world);
  });

  test.each([
    [0.5, 4],
    [0.5, 8],
    [0.2, 8],
  ])('a winch takes in %d m a second of a rope on which a ball swings at %i m/s', (speed, swing) => {
    const world = rigidWorld({ precision, integrator: awake });
    const ball = spawn(world, { position: { y: -5 }, velocity: { x: swing }, mass: 2, collider: { radius: 0.3 } });
    const winch = createJoint(world, distance({ b: ball, anchorA: {}, motor: { speed: -speed, max: 1e6 } }));
    run(world, 2 / speed);
    expect(Math.abs(jointPosition(world, winch) - 3)).toBeLessThan(0.005);
    destroyWorld(world);
  });

  test('a motor that is too weak adds its whole torque: α = (τ - m g l)/(I + m l²)', () => {
    const world = rigidWorld({ precision, integrator: awake });
    const { arm, hinge } = addArm(world, 0, { speed: 10, max: 4 });
    const steps = 6;
    for (let i = 0; i < steps; i++) step(world, DT);
    // While it has turned by less than 0.04 rad, the cosine is 1 to 1e-3.
    const exact = ((4 - G) / 1.005) * steps * DT;
    expect(Math.abs(world.components.AngularVelocity.z[arm] / exact - 1)).toBeLessThan(2e-3);
    expect(Math.abs(jointTorque(world, hinge) - 4)).toBeLessThan(1e-3);
    destroyWorld(world);
  });

  test('a motor brings an arm with a load to its speed and no further', () => {
    const world = rigidWorld({ precision, forces: [], integrator: awake });
    const { arm } = addArm(world, 5, { speed: 3, max: 2000 });
    const { z } = world.components.AngularVelocity;
    let most = 0;
    for (let i = 0; i < 600; i++) {
      step(world, DT);
      most = Math.max(most, z[arm]);
    }
    expect(most).toBeLessThan(3.01);
    expect(Math.abs(z[arm] - 3)).toBeLessThan(0.01);
    destroyWorld(world);
  });

  test.each([10, 1000, 10_000])('a motor of %i N m pushes no more than 1 mrad into a limit', (max) => {
    const world = rigidWorld({ precision, forces: [], integrator: awake });
    const b = spawn(world, { position: { x: 1 }, rotation: 0, mass: 1, inertia: 0.1, collider: { radius: 0.2 } });
    const motor = { speed: 5, max };
    const hinge = createJoint(world, revolute({ b, anchor: {}, limits: { lower: -1, upper: 1 }, motor }));
    for (let i = 0; i < 300; i++) {
      step(world, DT);
      expect(jointPosition(world, hinge)).toBeLessThan(1.001);
    }
    expect(jointPosition(world, hinge)).toBeGreaterThan(0.999);
    destroyWorld(world);
  });

  test.each([1, -1])(
    'the motor of a wheel turns it at its speed (%i) while its suspension rests on a limit',
    (side) => {
      const world = rigidWorld({ precision, integrator: awake });
      const b = spawn(world, { position: {}, rotation: 0, collider: { radius: 0.4, density: 10, mask: 0 } });
      const motor = { speed: 6 * side, max: 100 };
      const spring = { hertz: 0 };
      createJoint(world, wheel({ b, anchor: {}, spring, limits: { lower: -0.1, upper: 0.1 }, motor }));
      run(world, 2);
      const { z } = world.components.AngularVelocity;
      expect(world.components.Position.y[b]).toBeCloseTo(-0.1, 3);
      expect(z[b]).toBeCloseTo(6 * side, 3);
      destroyWorld(world);
    },
  );

  test('what a motor moves does not sleep, however slow it is', () => {
    const world = rigidWorld({ precision });
    const b = spawn(world, { position: {}, rotation: 0, collider: { radius: 0.4, density: 100, mask: 0 } });
    createJoint(world, revolute({ b, anchor: {}, motor: { speed: 0.01, max: 1000 } }));
    run(world, 10);
    expect(Math.abs(world.components.Rotation.angle[b] - 0.1)).toBeLessThan(1e-3);
    expect(isAsleep(world, b)).toBe(false);
    destroyWorld(world);
  });

  test('a crank turns a four-bar linkage at the speed of its motor', () => {
    const world = rigidWorld({ precision, forces: [], integrator: awake });
    // The shortest and the longest bar are together shorter than the two others: Grashof's crank.
    const [p, q]: Point[] = [
      [0, 0.5],
      [2, 1.5],
    ];
    const [crank, coupler, rocker] = [addBar(world, [0, 0], p, 1), addBar(world, p, q, 1), addBar(world, [2, 0], q, 1)];
    createJoint(world, revolute({ b: crank, anchor: {}, motor: { speed: 20, max: 3000 } }));
    createJoint(world, revolute({ a: crank, b: coupler, anchor: { x: p[0], y: p[1] } }));
    createJoint(world, revolute({ a: coupler, b: rocker, anchor: { x: q[0], y: q[1] } }));
    createJoint(world, revolute({ b: rocker, anchor: { x: 2 } }));
    run(world, 1);
    const { z } = world.components.AngularVelocity;
    for (let i = 0; i < 300; i++) {
      step(world, DT);
      expect(Math.abs(z[crank] - 20)).toBeLessThan(0.1);
    }
    destroyWorld(world);
  });

  test.each([0, Math.PI / 4, Math.PI / 2])(
    'springs at the ends of a bar at %f rad have the stiffness m ω²',
    (angle) => {
      const world = rigidWorld({ precision, integrator: awake });
      const collider = { shape: box(2, 0.05), mask: 0 };
      const b = spawn(world, { position: {}, rotation: angle, mass: 1, inertia: 1 / 3, collider });
      const spring = { hertz: 2, dampingRatio: 1 };
      for (const side of [1, -1]) {
        const [x, y] = [side * Math.cos(angle), side * Math.sin(angle)];
        createJoint(world, distance({ b, anchorA: { x, y: y + 3 }, anchorB: { x, y }, spring }));
      }
      run(world, 10);
      const sag = G / (2 * (2 * Math.PI * 2) ** 2);
      expect(Math.abs(world.components.Position.y[b] / -sag - 1)).toBeLessThan(1e-3);
      destroyWorld(world);
    },
  );

  test('a bar that flies about on a spring without damping keeps the energy of both', () => {
    const world = rigidWorld({ precision, forces: [], integrator: awake });
    const collider = { shape: box(2, 0.05), mask: 0 };
    const b = spawn(world, {
      position: { x: 2 },
      rotation: 0,
      velocity: { y: 1 },
      angularVelocity: 2,
      mass: 1,
      inertia: 1 / 3,
      collider,
    });
    createJoint(
      world,
      distance({ b, anchorA: {}, anchorB: { x: 1 }, length: 0.5, spring: { hertz: 1, dampingRatio: 0 } }),
    );
    const { Position, Rotation } = world.components;
    const total = () => {
      const end = Rotation.angle[b];
      const length = Math.hypot(Position.x[b] - Math.cos(end), Position.y[b] - Math.sin(end));
      return energy(world).kinetic + ((2 * Math.PI) ** 2 * (length - 0.5) ** 2) / 2;
    };
    const start = total();
    for (let i = 0; i < 60 * 60; i++) {
      step(world, DT);
      // A symplectic step of the length h errs by h ω/2, here 1.3 % of what goes to and fro; it does not add up.
      expect(Math.abs(total() / start - 1)).toBeLessThan(0.05);
    }
    destroyWorld(world);
  });

  test('a motor joint between two free bodies that are far apart changes no angular momentum', () => {
    const world = rigidWorld({ precision, forces: [], integrator: awake });
    const body = (x: number, vy: number, w: number) =>
      spawn(world, {
        position: { x },
        rotation: 0,
        velocity: { y: vy },
        angularVelocity: w,
        mass: 1 + x,
        inertia: 0.5,
        collider: { radius: 0.2, mask: 0 },
      });
    const [a, b] = [body(0, 1, 0.5), body(1, -0.3, -1)];
    createJoint(
      world,
      motorJoint({ a, b, target: { x: 0.2, y: 0.4 }, maxForce: 50, maxTorque: 20, spring: { hertz: 2 } }),
    );
    const { Position, Velocity, AngularVelocity, Mass } = world.components;
    const momentum = () =>
      [a, b].reduce(
        (sum, i) =>
          sum +
          Mass.value[i] * (Position.x[i] * Velocity.y[i] - Position.y[i] * Velocity.x[i]) +
          0.5 * AngularVelocity.z[i],
        0,
      );
    const start = momentum();
    for (let i = 0; i < 300; i++) {
      step(world, DT);
      // Positions change between the sub-steps by which impulses are measured: rounding is all that is left.
      expect(Math.abs(momentum() - start)).toBeLessThan(precision === 'f32' ? 1e-4 : 1e-3);
    }
    destroyWorld(world);
  });
});
