// Characters and what moves: platforms, walls, and bodies that they push.
import {
  box,
  createJoint,
  distance,
  moveCharacter,
  restore,
  revolute,
  snapshot,
  spawn,
  stateHash,
  step,
} from '@principia/physics';
import { describe, expect, test } from 'vitest';
import {
  addCharacter,
  BODY,
  capsuleOf,
  MARGIN,
  RADIUS,
  right,
  STANDS,
  walk,
  worldWithFloor,
} from '../../../../test/support/character-world.ts';
import { DT, G, rigidWorld } from '../../../../test/support/rigid-world.ts';

describe.each(['f32', 'f64'] as const)('%s', (precision) => {
  test('it rides on a platform, and keeps the platform’s velocity when it jumps', () => {
    const world = rigidWorld({ precision });
    const lift = spawn(world, { position: {}, velocity: { x: 1.5, y: 0.5 }, collider: { shape: box(3, 0.2) } });
    const id = addCharacter(world, 0, 0.1 + STANDS);
    const ridden = walk(world, id, 120);
    expect(ridden.x).toBeCloseTo(3, 4);
    expect(ridden.y).toBeCloseTo(1 + 0.1 + STANDS, 4);
    expect(ridden.motion).toMatchObject({ grounded: true, ground: lift, velocity: { x: 0, y: 0 } });
    expect(ridden.motion.groundVelocity.x).toBeCloseTo(1.5, 6);
    const jumped = walk(world, id, 1, () => ({ jump: 4 }));
    expect(jumped.motion.velocity.x).toBeCloseTo(1.5, 6);
    expect(jumped.motion.velocity.y).toBeCloseTo(4.5, 6);
  });

  test.each([
    [1, true],
    [2, true],
    [8, true],
    [8, false],
  ])('a lift that comes up through the floor at %f m/s carries it, one-way: %s', (y, oneWay) => {
    const world = worldWithFloor({ precision });
    const shape = box(0.6, 0.2);
    const lift = spawn(world, { position: { y: -1 }, velocity: { y }, kinematic: {}, collider: { shape, oneWay } });
    const carried = walk(world, addCharacter(world, 0, STANDS), Math.round(2 / y / DT) + 30);
    expect(carried.y - world.components.Position.y[lift] - 0.1).toBeCloseTo(STANDS, 3);
    expect(carried.motion).toMatchObject({ grounded: true, ground: lift });
    expect(carried.grounded).not.toContain(false);
  });

  test('a conveyor belt carries it', () => {
    const world = rigidWorld({ precision });
    spawn(world, { position: { y: -0.5 }, collider: { shape: box(20, 1), tangentSpeed: 1.5 } });
    expect(walk(world, addCharacter(world, 0, STANDS), 120).x).toBeCloseTo(3, 4);
  });

  test('a kinematic wall pushes it along, and it does not sink into it', () => {
    const world = worldWithFloor({ precision });
    const wall = spawn(world, { position: { x: -2, y: 1 }, velocity: { x: 2 }, collider: { shape: box(1, 2) } });
    const { x } = walk(world, addCharacter(world, 0, STANDS), 120);
    expect(x - RADIUS - (world.components.Position.x[wall] + 0.5)).toBeCloseTo(MARGIN, 3);
  });

  test.each([0.5, 0.9, 0.995])('a wall that comes by %f of its radius a step pushes it, at whatever phase', (part) => {
    const speed = (part * RADIUS) / DT;
    for (let phase = 0; phase < 1; phase += 0.125) {
      const world = worldWithFloor({ precision });
      const position = { x: -3 + phase * speed * DT, y: 2 };
      const wall = spawn(world, { position, velocity: { x: speed }, collider: { shape: box(1, 3.9) } });
      const { x } = walk(world, addCharacter(world, 0, STANDS), 30);
      expect(x - RADIUS - (world.components.Position.x[wall] + 0.5)).toBeCloseTo(MARGIN, 3);
    }
  });

  test('between two walls that close it stays finite, and moves no faster than by its radius a step', () => {
    const world = worldWithFloor({ precision });
    for (const side of [-1, 1]) {
      spawn(world, { position: { x: 2 * side, y: 1 }, velocity: { x: -side }, collider: { shape: box(1, 2) } });
    }
    const id = addCharacter(world, 0, STANDS);
    for (let i = 0; i < 240; i++) {
      moveCharacter(world, id, { y: -G * DT }, DT);
      const { Velocity } = world.components;
      expect(Math.hypot(Velocity.x[id], Velocity.y[id]) * DT).toBeLessThan(RADIUS + 0.1);
      step(world, DT);
    }
  });

  test('it gives a ball that it hits the velocity v m/(m + M) of an inelastic collision', () => {
    const world = rigidWorld({ precision, forces: [] });
    const id = addCharacter(world, 0, 0);
    const ball = spawn(world, { position: { x: 0.9 }, velocity: {}, collider: { radius: 0.5, density: 50 } });
    const { Mass, Velocity } = world.components;
    for (let i = 0; i < 30 && Velocity.x[ball] === 0; i++) {
      moveCharacter(world, id, { x: 2 }, DT);
      step(world, DT);
    }
    expect(Velocity.x[ball]).toBeCloseTo((2 * Mass.value[id]) / (Mass.value[id] + Mass.value[ball]), 5);
  });

  test('its weight presses on what it stands on: a plate on a spring sinks by m g/k', () => {
    const world = rigidWorld({ precision });
    const plate = spawn(world, {
      position: {},
      motionLocks: { x: true, angle: true },
      collider: { shape: box(2, 0.2), density: 100 },
    });
    createJoint(world, distance({ b: plate, anchorA: { y: -2 }, spring: { hertz: 3, dampingRatio: 1 } }));
    for (let i = 0; i < 300; i++) step(world, DT);
    const { Position, Mass } = world.components;
    const unloaded = Position.y[plate];
    const id = addCharacter(world, 0, unloaded + 0.1 + STANDS);
    walk(world, id, 600);
    const stiffness = Mass.value[plate] * (2 * Math.PI * 3) ** 2;
    expect(unloaded - Position.y[plate]).toBeCloseTo((Mass.value[id] * G) / stiffness, 3);
  });

  test.each([2, 200])('it passes a door of %f kg/m² that hangs over its head', (density) => {
    const world = worldWithFloor({ precision });
    const door = spawn(world, {
      position: { x: 3, y: 1.6 },
      rotation: {},
      collider: { shape: box(0.1, 1.2), density },
    });
    createJoint(world, revolute({ b: door, anchor: { x: 3, y: 2.2 } }));
    const id = addCharacter(world, 0, STANDS);
    const { x, heights } = walk(world, id, 120, right(3));
    // Alone it walks 6 m; the door, of 0.24 or 24 kg beside its 76 kg, may hold it for a moment.
    expect(x).toBeGreaterThan(5.5);
    expect(Math.min(...heights)).toBeCloseTo(STANDS, 3);
  });

  test('a ceiling that comes down over its head stops it, and does not press it down step by step', () => {
    const world = worldWithFloor({ precision });
    // Its end is at 1.2 m, where the round head is already narrower: the normal points down and back.
    spawn(world, { position: { x: 4, y: 2.2 }, collider: { shape: box(4, 2) } });
    const { motion } = walk(world, addCharacter(world, 0, STANDS), 120, right(3));
    expect(motion).toMatchObject({ grounded: true, velocity: { x: 0, y: 0 } });
  });

  test.each([5, 500])('a crate of %f kg that falls on its head, or hits it, does not move it', (density) => {
    const hits = [
      { position: { x: 0.02, y: 4 }, velocity: {} },
      { position: { x: -6, y: 0.5 }, velocity: { x: 20 } },
    ];
    for (const hit of hits) {
      const world = worldWithFloor({ precision });
      const crate = spawn(world, { ...hit, rotation: {}, collider: { shape: box(1, 1), density, friction: 0.6 } });
      const id = addCharacter(world, 0, STANDS);
      const { x, y } = walk(world, id, 240);
      // It asks for nothing, so that it stays, to the rounding of the casts that keep it off the floor.
      expect(x).toBeCloseTo(0, 6);
      expect(y).toBeCloseTo(STANDS, 3);
      expect(Math.abs(world.components.Position.x[crate])).toBeGreaterThan(0.5 + RADIUS - MARGIN);
    }
  });

  test('one without mass pushes nothing', () => {
    const world = rigidWorld({ precision, forces: [] });
    const id = spawn(world, { ...BODY, position: {}, collider: { shape: capsuleOf() } });
    const ball = spawn(world, { position: { x: 0.9 }, velocity: {}, collider: { radius: 0.5, density: 50 } });
    for (let i = 0; i < 60; i++) {
      moveCharacter(world, id, { x: 2 }, DT);
      step(world, DT);
    }
    expect(world.components.Velocity.x[ball]).toBe(0);
    expect(world.components.Position.x[id]).toBeCloseTo(0.4 - RADIUS - MARGIN, 4);
  });

  test('as a system of the world it goes on from a snapshot with the same bits', () => {
    const world = worldWithFloor({ precision });
    for (let i = 0; i < 6; i++) {
      spawn(world, { position: { x: 2 + i, y: 0.3 }, collider: { shape: box(0.5, 0.5), density: 10, friction: 0.4 } });
    }
    const id = addCharacter(world, 0, STANDS);
    world.phases.input.push((self, dt) => {
      moveCharacter(self, id, { x: 3 * Math.sign(Math.sin(self.time)), y: -2 }, dt);
    });
    for (let i = 0; i < 60; i++) step(world, DT);
    const saved = snapshot(world);
    const hashes = [0, 1].map(() => {
      restore(world, saved);
      for (let i = 0; i < 120; i++) step(world, DT);
      return stateHash(world);
    });
    expect(hashes[1]).toBe(hashes[0]);
  });
});
