import { describe, expect, test } from 'vitest';
import { codeOf, living, run } from '../../../../test/support/emitting.ts';
import { despawn, spawn } from '../bodies/spawn.ts';
import { cos, sin } from '../math/elementary.ts';
import { createPhysicsWorld } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import { burst, createEmitter, setEmitter } from './emitter.ts';
import type { EmitterOptions } from './options.ts';
import { createPattern } from './pattern.ts';

/** A ship in the plane at an angle, turning at `spin`, with a nozzle at its tail that blows backwards. */
function ship(angle: number, spin: number, options: Partial<EmitterOptions> = {}) {
  const world = createPhysicsWorld({ capacity: 2000 });
  const body = spawn(world, {
    position: { x: 5 },
    velocity: {},
    mass: 1,
    rotation: angle,
    angularVelocity: { z: spin },
  });
  const emitter = createEmitter(world, {
    entity: body,
    frame: 'entity',
    offset: { x: -2 },
    direction: { x: -1 },
    spread: 0,
    speed: 3,
    lifetime: 100,
    capacity: 500,
    ...options,
  });
  return { world, body, emitter };
}

describe('an emitter in the frame of its body', () => {
  test('blows backwards from its nozzle, at any angle', () => {
    for (const angle of [0, 0.7, -2, 3, 40]) {
      const { world, emitter } = ship(angle, 0);
      burst(emitter, 3);
      step(world, 0.5);
      const { Position, Velocity } = world.components;
      for (const eid of living(emitter)) {
        expect(Velocity.x[eid]).toBeCloseTo(-3 * cos(angle), 12);
        expect(Velocity.y[eid]).toBeCloseTo(-3 * sin(angle), 12);
        expect(Position.x[eid]).toBeCloseTo(5 - 3.5 * cos(angle), 12);
        expect(Position.y[eid]).toBeCloseTo(-3.5 * sin(angle), 12);
      }
    }
  });

  test('turns between two births of one step', () => {
    // 100 births in one turn of 2 rad: each leaves at the angle of its own moment, at rest where the nozzle was.
    const { world, emitter, body } = ship(0, 2, { rate: 100, offset: { x: -1 } });
    run(world, 1, 1 / 5);
    step(world, 1e-9);
    const { Velocity, Rotation } = world.components;
    expect(Rotation.angle[body]).toBeCloseTo(2, 6);
    const angles = living(emitter).map((eid) => Math.atan2(-Velocity.y[eid], -Velocity.x[eid]));
    expect(angles.length).toBeGreaterThanOrEqual(99);
    // Between two rotations 0.4 rad apart the interpolation is off by 0.4³/96 at most.
    angles.forEach((angle, i) => {
      expect(Math.abs(angle - (2 * (i + 1)) / 100)).toBeLessThan(0.4 ** 3 / 96);
    });
  });

  test('passes on the speed of the nozzle, ω × r, if asked', () => {
    const { world, emitter } = ship(0, 0.5, { rate: 1000, speed: 0, inheritVelocity: 1 });
    run(world, 0.02, 0.01);
    step(world, 1e-9);
    const { Velocity } = world.components;
    // 1 m/s, turned by at most ω t.
    for (const eid of living(emitter)) {
      const speed = Math.hypot(Velocity.x[eid], Velocity.y[eid]);
      expect(Math.abs(speed - 1)).toBeLessThan(1e-9);
      expect(Velocity.y[eid]).toBeLessThan(-0.9999);
    }
  });

  test.each([2, 3] as const)('passes on ω × r of the moment of birth, in %iD', (dimensions) => {
    const w = 3;
    const errors = [1 / 15, 1 / 60].map((dt) => {
      const world = createPhysicsWorld({ dimensions, capacity: 500 });
      const turned = dimensions === 2 ? { rotation: 0, inertia: 1 } : { orientation: {}, inertia: 1 };
      const motion = { velocity: { x: 0.5 }, angularVelocity: { z: w } };
      const entity = spawn(world, { position: { x: 7 }, mass: 1, ...turned, ...motion });
      const nozzle = { offset: { x: 1 }, direction: { x: 1 }, spread: 0, speed: 5, inheritVelocity: 1 };
      const emitter = createEmitter(world, {
        capacity: 100,
        rate: 97,
        lifetime: 10,
        entity,
        frame: 'entity',
        ...nozzle,
      });
      run(world, 0.4, dt);
      const { Position, Velocity } = world.components;
      // The i-th was born at time i/97 at angle w i/97: relative to the body, 5 m/s along its arm and w · 1 m across. The
      // last step's births are yet to come.
      return living(emitter).reduce((worst, eid, i) => {
        const [c, s] = [cos((w * (i + 1)) / 97), sin((w * (i + 1)) / 97)];
        const [u, v] = [5 * c - w * s, 5 * s + w * c];
        const age = 0.4 - dt - (i + 1) / 97;
        const [x, y] = [7 + 0.5 * (0.4 - dt) + c + u * age, s + v * age];
        // After a last step of drift.
        const place = Math.hypot(Position.x[eid] - x - dt * (u + 0.5), Position.y[eid] - y - dt * v);
        return Math.max(worst, place, Math.hypot(Velocity.x[eid] - u - 0.5, Velocity.y[eid] - v));
      }, 0);
    });
    // The angle at birth is off by (w dt)³/96 at most, so the velocity of 5.8 m/s by that times 5.8, its place by half of it.
    expect(errors[0]).toBeLessThan((6 * (w / 15) ** 3) / 96);
    expect(errors[1]).toBeLessThan((6 * (w / 60) ** 3) / 96);
  });

  test('turns its spreads and the patterns of bursts', () => {
    const quarter = Math.PI / 2;
    const wide = ship(quarter, 0, { positionSpread: { x: 1 }, velocitySpread: { x: 4 }, speed: 0, offset: {} });
    burst(wide.emitter, 100);
    step(wide.world, 1e-9);
    const { Position, Velocity } = wide.world.components;
    const across = living(wide.emitter).map((eid) => Math.abs(Position.x[eid] - 5) + Math.abs(Velocity.x[eid]));
    expect(Math.max(...across)).toBeLessThan(1e-8);
    expect(Math.max(...living(wide.emitter).map((eid) => Velocity.y[eid]))).toBeGreaterThan(3);

    const patterned = ship(quarter, 0);
    burst(patterned.emitter, 1, { pattern: createPattern(patterned.world, [{ x: 2 }]) });
    step(patterned.world, 1e-9);
    const [eid] = living(patterned.emitter);
    expect(patterned.world.components.Velocity.y[eid]).toBeCloseTo(2, 12);
  });

  test('turns with an Orientation in space', () => {
    const world = createPhysicsWorld({ dimensions: 3, capacity: 100 });
    // A third of a turn about (1, 1, 1) maps x to y, y to z and z to x.
    const orientation = { x: 0.5, y: 0.5, z: 0.5, w: 0.5 };
    const entity = spawn(world, { position: { z: 7 }, velocity: {}, mass: 1, orientation });
    const options = { capacity: 10, entity, spread: 0, speed: 2, lifetime: 9 };
    const jet = createEmitter(world, { ...options, frame: 'entity', offset: { x: 1 }, direction: { y: 1 } });
    const fixed = createEmitter(world, { ...options, offset: { x: 1 }, direction: { y: 1 } });
    for (const emitter of [jet, fixed]) burst(emitter, 1);
    step(world, 1e-9);
    const { Position: p, Velocity: v } = world.components;
    const state = (eid: number) => [p.x[eid], p.y[eid], p.z[eid], v.x[eid], v.y[eid], v.z[eid]];
    state(living(jet)[0]).forEach((value, i) => {
      expect(value).toBeCloseTo([0, 1, 7, 0, 0, 2][i], 7);
    });
    state(living(fixed)[0]).forEach((value, i) => {
      expect(value).toBeCloseTo([1, 0, 7, 0, 2, 0][i], 7);
    });
  });

  test('follows a body without rotation as it is', () => {
    const world = createPhysicsWorld({ capacity: 100 });
    const entity = spawn(world, { position: { x: 1 }, velocity: {}, mass: 1 });
    const emitter = createEmitter(world, { capacity: 5, entity, frame: 'entity', offset: { y: 2 }, speed: 0 });
    burst(emitter, 1);
    step(world, 1e-9);
    const [eid] = living(emitter);
    expect([world.components.Position.x[eid], world.components.Position.y[eid]]).toEqual([1, 2]);
  });

  test('a burst where its turning body was removed has no velocity', () => {
    const world = createPhysicsWorld({ capacity: 100 });
    const entity = spawn(world, { position: {}, velocity: { x: 10 }, mass: 1, rotation: 0, angularVelocity: 5 });
    const options = { frame: 'entity', offset: { y: 2 }, speed: 0, inheritVelocity: 1 } as const;
    const emitter = createEmitter(world, { capacity: 5, entity, ...options });
    for (let i = 0; i < 3; i++) step(world, 1 / 60);
    despawn(world, entity);
    for (let i = 0; i < 3; i++) step(world, 1 / 60);
    burst(emitter, 1);
    step(world, 1 / 60);
    const [eid] = living(emitter);
    const { Velocity } = world.components;
    expect([Velocity.x[eid], Velocity.y[eid]]).toEqual([0, 0]);
  });

  test('is refused without a body, and in the plane with depth', () => {
    const world = createPhysicsWorld({ capacity: 100 });
    expect(codeOf(() => createEmitter(world, { capacity: 5, frame: 'entity' }))).toBe('E_RANGE');
    expect(codeOf(() => createEmitter(world, { capacity: 5, offset: { x: 1 } }))).toBe('E_RANGE');
    expect(codeOf(() => createEmitter(world, { capacity: 5, frame: 'body' as never }))).toBe('E_RANGE');
    const { emitter } = ship(0, 0);
    expect(codeOf(() => setEmitter(emitter, { offset: { z: 1 } }))).toBe('E_RANGE');
    setEmitter(emitter, { offset: { x: -4 } });
    const alone = createEmitter(world, { capacity: 5 });
    expect(codeOf(() => setEmitter(alone, { offset: { x: 1 } }))).toBe('E_RANGE');
  });
});
