// What bodies of one mechanism exert on each other makes no angular momentum, however hard and long motors press them together.
import {
  angularMomentum,
  box,
  capsule,
  circle,
  createJoint,
  destroyWorld,
  energy,
  type PhysicsWorld,
  revolute,
  spawn,
  springs,
  step,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { rigidWorld, run } from '../../../../test/support/rigid-world.ts';

const SECONDS = 10;
/** The largest change of the angular momentum, as a part of the angular impulse of a motor: rounding in f32, step by step. */
const PART = 1e-6;
/** Of f32, in some hundred steps. */
const ROUNDING = 1e-5;
/** At which two discs go round each other, rad/s. */
const ORBIT = 2;

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  const weightless = () => rigidWorld({ precision, forces: [] });

  /** Bodies that met within a second are pressed together from then on. */
  function expectNoTurn(world: PhysicsWorld, torque: number): void {
    run(world, 1);
    const start = angularMomentum(world).z;
    run(world, SECONDS);
    expect(Math.abs(angularMomentum(world).z - start)).toBeLessThan(PART * torque * SECONDS);
    destroyWorld(world);
  }

  const legs = { boxes: box(1, 0.2), capsules: capsule(0.8, 0.1) };
  const blades = { boxes: box(1, 0.1), capsules: capsule(0.9, 0.05) };

  it.each([
    ['boxes', 0, 0],
    ['boxes', 0, 0.5],
    ['boxes', 0.05, 0],
    ['capsules', 0, 0],
    ['capsules', 0, 0.5],
    ['capsules', 0.05, 0],
  ] as const)(
    'two legs of %s press each other below a torso, one lower by %f m, with e = %f',
    (kind, lower, restitution) => {
      const torque = 40;
      const world = weightless();
      const torso = spawn(world, { position: {}, collider: { shape: box(0.6, 0.3), density: 55 }, neverSleep: {} });
      for (const side of [-1, 1]) {
        const y = side === 1 ? -2 * lower : 0;
        const leg = spawn(world, {
          position: { x: side * 0.25, y: -0.6 + y },
          rotation: Math.PI / 2,
          collider: { shape: legs[kind], density: 10, friction: 0.6, restitution },
        });
        const anchor = { x: side * 0.25, y: -0.15 + y };
        createJoint(world, revolute({ a: torso, b: leg, anchor, motor: { speed: -2 * side, max: torque } }));
      }
      expectNoTurn(world, torque);
    },
  );

  /** A world with boxes of 1 m side by side that turn at `w` as one body and that a spring pulls together, N/m at 1 m. */
  function pulledTogether(
    w: number,
    stiffness: number,
    material: { readonly friction: number; readonly restitution?: number },
  ) {
    const world = rigidWorld({ precision, forces: [springs()] });
    const [a, b] = [-0.5, 0.5].map((x) =>
      spawn(world, {
        position: { x },
        velocity: { y: w * x },
        angularVelocity: w,
        collider: { shape: box(1, 1), density: 1, ...material },
      }),
    );
    spawn(world, { spring: { a, b, stiffness, length: 0 } });
    return world;
  }

  it.each([0.5, 5])('two boxes that a spring pulls together go on turning at %f rad/s', (w) => {
    const world = pulledTogether(w, 200, { friction: 0.6 });
    run(world, 10);
    // Both boxes turn about what lies between them: 2 (1/6 + 1/4) kg m².
    expect(Math.abs(angularMomentum(world).z / ((5 / 6) * w) - 1)).toBeLessThan(1e-4);
    destroyWorld(world);
  });

  /** Two smooth discs that a spring presses together go round each other: by how much their orbit loses in a second, once they are. */
  function lossOfOrbit(dt: number, restitution: number): number {
    const world = rigidWorld({ precision, forces: [springs()] });
    const [a, b] = [-0.5, 0.5].map((x) =>
      spawn(world, {
        position: { x },
        velocity: { y: ORBIT * x },
        angularVelocity: 0,
        collider: { shape: circle(0.5), density: 1, restitution },
      }),
    );
    spawn(world, { spring: { a, b, stiffness: 50, length: 0 } });
    const { Position, Velocity, AngularVelocity } = world.components;
    const orbit = () => {
      for (let i = 0; i < 1 / dt; i++) step(world, dt);
      const [x, y] = [Position.x[b] - Position.x[a], Position.y[b] - Position.y[a]];
      return x * (Velocity.y[b] - Velocity.y[a]) - y * (Velocity.x[b] - Velocity.x[a]);
    };
    const loss = 1 - (1 / orbit()) * orbit();
    // What is smooth cannot be turned; without restitution the solver keeps the sum, and gives spin what the orbit has lost.
    if (restitution > 0) expect(Math.abs(AngularVelocity.z[a]) + Math.abs(AngularVelocity.z[b])).toBeLessThan(ROUNDING);
    else expect(Math.abs(angularMomentum(world).z / ((Math.PI / 8) * ORBIT) - 1)).toBeLessThan(ROUNDING);
    destroyWorld(world);
    return loss;
  }

  // The impulse μ ω² D dt that keeps them on their circle acts within half a step of where its normal is, which costs a part ω² dt/2 a
  // second. With normals of the start of a step the force F that presses them would cost F 6 ms/(μ D) more, four fifths in a second.
  it.each([
    [0, 1 / 60],
    [0, 1 / 120],
    [0.3, 1 / 60],
    [0.3, 1 / 120],
  ])('two smooth discs with a restitution of %f go on round each other, in steps of %f s', (restitution, dt) => {
    expect(Math.abs(lossOfOrbit(dt, restitution))).toBeLessThan((ORBIT ** 2 * dt) / 2);
  });

  // With normals that lag by the 6 ms of half a step, 100 N pushed the boxes along their way: 1.7 J became 29 J in eight seconds.
  it.each([0.5, 2, 5])('two smooth boxes that a spring pulls together at %f rad/s gain no energy', (w) => {
    const world = pulledTogether(w, 100, { friction: 0, restitution: 0 });
    run(world, 1);
    const { total, kinetic } = energy(world);
    run(world, 7);
    expect(Math.abs(energy(world).total - total)).toBeLessThan(0.01 * kinetic);
    expect(Math.abs(energy(world).kinetic / kinetic - 1)).toBeLessThan(0.01);
    destroyWorld(world);
  });

  // With levers of the start of the step, which lag by 6 ms, 100 N at 1 m took 100 N m 6 ms/(5/6 kg m²) of the turning a second, three
  // quarters. They follow once the boxes are pressed together.
  it.each([
    [0.5, 0.1, 0],
    [2, 0.1, 0.6],
    [2, 0.9, 0],
    [5, 0.9, 0.6],
  ])(
    'two boxes that a spring pulls together at %f rad/s go on turning with e = %f and a friction of %f',
    (...options) => {
      const [w, restitution, friction] = options;
      const world = pulledTogether(w, 100, { friction, restitution });
      run(world, 1);
      const { z } = angularMomentum(world);
      run(world, 7);
      expect(Math.abs(angularMomentum(world).z / z - 1)).toBeLessThan(1e-4);
      destroyWorld(world);
    },
  );

  // With levers of the start of each step boxes lose nine tenths, capsules a third. What is left to lose are the bounces until the
  // heap has settled.
  it.each([
    ['boxes', (size: number) => box(size, 1.4 - size)],
    ['capsules', (size: number) => capsule(size, 0.2)],
  ] as const)('a heap of %s that springs pull to a disc goes on turning with e = 0.5', (_, shapeOf) => {
    const world = rigidWorld({ precision, forces: [springs()] });
    const surface = { density: 1, friction: 0.5, restitution: 0.5 };
    const hub = spawn(world, { position: {}, velocity: {}, angularVelocity: 0, collider: { radius: 0.5, ...surface } });
    for (let i = 0; i < 20; i++) {
      const [r, angle] = [1.5 + 0.1 * i, i * Math.PI * (3 - Math.sqrt(5))];
      const [x, y] = [r * Math.cos(angle), r * Math.sin(angle)];
      const collider = { shape: shapeOf(0.4 + 0.03 * i), ...surface };
      const b = spawn(world, { position: { x, y }, rotation: i, velocity: { x: -y, y: x }, collider, neverSleep: {} });
      spawn(world, { spring: { a: hub, b, stiffness: 20, length: 0 } });
    }
    run(world, 2);
    const { z } = angularMomentum(world);
    run(world, SECONDS);
    expect(Math.abs(angularMomentum(world).z / z - 1)).toBeLessThan(2e-3);
    destroyWorld(world);
  });

  it('a smooth disc that is pressed to a box that turns is not turned', () => {
    const world = rigidWorld({ precision, forces: [springs()] });
    const plank = spawn(world, { position: {}, angularVelocity: 2, collider: { shape: box(4, 0.5), density: 1 } });
    const disc = spawn(world, {
      position: { y: 0.5 },
      velocity: {},
      angularVelocity: 0,
      collider: { shape: circle(0.25), density: 1 },
    });
    spawn(world, { spring: { a: plank, b: disc, stiffness: 50, length: 0 } });
    const start = angularMomentum(world).z;
    run(world, 1);
    expect(Math.abs(world.components.AngularVelocity.z[disc])).toBeLessThan(ROUNDING);
    expect(Math.abs(angularMomentum(world).z / start - 1)).toBeLessThan(1e-4);
    destroyWorld(world);
  });

  it.each([
    ['boxes', 1],
    ['boxes', 5],
    ['capsules', 1],
    ['capsules', 5],
  ] as const)('scissors of %s of 1 : %d stay shut', (kind, ratio) => {
    const torque = 100;
    const world = weightless();
    const blade = (angle: number, density: number) =>
      spawn(world, {
        position: { x: 0.5 * Math.sin(angle) + 0.06 * Math.sign(angle), y: -0.5 * Math.cos(angle) },
        rotation: angle + Math.PI / 2,
        collider: { shape: blades[kind], density, friction: 0.6 },
        neverSleep: {},
      });
    const [a, b] = [blade(-0.3, 10), blade(0.3, 10 * ratio)];
    createJoint(world, revolute({ a, b, anchor: { y: 0.02 }, collide: true, motor: { speed: -2, max: torque } }));
    expectNoTurn(world, torque);
  });
});
