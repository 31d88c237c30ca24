import { removeEntity } from 'bitecs';
import { describe, expect, test } from 'vitest';
import { codeOf, emitting, living, run } from '../../../../test/support/emitting.ts';
import { despawn, spawn } from '../bodies/spawn.ts';
import { rgba } from '../components/appearance.ts';
import { momentum } from '../diagnostics/energy.ts';
import { stateHash } from '../diagnostics/hash.ts';
import { entityRef, isAlive } from '../ecs/entity-ref.ts';
import { quadraticDrag } from '../forces/drag.ts';
import { uniformGravity } from '../forces/uniform-gravity.ts';
import { cos, sin } from '../math/elementary.ts';
import { createRandom } from '../math/random.ts';
import { mutualGravity } from '../n-body/mutual-gravity.ts';
import { createPhysicsWorld } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import {
  aliveCount,
  burst,
  createEmitter,
  destroyEmitter,
  emitterCounts,
  endings,
  setEmitter,
  setRate,
} from './emitter.ts';
import type { EmitterOptions } from './options.ts';
import { W } from './record.ts';

describe('a particle', () => {
  test('starts at the emitter and moves like a body under gravity and drag', () => {
    const { world, emitter } = emitting(
      { speed: 3, direction: { x: 4, y: 3 }, spread: 0, mass: 2, quadraticDrag: 0.1, lifetime: 10, position: { x: 5 } },
      { forces: [uniformGravity({ y: -10 }), quadraticDrag()] },
    );
    const twin = spawn(world, { position: { x: 5 }, velocity: { x: 2.4, y: 1.8 }, mass: 2, quadraticDrag: 0.1 });
    burst(emitter, 1);
    run(world, 1);
    const [eid] = living(emitter);
    const { Position, Velocity } = world.components;
    expect(Position.x[eid]).toBeCloseTo(Position.x[twin], 12);
    expect(Position.y[eid]).toBeCloseTo(Position.y[twin], 12);
    expect(Velocity.y[eid]).toBeCloseTo(Velocity.y[twin], 12);
  });

  test('feels the gravity of a star, and as a test particle exerts none', () => {
    const fall = (testParticle: boolean) => {
      const { world, emitter } = emitting(
        { speed: 0, mass: 0.5, lifetime: 10, position: { x: 10 }, testParticle },
        { forces: [mutualGravity({ G: 1 })] },
      );
      const star = spawn(world, { position: {}, velocity: {}, mass: 50 });
      burst(emitter, 1);
      run(world, 1);
      const { x } = world.components.Velocity;
      return { star: x[star], particle: x[living(emitter)[0]] };
    };
    // From 10 m, 50 kg draw the particle with 0.5 m/s², more as it approaches.
    expect(fall(true).particle).toBeLessThan(-0.5);
    expect(fall(true).star).toBe(0);
    expect(fall(false).star).toBeGreaterThan(0);
  });

  test('is not interpolated from the end of the previous life of its entity', () => {
    const { world, emitter } = emitting({ capacity: 1, lifetime: 0.05, speed: 100, spread: 0 });
    for (let i = 0; i < 20; i++) {
      burst(emitter, 1);
      step(world, 1 / 60);
      for (const eid of living(emitter)) {
        const way = world.components.Position.y[eid] - world.previous.Position.y[eid];
        expect(way).toBeCloseTo(100 / 60, 9);
      }
    }
    expect(emitterCounts(emitter).ended).toBeGreaterThan(3);
  });

  test('has no mass, speed, size or collider after it ended', () => {
    const collider = { radius: 0.2, restitution: 0.5 };
    const { world, emitter } = emitting({ capacity: 10, size: 2, lifetime: 0.1, collider });
    const { Mass, Velocity, Appearance, Collider } = world.components;
    burst(emitter, 10);
    step(world, 1 / 60);
    for (const eid of emitter.ids) {
      expect([Mass.value[eid], Appearance.size[eid], Collider.radius[eid]]).toEqual([1, 2, 0.2]);
    }
    run(world, 0.2);
    for (const eid of emitter.ids) {
      const row = [Mass.value[eid], Velocity.x[eid], Velocity.y[eid], Appearance.size[eid], Collider.radius[eid]];
      expect(row).toEqual([0, 0, 0, 0, 0]);
    }
    expect(aliveCount(emitter)).toBe(0);
    expect(momentum(world).y).toBe(0);
  });

  test('invalidates references to it when it ends', () => {
    const { world, emitter } = emitting({ capacity: 1, lifetime: 0.1 });
    const idle = entityRef(world, emitter.ids[0]);
    burst(emitter, 1);
    step(world, 0.01);
    const ref = entityRef(world, emitter.ids[0]);
    expect(isAlive(world, ref)).toBe(true);
    expect(isAlive(world, idle)).toBe(false);
    run(world, 0.2, 0.01);
    expect(isAlive(world, ref)).toBe(false);
    burst(emitter, 1);
    step(world, 0.01);
    expect(isAlive(world, ref)).toBe(false);
  });

  test('follows its ramps of colour and size', () => {
    const color = [rgba(1, 0, 0), rgba(0, 1, 0, 0.5), rgba(0, 0, 0, 0)];
    const { world, emitter } = emitting({ capacity: 1, lifetime: 1, color, size: [1, 3, 0], sizeFactor: 2 });
    const [eid] = emitter.ids;
    const { Appearance } = world.components;
    burst(emitter, 1);
    const seen: [number, number][] = [];
    for (let i = 0; i <= 8; i++) {
      step(world, 1 / 8);
      seen.push([Appearance.color[eid], Appearance.size[eid]]);
    }
    expect(seen[0]).toEqual([color[0], 2]);
    const half = rgba(0.5, 0.5, 0, 0.75);
    for (const shift of [0, 8, 16, 24]) {
      expect(Math.abs(((seen[2][0] >>> shift) & 255) - ((half >>> shift) & 255))).toBeLessThanOrEqual(1);
    }
    expect(seen[2][1]).toBe(4);
    expect(seen[4]).toEqual([color[1], 6]);
    expect(seen[6][1]).toBeCloseTo(3, 12);
    expect(seen[7][0]).toBeGreaterThan(0);
    expect(seen[8][1]).toBe(0);
  });

  test.each([
    ['neighbours', 'f32'],
    ['neighbours', 'f64'],
    ['scattered', 'f32'],
    ['scattered', 'f64'],
  ] as const)('shows its age and ends in time where the rows of its pool are %s (%s)', (place, precision) => {
    const world = createPhysicsWorld({ capacity: 100, precision });
    const others = Array.from({ length: 30 }, () => spawn(world, { position: {} }));
    if (place === 'scattered') for (let i = 0; i < 30; i += 3) despawn(world, others[i]);
    // Two groups of four slots, and one more.
    const capacity = 9;
    const color = [rgba(0, 0, 0), rgba(1, 0, 0)];
    const emitter = createEmitter(world, { capacity, lifetime: 1, color, size: [1, 0], mass: 1 });
    const gaps = emitter.ids.slice(1).map((id, i) => id - emitter.ids[i]);
    expect(gaps.every((gap) => gap === 1)).toBe(place === 'neighbours');
    const { Appearance, Mass } = world.components;
    // Particle number i is born at i/8 s; the shades of red are 256 steps of a life.
    for (let now = 0; now <= 16; now++) {
      if (now < capacity) burst(emitter, 1);
      step(world, 1 / 8);
      emitter.ids.forEach((id, i) => {
        const age = (now - i) / 8;
        const lives = age >= 0 && age < 1;
        expect(Mass.value[id], `particle ${i} at ${now / 8} s`).toBe(lives ? 1 : 0);
        expect(Appearance.size[id]).toBe(lives ? 1 - age : 0);
        if (lives) expect(Math.abs((Appearance.color[id] & 255) - 255 * age)).toBeLessThanOrEqual(1);
      });
    }
    expect(emitterCounts(emitter)).toMatchObject({ born: capacity, ended: capacity });
  });

  test.each([Math.PI, 1.5, 1e-9])('leaves at an accurate angle within a spread of %d rad', (spread) => {
    const { emitter, world } = emitting({ capacity: 5000, spread, direction: { x: 1 } });
    const random = createRandom(0);
    random.state.set(emitter.internal.block.record.words.subarray(W.random0, W.random0 + 4));
    burst(emitter, 5000);
    step(world, 1e-9);
    const { x, y } = world.components.Velocity;
    for (const eid of emitter.ids) {
      for (let skipped = 0; skipped < 4; skipped++) random.word();
      const angle = spread * (-1 + 2 * random.uniform());
      expect([x[eid], y[eid]]).toEqual([cos(angle), sin(angle)]);
      for (let skipped = 0; skipped < 6; skipped++) random.word();
    }
  });

  test('has a uniform direction in the wedge in 2D and in the cone in 3D', () => {
    const plane = emitting({ spread: 0.5, direction: { x: 1 } });
    burst(plane.emitter, 1000);
    step(plane.world, 1e-9);
    const angles = living(plane.emitter).map((eid) => {
      const { x, y } = plane.world.components.Velocity;
      return Math.atan2(y[eid], x[eid]);
    });
    expect(Math.max(...angles.map(Math.abs))).toBeLessThanOrEqual(0.5 + 1e-12);
    const mean = angles.reduce((sum, angle) => sum + angle, 0) / 1000;
    expect(Math.abs(mean)).toBeLessThan((3 * 0.5) / Math.sqrt(3 * 1000));
    for (const direction of [{ x: 1 }, { y: 2 }, { z: -3 }, { x: 1, y: 1, z: 1 }]) {
      const space = emitting({ spread: 0.5, direction }, { dimensions: 3 });
      burst(space.emitter, 1000);
      step(space.world, 1e-9);
      const { x = 0, y = 0, z = 0 } = direction as { x?: number; y?: number; z?: number };
      const v = space.world.components.Velocity;
      const cosines = living(space.emitter).map(
        (eid) => (v.x[eid] * x + v.y[eid] * y + v.z[eid] * z) / Math.hypot(x, y, z),
      );
      const low = Math.cos(0.5);
      expect(Math.min(...cosines)).toBeGreaterThan(low - 1e-12);
      const average = cosines.reduce((sum, c) => sum + c, 0) / 1000;
      expect(Math.abs(average - (1 + low) / 2)).toBeLessThan((3 * (1 - low)) / Math.sqrt(12 * 1000));
    }
  });
});

describe('an emitter', () => {
  test('follows its body, passes on its velocity, and stops when the body is removed', () => {
    const world = createPhysicsWorld({ capacity: 1000 });
    const ship = spawn(world, { position: {}, velocity: { x: 10 }, mass: 1 });
    const emitter = createEmitter(world, {
      capacity: 500,
      entity: ship,
      rate: 100,
      speed: 0,
      lifetime: 100,
      inheritVelocity: 0.5,
    });
    run(world, 1, 0.1);
    const ids = living(emitter);
    expect(ids).toHaveLength(90);
    for (const eid of ids) expect(world.components.Velocity.x[eid]).toBeCloseTo(5, 9);
    world.components.Position.x[ship] = Number.NaN;
    step(world, 0.1);
    for (const eid of living(emitter)) expect(Number.isFinite(world.components.Position.x[eid])).toBe(true);
    despawn(world, ship);
    const { born } = emitterCounts(emitter);
    run(world, 1, 0.1);
    expect(emitterCounts(emitter).born).toBe(born);
  });

  test('is the same for the same seed, and differs from other emitters', () => {
    const result = (seed: number) => {
      const world = createPhysicsWorld({ capacity: 1000, seed });
      const [a, b] = [0, 1].map(() => createEmitter(world, { capacity: 100, rate: 50, speed: [1, 2] }));
      run(world, 1);
      const speeds = [a, b].map((e) => living(e).map((eid) => world.components.Velocity.x[eid]));
      expect(speeds[0]).not.toEqual(speeds[1]);
      return stateHash(world);
    };
    expect(result(3)).toBe(result(3));
    expect(result(3)).not.toBe(result(4));
  });

  test('changes at run time; invalid values change nothing', () => {
    const { world, emitter } = emitting({ rate: 10, lifetime: 100, speed: 1 });
    run(world, 1, 0.1);
    setRate(emitter, 100);
    expect(codeOf(() => setRate(emitter, -1))).toBe('E_RANGE');
    expect(codeOf(() => setEmitter(emitter, { rate: 5, speed: Number.NaN }))).toBe('E_NONFINITE');
    expect(codeOf(() => setEmitter(emitter, { capacity: 5 } as never))).toBe('E_UNKNOWN');
    const { born } = emitterCounts(emitter);
    run(world, 1, 0.1);
    expect(emitterCounts(emitter).born - born).toBe(100);
    setEmitter(emitter, { color: rgba(0, 0, 1), size: 3 });
    step(world, 0.1);
    const { color, size } = world.components.Appearance;
    expect(new Set(living(emitter).map((eid) => `${color[eid]} ${size[eid]}`))).toEqual(
      new Set([`${rgba(0, 0, 1)} 3`]),
    );
  });

  test('bursts at a given position, with its own velocity and colours', () => {
    const { world, emitter } = emitting({ color: [[1], [2, 3]], speed: 0, lifetime: 5 });
    burst(emitter, 10, { position: { x: 7 }, velocity: { x: 1, y: 2 }, ramp: 0 });
    step(world, 0.5);
    const { Position, Velocity, Appearance } = world.components;
    const ids = living(emitter);
    expect(ids).toHaveLength(10);
    for (const eid of ids) expect([Position.x[eid], Velocity.y[eid], Appearance.color[eid]]).toEqual([7.5, 2, 1]);
    expect(codeOf(() => burst(emitter, -1))).toBe('E_RANGE');
    expect(codeOf(() => burst(emitter, 1, { ramp: 2 }))).toBe('E_RANGE');
    expect(codeOf(() => burst(emitter, 1, { position: { x: Number.NaN } }))).toBe('E_NONFINITE');
    for (let i = 0; i < 256; i++) burst(emitter, 0);
    expect(codeOf(() => burst(emitter, 1))).toBe('E_CAPACITY');
  });

  test('small emitters take 64 bursts in a step, and a default world has room for a hundred of them', () => {
    const world = createPhysicsWorld({ capacity: 1000 });
    const emitters = Array.from({ length: 100 }, () => createEmitter(world, { capacity: 8, mass: 1 }));
    for (const emitter of emitters) {
      for (let i = 0; i < 64; i++) burst(emitter, 1);
      expect(codeOf(() => burst(emitter, 1))).toBe('E_CAPACITY');
    }
    step(world, 0.01);
    for (const emitter of emitters) {
      expect(aliveCount(emitter)).toBe(8);
      expect(emitterCounts(emitter).dropped).toBe(56);
    }
  });

  test('reports ended particles and their states (ch12-fireworks)', () => {
    const { world, emitter } = emitting({ capacity: 10, reportEndings: true, lifetime: 0.5, speed: 2, spread: 0 });
    const sparks = createEmitter(world, { capacity: 1000, velocitySpread: { x: 75, y: 50 }, speed: 0 });
    burst(emitter, 10);
    let seen = 0;
    for (let i = 0; i < 60; i++) {
      step(world, 1 / 60);
      const { count, states } = endings(emitter);
      for (let k = 0; k < count; k++) {
        expect(states[6 * k + 1]).toBeCloseTo(1, 1);
        expect(states[6 * k + 4]).toBe(2);
        burst(sparks, 10, { position: { x: states[6 * k], y: states[6 * k + 1] } });
      }
      seen += count;
    }
    expect(seen).toBe(10);
    expect(aliveCount(sparks)).toBe(100);
    expect(codeOf(() => endings(sparks))).toBe('E_RANGE');
  });

  test('is not created with invalid options and leaves no trace', () => {
    const world = createPhysicsWorld({ capacity: 100 });
    const hash = stateHash(world);
    const bad: [object, string][] = [
      [{ capacity: 0 }, 'E_RANGE'],
      [{ capacity: 101 }, 'E_RANGE'],
      [{}, 'E_TYPE'],
      [{ capacity: 1, rate: Number.NaN }, 'E_NONFINITE'],
      [{ capacity: 1, rate: -1 }, 'E_RANGE'],
      [{ capacity: 1, lifetime: 0 }, 'E_RANGE'],
      [{ capacity: 1, lifetime: 1e-46 }, 'E_RANGE'],
      [{ capacity: 1, lifetime: [2, 1] }, 'E_RANGE'],
      [{ capacity: 1, lifetime: [1] }, 'E_RANGE'],
      [{ capacity: 1, speed: 'fast' }, 'E_TYPE'],
      [{ capacity: 1, direction: {} }, 'E_RANGE'],
      [{ capacity: 1, position: { z: 1 } }, 'E_RANGE'],
      [{ capacity: 1, spread: 4 }, 'E_RANGE'],
      [{ capacity: 1, mass: 0 }, 'E_RANGE'],
      [{ capacity: 1, color: [1, 2, 3, 4, 5] }, 'E_RANGE'],
      [{ capacity: 1, size: [] }, 'E_RANGE'],
      [{ capacity: 1, quadraticDrag: -1 }, 'E_RANGE'],
      [{ capacity: 1, collider: { radius: 0 } }, 'E_RANGE'],
      [{ capacity: 1, entity: 50 }, 'E_STALE'],
      [{ capacity: 1, whenFull: 'wait' }, 'E_RANGE'],
      [{ capacity: 1, colour: 1 }, 'E_UNKNOWN'],
    ];
    for (const [options, code] of bad) {
      expect(`${JSON.stringify(options)} ${codeOf(() => createEmitter(world, options as EmitterOptions))}`).toBe(
        `${JSON.stringify(options)} ${code}`,
      );
    }
    expect(stateHash(world)).toBe(hash);
    expect(world.lastId).toBe(0);
    expect(codeOf(() => createEmitter(world, { capacity: 60 }))).toBe('nothing');
    expect(codeOf(() => createEmitter(world, { capacity: 60 }))).toBe('E_CAPACITY');
    step(world, 0.1);
  });

  test('is not created inside a step, which says what to do; a burst from there is born in the next', () => {
    const { world, emitter } = emitting({ capacity: 5 });
    world.phases.finish.push(() => {
      expect(() => createEmitter(world, { capacity: 5 })).toThrow(
        /E_REENTRANT: createEmitter cannot run inside a step\. Create it before.*burst\(/,
      );
      if (world.tick === 0) burst(emitter, 3);
    });
    run(world, 0.1);
    expect(aliveCount(emitter)).toBe(3);
  });

  test('frees its entities when destroyed, and its memory for the next', () => {
    const world = createPhysicsWorld({ capacity: 1100 });
    let top = 0;
    for (let i = 0; i < 20; i++) {
      const emitter = createEmitter(world, { capacity: 1000, rate: 1000, lifetime: 3 });
      run(world, 0.1);
      destroyEmitter(emitter);
      destroyEmitter(emitter);
      expect(codeOf(() => setRate(emitter, 1))).toBe('E_STALE');
      expect(world.internal.counts.Position).toBe(0);
      if (i === 0) ({ top } = world.internal.arena);
    }
    expect(world.internal.arena.top).toBe(top);
    step(world, 0.1);
  });

  test('never touches a removed entity of its pool whose id was reused', () => {
    const { world, emitter } = emitting({ capacity: 10, rate: 100, lifetime: 0.2 });
    run(world, 1);
    const [eid] = emitter.ids;
    removeEntity(world, eid);
    const other = spawn(world, { position: { x: 99 }, velocity: {}, mass: 5 });
    expect(other).toBe(eid);
    run(world, 2);
    expect(world.components.Position.x[other]).toBe(99);
    expect(world.components.Mass.value[other]).toBe(5);
    const { alive, born, ended } = emitterCounts(emitter);
    expect([alive, born - ended]).toEqual([9, 9]);
    destroyEmitter(emitter);
    expect(world.internal.counts.Position).toBe(1);
  });

  test('adds and removes no entity at run time', () => {
    const { world } = emitting({ rate: 2000, lifetime: [0.1, 0.4] });
    run(world, 0.5);
    const { membership } = world.versions;
    run(world, 1);
    expect(world.versions.membership).toBe(membership);
  });
});
