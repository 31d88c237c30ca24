/** What users of other engines write, and what does nothing among rigid bodies, gets a warning, once. */
import {
  applyImpulse,
  box,
  createJoint,
  despawn,
  distance,
  entityRef,
  filterJoint,
  isAlive,
  motorJoint,
  type PhysicsWorldOptions,
  revolute,
  rigidBodies,
  spawn,
  spawnCompound,
  step,
  uniformGravity,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { warnedWorld } from '../support/warned-world.ts';

function listen(options: PhysicsWorldOptions = {}) {
  const { world, warnings } = warnedWorld({ preset: rigidBodies, ...options });
  const run = (steps: number, between = () => {}) => {
    for (let i = 0; i < steps; i++) {
      between();
      step(world, 1 / 60);
    }
  };
  const crate = (x = 0) => spawn(world, { position: { x, y: 0.6 }, collider: { shape: box(1, 1), density: 10 } });
  const tile = (x = 0) => spawn(world, { position: { x }, collider: { shape: box(1, 0.2) } });
  return { world, run, crate, tile, messages: () => warnings.map(({ message }) => message) };
}

describe('a kinematic body', () => {
  const lift = { position: {}, velocity: {}, kinematic: {}, collider: { shape: box(4, 0.2), density: 1 } };

  it('that is moved by its Position before each step', () => {
    const { world, run, messages } = listen({ forces: [uniformGravity()] });
    const body = spawn(world, lift);
    run(40, () => {
      world.components.Position.x[body] += 0.01;
    });
    expect(messages()).toEqual([
      'body 1 has no velocity and its Position is written before each step: what lies on it stays behind, and what it hits gets no speed from it.',
    ]);
  });

  it('may move by its Velocity, be put elsewhere now and then, and be a sensor that follows something', () => {
    const { world, run, messages } = listen();
    const { Position, Velocity } = world.components;
    const [body, rare] = [spawn(world, lift), spawn(world, { ...lift, position: { y: 9 } })];
    const sensor = spawn(world, { position: { y: 5 }, velocity: {}, collider: { radius: 1, sensor: 1 } });
    let steps = 0;
    run(100, () => {
      Velocity.x[body] = 1;
      Position.x[sensor] += 0.1;
      if (steps++ % 10 === 0) Position.x[rare] += 1;
    });
    expect(messages()).toEqual([]);
  });
});

describe('a joint', () => {
  it('whose limits are in degrees', () => {
    const { world, crate, messages } = listen();
    createJoint(world, revolute({ b: crate(), anchor: {}, limits: { lower: -45, upper: 45 } }));
    expect(messages()).toEqual(['a hinge has the limit -45 rad, 7 turns, which looks like degrees.']);
  });

  it('may turn several times, and have one limit', () => {
    const { world, crate, messages } = listen();
    createJoint(world, revolute({ b: crate(), anchor: {}, limits: { lower: -6 * Math.PI, upper: 6 } }));
    createJoint(world, revolute({ b: crate(3), anchor: {}, limits: { lower: -1 } }));
    expect(messages()).toEqual([]);
  });

  it('of bodies that never move', () => {
    const { world, run, tile, messages } = listen();
    createJoint(world, revolute({ a: tile(), b: tile(3), anchor: {} }));
    run(2);
    expect(messages()).toEqual([
      'joint 3 moves nothing, because neither of its bodies has a mass that forces can move.',
    ]);
  });

  it('may hold one body that moves to one that does not, and keep two from colliding', () => {
    const { world, run, tile, crate, messages } = listen();
    createJoint(world, revolute({ a: tile(), b: crate(), anchor: {} }));
    createJoint(world, filterJoint({ a: tile(5), b: tile(6) }));
    run(2);
    expect(messages()).toEqual([]);
  });

  it('that has no motor or no limits', () => {
    const { world, run, crate, messages } = listen();
    const { Joint } = world.components;
    const hinge = createJoint(world, revolute({ b: crate(), anchor: {} }));
    const rod = createJoint(world, distance({ b: crate(5), anchorA: { x: 7 } }));
    Joint.motorSpeed[hinge] = 5;
    Joint.upper[rod] = 3;
    run(70);
    expect(messages()).toEqual([
      `Joint.motorSpeed of joint ${hinge} has no effect, because the joint has no motor.`,
      `Joint.lower and Joint.upper of joint ${rod} have no effect, because the joint has no limits.`,
    ]);
  });

  it('whose limits are crossed', () => {
    const { world, run, crate, messages } = listen();
    const { Joint } = world.components;
    const limits = { lower: -0.5, upper: 0.5 };
    const hinge = createJoint(world, revolute({ b: crate(), anchor: {}, limits }));
    run(1);
    Joint.lower[hinge] = 0.5;
    Joint.upper[hinge] = -0.5;
    run(70);
    expect(messages()).toEqual([
      `Joint.lower of joint ${hinge} is 0.5, above Joint.upper, which is -0.5: no place is within such limits.`,
    ]);
  });

  it('may have its motor and its limits turned off, and a motor joint needs neither', () => {
    const { world, run, crate, messages } = listen();
    const { Joint } = world.components;
    const limits = { lower: -1, upper: 1 };
    const hinge = createJoint(world, revolute({ b: crate(), anchor: {}, limits, motor: { speed: 1, max: 1 } }));
    createJoint(world, motorJoint({ b: crate(5), maxForce: 1, maxTorque: 1, spring: { hertz: 0 }, angularSpeed: 1 }));
    Joint.maxMotor[hinge] = 0;
    Joint.hasLimits[hinge] = 0;
    run(70);
    expect(messages()).toEqual([]);
  });

  it('to a body without a position is refused, with what it lacks', () => {
    const { world } = listen();
    const body = spawn(world, { collider: { shape: box(1, 1), density: 1 } });
    expect(() => createJoint(world, revolute({ b: body, anchor: {} }))).toThrow(
      /E_STALE: entity 1 is no body, because it has no Position/,
    );
    expect(() => createJoint(world, revolute({ b: 7, anchor: {} }))).toThrow(/there is no body 7/);
  });
});

it('an impulse on a body that is static or kinematic', () => {
  const { world, tile, messages } = listen();
  const still = tile();
  applyImpulse(world, still, { x: 1 });
  applyImpulse(world, still, { x: 1 });
  expect(messages()).toEqual(['an impulse was applied to body 1, which has no mass and is not moved by it.']);
});

it('the id of a body where isAlive asks for a reference', () => {
  const { world, crate, messages } = listen();
  const body = crate();
  const other = entityRef(world, crate(3));
  expect([isAlive(world, other), isAlive(world, 50 as typeof other), messages().length]).toEqual([true, false, 0]);
  expect(isAlive(world, body as typeof other)).toBe(false);
  expect(messages()).toEqual(['isAlive got 1, which is the id of a body, and not a reference of this world.']);
});

describe('a compound', () => {
  const parts = [{ shape: box(1, 1), density: 1 }];

  it('that has lost its last part', () => {
    const { world, run, messages } = listen();
    const { body, parts: ids } = spawnCompound(world, { parts });
    run(1);
    despawn(world, ids[0]);
    run(2);
    expect(messages()).toEqual([
      `body ${body} has lost the last of its parts, and moves on as a body that meets nothing.`,
    ]);
  });

  it('may lose all parts and go, and get another part', () => {
    const { world, run, messages } = listen();
    const [one, other] = [spawnCompound(world, { parts }), spawnCompound(world, { position: { x: 5 }, parts })];
    run(1);
    despawn(world, one.parts[0]);
    despawn(world, one.body);
    despawn(world, other.parts[0]);
    const part = { position: {}, rotation: 0, collider: { shape: box(1, 1) }, attachment: { body: other.body } };
    spawn(world, part);
    run(2);
    expect(messages()).toEqual([]);
  });
});
