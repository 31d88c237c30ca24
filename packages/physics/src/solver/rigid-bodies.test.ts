// Physics of single rigid bodies and small stacks, against their analytic solutions.
import {
  angularDrag,
  angularMomentum,
  applyImpulse,
  box,
  linearDrag,
  momentum,
  softStep,
  spawn,
  springs,
  step,
  uniformGravity,
} from '@principia/physics';
import { describe, expect, it, test } from 'vitest';
import { DT, G, rigidWorld, run, SLOP } from '../../../../test/support/rigid-world.ts';

/** A static slab whose top is at y = 0, or the line through the origin that rises by `angle`. */
function addGround(world: ReturnType<typeof rigidWorld>, material: object = { friction: 0.6 }, angle = 0): number {
  const position = { x: 0.5 * Math.sin(angle), y: -0.5 * Math.cos(angle) };
  return spawn(world, { position, rotation: angle, collider: { shape: box(200, 1), ...material } });
}

describe.each(['f32', 'f64'] as const)('a rigid body in %s', (precision) => {
  it('rests on the ground: it sinks in by less than the slop and does not drift', () => {
    const world = rigidWorld({ precision });
    addGround(world);
    const body = spawn(world, { position: { y: 0.5 }, collider: { shape: box(1, 1), density: 1, friction: 0.6 } });
    run(world, 3);
    const { Position, Rotation, Velocity } = world.components;
    expect(Math.abs(Position.y[body] - 0.5)).toBeLessThan(SLOP);
    expect(Math.abs(Position.x[body])).toBeLessThan(1e-4);
    expect(Math.abs(Rotation.angle[body])).toBeLessThan(1e-4);
    expect(Math.hypot(Velocity.x[body], Velocity.y[body])).toBeLessThan(1e-3);
  });

  it('slides down a slope steeper than the angle of friction, with g (sin θ - μ cos θ), and stays on another', () => {
    const angle = 0.4;
    for (const [mu, acceleration] of [
      [0.2, G * (Math.sin(angle) - 0.2 * Math.cos(angle))],
      [0.6, 0],
    ]) {
      const world = rigidWorld({ precision });
      addGround(world, { friction: mu }, angle);
      const along = { x: -Math.cos(angle), y: -Math.sin(angle) };
      const position = { x: -0.25 * Math.sin(angle), y: 0.25 * Math.cos(angle) };
      const body = spawn(world, {
        position,
        rotation: angle,
        collider: { shape: box(1, 0.5), density: 1, friction: mu },
      });
      run(world, 1);
      const { x, y } = world.components.Velocity;
      // A sub-step is 1/240 s: friction starts one of them late.
      expect(x[body] * along.x + y[body] * along.y).toBeCloseTo(acceleration, 1);
    }
  });

  it('bounces to e² of the height it fell from', () => {
    const world = rigidWorld({ precision });
    addGround(world, { restitution: 0.5 });
    const height = 4;
    const body = spawn(world, { position: { y: height + 0.5 }, collider: { radius: 0.5, density: 1 } });
    const { Position, Velocity } = world.components;
    while (Velocity.y[body] <= 0) step(world, DT);
    let top = 0;
    while (Velocity.y[body] > 0) {
      step(world, DT);
      top = Math.max(top, Position.y[body] - 0.5);
    }
    // The impact is known to a step, in which the body moves v dt; heights are as v².
    const speed = Math.sqrt(2 * G * height);
    expect(Math.abs(top - 0.25 * height)).toBeLessThan(0.25 * 2 * speed * DT);
  });

  it('bounces flat where it falls flat, to e² of the height', () => {
    const world = rigidWorld({ precision });
    addGround(world, { restitution: 0.5 });
    const height = 4;
    const body = spawn(world, { position: { y: height + 0.1 }, collider: { shape: box(4, 0.2), density: 1 } });
    const { Position, Rotation, Velocity } = world.components;
    while (Velocity.y[body] <= 0) step(world, DT);
    let top = 0;
    while (Velocity.y[body] > 0) {
      step(world, DT);
      top = Math.max(top, Position.y[body] - 0.1);
    }
    expect(Math.abs(top - 0.25 * height)).toBeLessThan(0.25 * 2 * Math.sqrt(2 * G * height) * DT);
    expect(Math.abs(Rotation.angle[body])).toBeLessThan(0.01);
  });

  it('meets another face to face by the law of elastic collision: (m₁ - m₂)/(m₁ + m₂) and 2 m₁/(m₁ + m₂) of the speed', () => {
    const world = rigidWorld({ precision, forces: [] });
    const material = { shape: box(1, 1), restitution: 1 };
    const a = spawn(world, { position: { x: -2 }, velocity: { x: 3 }, collider: { ...material, density: 1 } });
    const b = spawn(world, { position: { x: 2 }, collider: { ...material, density: 2 } });
    run(world, 2);
    const { AngularVelocity, Velocity } = world.components;
    const digits = precision === 'f64' ? 12 : 5;
    expect(Velocity.x[a]).toBeCloseTo(-1, digits);
    expect(Velocity.x[b]).toBeCloseTo(2, digits);
    expect(AngularVelocity.z[a]).toBeCloseTo(0, digits);
    expect(AngularVelocity.z[b]).toBeCloseTo(0, digits);
  });

  it('keeps momentum and angular momentum in a free collision', () => {
    const world = rigidWorld({ precision, forces: [] });
    const collider = { shape: box(1, 0.5), density: 2, restitution: 0.7, friction: 0.5 };
    spawn(world, { position: { x: -1 }, velocity: { x: 3 }, angularVelocity: 1, collider });
    spawn(world, { position: { x: 1, y: 0.3 }, rotation: 0.5, velocity: { x: -2 }, collider });
    const before = [momentum(world).x, momentum(world).y, angularMomentum(world).z];
    run(world, 2);
    const after = [momentum(world).x, momentum(world).y, angularMomentum(world).z];
    const epsilon = precision === 'f32' ? 1e-5 : 1e-12;
    expect(Math.abs(after[0] - before[0])).toBeLessThan(epsilon * 10);
    expect(Math.abs(after[1] - before[1])).toBeLessThan(epsilon * 10);
    // Anchors are those of the start of the step: angular momentum errs by the turn within a step.
    expect(Math.abs(after[2] - before[2])).toBeLessThan(0.05);
    expect(world.components.Velocity.x[1]).toBeLessThan(3);
  });

  it('stands in a stack of ten', () => {
    const world = rigidWorld({ precision });
    addGround(world);
    const ids = Array.from({ length: 10 }, (_, i) =>
      spawn(world, { position: { y: 0.5 + i }, collider: { shape: box(1, 1), density: 1, friction: 0.6 } }),
    );
    run(world, 10);
    const { Position, Rotation } = world.components;
    for (const [i, id] of ids.entries()) {
      expect(Math.abs(Position.x[id])).toBeLessThan(0.01);
      expect(Math.abs(Position.y[id] - 0.5 - i)).toBeLessThan((i + 1) * SLOP);
      expect(Math.abs(Rotation.angle[id])).toBeLessThan(0.01);
    }
  });

  it('rolls down a slope without slipping with 2/3 g sin θ', () => {
    const angle = 0.2;
    const world = rigidWorld({ precision });
    addGround(world, { friction: 1 }, angle);
    const collider = { radius: 0.5, density: 1, friction: 1 };
    const position = { x: -0.5 * Math.sin(angle), y: 0.5 * Math.cos(angle) };
    const body = spawn(world, { position, collider });
    run(world, 2);
    const { Velocity, AngularVelocity } = world.components;
    const speed = Math.hypot(Velocity.x[body], Velocity.y[body]);
    const expected = (2 / 3) * G * Math.sin(angle) * 2;
    expect(Math.abs(speed / expected - 1)).toBeLessThan(0.01);
    expect(Math.abs(AngularVelocity.z[body] * 0.5 - speed)).toBeLessThan(0.01 * speed);
  });

  it('stops rolling by rolling resistance, within v² (1 + I/m r²) / 2 μ g', () => {
    const world = rigidWorld({ precision });
    addGround(world, { friction: 1 });
    const collider = { radius: 0.5, density: 1, friction: 1, rollingResistance: 0.1 };
    const body = spawn(world, { position: { y: 0.5 }, velocity: { x: 2 }, angularVelocity: -4, collider });
    run(world, 10);
    // The torque μ_r r N acts on the moment 3/2 m r² about the point of contact.
    const distance = (2 * 2 * 1.5) / (2 * 0.1 * G);
    expect(world.components.Position.x[body] / distance).toBeCloseTo(1, 1);
    expect(Math.abs(world.components.Velocity.x[body])).toBeLessThan(1e-3);
  });

  it('is carried by the surface of a conveyor belt', () => {
    const world = rigidWorld({ precision });
    addGround(world, { friction: 1, tangentSpeed: 1.5 });
    const collider = { shape: box(1, 1), density: 1, friction: 1 };
    const body = spawn(world, { position: { y: 0.5 }, collider });
    run(world, 2);
    expect(world.components.Velocity.x[body]).toBeCloseTo(1.5, 3);
  });

  it('falls through what is on no layer of its mask', () => {
    const world = rigidWorld({ precision });
    addGround(world, { layers: 2 });
    const [through, held] = [1, 3].map((mask) =>
      spawn(world, { position: { x: mask, y: 1 }, collider: { radius: 0.5, density: 1, mask } }),
    );
    run(world, 1);
    expect(world.components.Position.y[through]).toBeLessThan(-1);
    expect(world.components.Position.y[held]).toBeGreaterThan(0.4);
  });

  it('spins by r × J / I after an impulse off its centre, and keeps the spin', () => {
    const world = rigidWorld({ precision, forces: [] });
    const body = spawn(world, { collider: { shape: box(2, 1), density: 3 }, position: {} });
    applyImpulse(world, body, { y: 4 }, { x: 1, y: 0.2 });
    step(world, DT);
    const mass = 6;
    const inertia = (mass * (4 + 1)) / 12;
    const { Velocity, AngularVelocity, Rotation } = world.components;
    expect(Velocity.y[body]).toBeCloseTo(4 / mass, 6);
    expect(AngularVelocity.z[body]).toBeCloseTo(4 / inertia, 6);
    run(world, 1);
    expect(Rotation.angle[body] / ((4 / inertia) * (1 + DT))).toBeCloseTo(1, 4);
  });
});

test('the forces of the world act in every sub-step: drag on a falling body, a spring on a hanging one', () => {
  const integrator = softStep({ sleepTime: 0 });
  const world = rigidWorld({ integrator, forces: [uniformGravity(), linearDrag(), springs(), angularDrag()] });
  const falling = spawn(world, { position: {}, mass: 2, linearDrag: 4, collider: { radius: 0.1 } });
  const post = spawn(world, { position: { x: 5 } });
  const hanging = spawn(world, { position: { x: 5, y: -1 }, mass: 2, linearDrag: 4, collider: { radius: 0.1 } });
  spawn(world, { spring: { a: post, b: hanging, stiffness: 50, length: 1 } });
  const turning = spawn(world, {
    position: { x: 9 },
    angularVelocity: 3,
    angularDrag: 0.5,
    mass: 1,
    inertia: 0.5,
    rotation: 0,
  });
  run(world, 1);
  const { Position, Velocity, AngularVelocity } = world.components;
  // I ω' = -c ω: semi-implicit steps of 1/240 s lose h/2 more per second.
  expect(AngularVelocity.z[turning] / (3 * Math.exp(-1))).toBeCloseTo(1, 2);
  run(world, 9);
  expect(Velocity.y[falling]).toBeCloseTo((-2 * G) / 4, 6);
  expect(Position.y[hanging]).toBeCloseTo(-1 - (2 * G) / 50, 3);
});
