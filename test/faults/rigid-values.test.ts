/** Bad values, extreme shapes and extreme states in a world of rigid bodies. */
import {
  box,
  boxWalls,
  capsule,
  createJoint,
  createPhysicsWorld,
  despawn,
  distance,
  gear,
  MAX_ANGULAR_SPEED,
  motorJoint,
  mouseJoint,
  type PhysicsWorld,
  polygon,
  prismatic,
  pulley,
  revolute,
  rigidBodies,
  spawn,
  spawnCompound,
  spawnMany,
  step,
  uniformGravity,
  weld,
  wheel,
} from '@principia/physics';
import { addComponent, set } from 'bitecs';
import { describe, expect, it } from 'vitest';
import { assertRefused, bodyState, DT, refusal, steps } from '../support/worlds.ts';

const PRECISIONS = ['f32', 'f64'] as const;

/** A ground at y = 0, a crate on it, and far away a witness that falls on a ground of its own. */
function crateWorld(precision: 'f32' | 'f64' = 'f64') {
  const world = createPhysicsWorld({
    preset: rigidBodies,
    precision,
    capacity: 1200,
    forces: [uniformGravity()],
    walls: [boxWalls({ min: { y: 0 } })],
  });
  const shape = box(1, 1);
  const crate = spawn(world, { position: { y: 0.5 }, collider: { shape, density: 1, friction: 0.5 } });
  const neighbour = spawn(world, { position: { x: 5, y: 3 }, collider: { shape, density: 1 } });
  const witness = spawn(world, { position: { x: 200, y: 5 }, rotation: 0.3, collider: { shape, density: 1 } });
  return { world, crate, neighbour, witness };
}

function allFinite(world: PhysicsWorld): boolean {
  const { Position, Velocity, AngularVelocity, Rotation } = world.components;
  const columns = [Position.x, Position.y, Velocity.x, Velocity.y, AngularVelocity.z, Rotation.angle];
  return columns.every((column) => column.subarray(0, world.lastId + 1).every(Number.isFinite));
}

/** Expects a new ball to fall on the ground and lie there, up to the overlap of 5 mm that contacts keep. */
function assertRigidWorldAlive(world: PhysicsWorld): void {
  const ball = spawn(world, { position: { x: -300, y: 0.5 }, collider: { radius: 0.1, density: 1 } });
  steps(world, 60);
  expect(Math.abs(world.components.Position.y[ball] - 0.1)).toBeLessThan(0.005);
}

/** Runs with and without an edit: the witness and the neighbour must not notice it. */
function expectWitnessUnmoved(
  precision: 'f32' | 'f64',
  edit: (world: PhysicsWorld, crate: number) => void,
): PhysicsWorld {
  const [control, edited] = [crateWorld(precision), crateWorld(precision)];
  for (const { world } of [control, edited]) steps(world, 5);
  edit(edited.world, edited.crate);
  for (const { world } of [control, edited]) steps(world, 60);
  for (const id of [edited.witness, edited.neighbour]) {
    expect(bodyState(edited.world, id)).toBe(bodyState(control.world, id));
  }
  expect(allFinite(edited.world)).toBe(true);
  assertRigidWorldAlive(edited.world);
  return edited.world;
}

describe.each(PRECISIONS)('values of a rigid body, %s', (precision) => {
  it('3, 4, 5 a rigid body is refused at 1e30 m or at a text, and keeps its pose when NaN is set', () => {
    const { world, crate } = crateWorld(precision);
    const collider = { shape: box(1, 1), density: 1 };
    assertRefused(world, () => spawn(world, { position: { x: 1e30 }, collider }), { code: 'E_RANGE' });
    assertRefused(world, () => spawn(world, { position: { x: '1' as never }, collider }), { code: 'E_TYPE' });
    const { Position, Rotation } = world.components;
    for (const act of [
      () => addComponent(world, crate, set(Position, { x: Number.NaN })),
      () => addComponent(world, crate, set(Rotation, { angle: Number.NaN })),
    ]) {
      assertRefused(world, act, { code: 'E_NONFINITE' });
    }
    assertRigidWorldAlive(world);
  });

  it('6 NaN in the position of a rigid body quarantines it; others do not notice', () => {
    const world = expectWitnessUnmoved(precision, ({ components }, crate) => {
      components.Position.x[crate] = Number.NaN;
    });
    expect(world.faults.faults).toHaveLength(1);
  });

  it('7 NaN in the velocity of a rigid body quarantines it; others do not notice', () => {
    expectWitnessUnmoved(precision, ({ components }, crate) => {
      components.Velocity.y[crate] = Number.POSITIVE_INFINITY;
    });
  });

  it('8 a rigid body of 1e30 m/s in the column is stopped, with one fault', () => {
    const world = expectWitnessUnmoved(precision, ({ components }, crate) => {
      components.Velocity.y[crate] = 1e30;
    });
    expect(world.faults.faults).toHaveLength(1);
  });

  it('9 NaN in the angular velocity of a rigid body quarantines it; others do not notice', () => {
    expectWitnessUnmoved(precision, ({ components }, crate) => {
      components.AngularVelocity.z[crate] = Number.NaN;
    });
  });

  it('10 an angular velocity of 1e10 in the column of a rigid body is capped; others do not notice', () => {
    const world = expectWitnessUnmoved(precision, ({ components }, crate) => {
      components.AngularVelocity.z[crate] = 1e10;
    });
    expect(Math.max(...world.components.AngularVelocity.z)).toBeLessThanOrEqual(MAX_ANGULAR_SPEED);
  });

  it('11 a rigid body at an angle of a thousand turns and more rests as one that was turned back', () => {
    const rest = (turns: number) => {
      const { world, crate } = crateWorld(precision);
      world.components.Rotation.angle[crate] = 2 * Math.PI * turns;
      world.versions.pose++;
      steps(world, 120);
      return world.components.Position.y[crate];
    };
    // The angle itself is rounded to half a radian in f32, where a crate ends on one of its sides nevertheless.
    expect(rest(precision === 'f32' ? 1e3 : 1e6)).toBeCloseTo(rest(0), 2);
  });

  it('13, 14 a rigid body teleported into another leaves it at bounded speed, and nothing is interpolated', () => {
    const { world, crate, neighbour } = crateWorld(precision);
    steps(world, 90);
    const { Position, Velocity } = world.components;
    addComponent(world, neighbour, set(Position, { x: 0.2, y: 0.6 }));
    expect(world.previous.Position.x[neighbour]).toBeCloseTo(0.2, 6);
    let fastest = 0;
    for (let i = 0; i < 240; i++) {
      step(world, DT);
      for (const id of [crate, neighbour]) fastest = Math.max(fastest, Math.hypot(Velocity.x[id], Velocity.y[id]));
    }
    // Overlap is pushed out at 4 m/s, by each of two contact points; then one falls from the other.
    expect(fastest).toBeLessThan(10);
    const apart = Math.max(
      Math.abs(Position.x[crate] - Position.x[neighbour]),
      Math.abs(Position.y[crate] - Position.y[neighbour]),
    );
    expect(apart).toBeGreaterThan(0.95);
  });

  it('24, 25, 27, 29, 30 bad masses, densities, frictions and restitutions of rigid bodies are refused', () => {
    const { world } = crateWorld(precision);
    const shape = box(1, 1);
    for (const mass of [0, -1, Number.NaN]) refusal(() => spawn(world, { position: {}, mass, collider: { shape } }));
    for (const bad of [-1, Number.NaN]) {
      refusal(() => spawn(world, { position: {}, collider: { shape, density: bad } }));
      refusal(() => spawn(world, { position: {}, collider: { shape, friction: bad } }));
      refusal(() => spawn(world, { position: {}, collider: { shape, restitution: bad } }));
    }
    assertRigidWorldAlive(world);
  });

  it('26, 28 a rigid body of infinite mass is static, and one of infinite inertia does not turn', () => {
    const { world, crate } = crateWorld(precision);
    const shape = box(1, 1);
    const wall = spawn(world, { position: { x: -3, y: 4 }, mass: Infinity, collider: { shape } });
    const collider = { shape, density: 1, friction: 1 };
    const stiff = spawn(world, { position: { x: 0.6, y: 2 }, inertia: Infinity, collider });
    steps(world, 120);
    expect(world.components.Position.y[wall]).toBe(4);
    expect(world.components.Rotation.angle[stiff]).toBe(0);
    expect(world.components.Position.y[stiff]).toBeGreaterThan(0.4);
    expect(allFinite(world) && crate > 0).toBe(true);
  });

  it('31 a rigid body a hundred times heavier on a light one overlaps by less than a tenth; one a million times heavier stays above ground', () => {
    const resting = (density: number) => {
      const { world, crate } = crateWorld(precision);
      const heavy = spawn(world, { position: { y: 1.5 }, collider: { shape: box(1, 1), density, friction: 0.5 } });
      steps(world, 300);
      expect(allFinite(world)).toBe(true);
      const { y } = world.components.Position;
      return [y[crate], y[heavy]];
    };
    const [light, heavy] = resting(100);
    expect(1 - (heavy - light)).toBeLessThan(0.1);
    // Soft contacts give way: the heavy body comes down through the light one, but neither leaves the ground.
    for (const y of resting(1e6)) expect(y).toBeGreaterThan(0.4);
  });
});

describe('shapes of rigid bodies', () => {
  it('32, 34, 35, 36, 37, 38, 39, 40 a refused shape leaves a rigid world as it was', () => {
    const { world } = crateWorld();
    const square = [{}, { x: 1 }, { x: 1, y: 1 }, { y: 1 }];
    const shapes = [
      () => box(0, 1),
      () => box(1e-6, 1),
      () => capsule(1, -1),
      () => polygon(square.slice(0, 2)),
      () => polygon([{}, { x: 1 }, { x: 2 }]),
      () => polygon([...square.slice(0, 3), { x: Number.NaN, y: 1 }]),
      () => polygon([square[0], square[2], square[1], square[3]]),
      () => polygon(Array.from({ length: 9 }, (_, i) => ({ x: Math.cos(i / 1.5), y: Math.sin(i / 1.5) }))),
    ];
    for (const shape of shapes) {
      const code = refusal(shape).code;
      assertRefused(world, () => spawn(world, { position: {}, collider: { shape: shape(), density: 1 } }), { code });
    }
    refusal(() => spawn(world, { position: {}, collider: { radius: 0, density: 1 } }));
    const clockwise = polygon([...square].reverse());
    spawn(world, { position: { x: 10, y: 5 }, collider: { shape: clockwise, density: 1 } });
    steps(world, 60);
    assertRigidWorldAlive(world);
  });

  it('42 a compound body without parts is refused, and one whose part is bad leaves nothing', () => {
    const { world } = crateWorld();
    assertRefused(world, () => spawnCompound(world, { parts: [] }), { code: 'E_RANGE', field: 'parts' });
    const parts = [
      { shape: box(1, 1), density: 1 },
      { shape: box(1, 1), density: -1 },
    ];
    assertRefused(world, () => spawnCompound(world, { parts }), { code: 'E_RANGE' });
    assertRigidWorldAlive(world);
  });

  it('43 a chain of a thousand attachments is refused with the part of a part, until it is removed', () => {
    const { world, witness } = crateWorld();
    const control = crateWorld();
    const shape = box(0.2, 0.2);
    const ids = [spawnCompound(world, { position: { x: -20, y: 3 }, parts: [{ shape, density: 1 }] }).body];
    const part = { position: { x: -20, y: 3 }, rotation: 0, collider: { shape } };
    for (let depth = 0; depth < 1000; depth++) ids.push(spawn(world, part));
    // From the end of the chain, as a part is refused where a body is needed.
    for (let depth = 1000; depth > 0; depth--) {
      addComponent(world, ids[depth], set(world.components.Attachment, { body: ids[depth - 1] }));
    }
    assertRefused(world, () => spawn(world, { ...part, attachment: { body: ids[1] } }), { code: 'E_RANGE' });
    const error = refusal(() => step(world, DT));
    expect(error.code).toBe('E_RANGE');
    expect(error.entity).toBe(ids[2]);
    for (const id of ids.slice(2).reverse()) despawn(world, id);
    steps(world, 60);
    steps(control.world, 60);
    expect(bodyState(world, witness)).toBe(bodyState(control.world, control.witness));
    expect(allFinite(world)).toBe(true);
  });
});

describe.each(PRECISIONS)('rigid bodies in one place, %s', (precision) => {
  it('88 a hundred coincident rigid bodies separate below 3 m/s', () => {
    const world = createPhysicsWorld({ preset: rigidBodies, precision, capacity: 200 });
    const ids = spawnMany(world, 100, { position: {}, velocity: {}, collider: { shape: box(0.2, 0.2), density: 1 } });
    const { Velocity, Position } = world.components;
    let fastest = 0;
    for (let i = 0; i < 300; i++) {
      step(world, DT);
      for (const id of ids) fastest = Math.max(fastest, Math.hypot(Velocity.x[id], Velocity.y[id]));
    }
    expect(allFinite(world)).toBe(true);
    expect(world.faults.faults).toEqual([]);
    expect(fastest).toBeLessThan(3);
    expect(Math.max(...[...ids].map((id) => Math.hypot(Position.x[id], Position.y[id])))).toBeGreaterThan(0.4);
  });

  it('67 three thousand coincident rigid bodies stay finite, without a fault', {
    timeout: 60_000,
  }, () => {
    const world = createPhysicsWorld({ preset: rigidBodies, precision, capacity: 3000 });
    spawnMany(world, 3000, { position: { x: 1 }, velocity: {}, mass: 1, collider: 0.1 });
    steps(world, 2);
    expect(allFinite(world)).toBe(true);
    expect(world.faults.faults).toEqual([]);
  });

  it('84, 85 a rigid ball of 2000 m/s and a rod that spins at 100 rad/s are stopped by a wall of 5 cm', () => {
    const world = createPhysicsWorld({ preset: rigidBodies, precision, capacity: 20 });
    spawn(world, { position: { x: 10 }, collider: { shape: box(0.05, 40) } });
    const collider = { radius: 0.1, density: 1 };
    const fast = spawn(world, { position: { y: 10 }, velocity: { x: 2000 }, collider });
    const shape = box(2, 0.05);
    const velocity = { x: 50 };
    const rod = spawn(world, { position: {}, velocity, angularVelocity: { z: 100 }, collider: { shape, density: 1 } });
    steps(world, 60);
    const { x } = world.components.Position;
    expect(x[fast]).toBeLessThan(10);
    expect(x[rod]).toBeLessThan(10);
    expect(allFinite(world)).toBe(true);
  });
});

describe('joints of rigid bodies', () => {
  it('53 a joint to itself, to a removed, an absent or no rigid body is refused', () => {
    const { world, crate } = crateWorld();
    const gone = spawn(world, { position: { x: 50 }, collider: { shape: box(1, 1), density: 1 } });
    world.components.Position.x[gone] = 50;
    step(world, DT);
    for (const b of [0, -1, 1.5, 999_999, Number.NaN, '1']) {
      expect(refusal(() => createJoint(world, distance({ a: crate, b: b as number }))).code).toMatch(/^E_/);
    }
    assertRefused(world, () => createJoint(world, revolute({ a: crate, b: crate, anchor: {} })), { code: 'E_RANGE' });
    assertRefused(world, () => createJoint(world, distance({ a: crate, b: 1100 })), { code: 'E_STALE' });
    assertRigidWorldAlive(world);
  });

  it('53 a joint whose point, axis or limit is not said is refused', () => {
    const { world, crate: b } = crateWorld();
    const a = spawn(world, { position: { x: 5 }, collider: { shape: box(1, 1), density: 1 } });
    const describe = { revolute, weld, prismatic, wheel, pulley, gear, mouseJoint, motorJoint } as const;
    const missing: readonly (readonly [keyof typeof describe, object, string])[] = [
      ['revolute', {}, 'anchor'],
      ['weld', {}, 'anchor'],
      ['prismatic', { axis: { x: 1 } }, 'anchor'],
      ['prismatic', { anchor: {} }, 'axis'],
      ['wheel', {}, 'anchor'],
      ['pulley', { pulleyA: {} }, 'pulleyB'],
      ['gear', {}, 'ratio'],
      ['mouseJoint', { maxForce: 1 }, 'target'],
      ['mouseJoint', { target: {} }, 'maxForce'],
      ['motorJoint', { maxForce: 1 }, 'maxTorque'],
      // Without a largest torque a motor would do nothing.
      ['revolute', { anchor: {}, motor: { speed: 3 } }, 'motor.max'],
      ['wheel', { anchor: {}, motor: { max: 3 } }, 'motor.speed'],
      ['weld', { anchor: {}, spring: { dampingRatio: 1 } }, 'spring.hertz'],
    ];
    for (const [name, options, field] of missing) {
      const make = describe[name] as (options: object) => Parameters<typeof createJoint>[1];
      const bodies = name === 'mouseJoint' ? { b } : { a, b };
      const error = refusal(() => createJoint(world, make({ ...bodies, ...options })));
      expect([name, error.code, error.field]).toEqual([name, 'E_TYPE', `${name}.${field}`]);
    }
    assertRigidWorldAlive(world);
  });
});
