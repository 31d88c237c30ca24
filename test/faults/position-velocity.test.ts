import {
  type BodyInput,
  entityRef,
  MAX_ANGULAR_SPEED,
  MAX_SPEED,
  spawn,
  stateHash,
  step,
  uniformGravity,
} from '@principia/physics';
import { addComponent, addEntity, set } from 'bitecs';
import { describe, expect, it } from 'vitest';
import {
  assertRefused,
  assertWorldAlive,
  ball,
  bodyState,
  DT,
  emptySpace,
  groundWorld,
  KINDS,
  steps,
  withWitness,
} from '../support/worlds.ts';

const NO_NUMBERS: readonly [string, unknown][] = [
  ['undefined', undefined],
  ['a string', '1'],
  ['a BigInt', 1n],
  ['null', null],
  ['an object', {}],
];

describe.each(KINDS)('position and velocity, $dimensions D $precision', (kind) => {
  const refuse = (body: unknown, code: string, field: string, hint?: RegExp) => {
    const world = groundWorld(kind);
    ball(world, 0, 1);
    assertRefused(world, () => spawn(world, body as BodyInput), { code, field, ...(hint && { hint }) });
    assertWorldAlive(world);
  };

  it('1 a body created at NaN is refused with E_NONFINITE', () => {
    refuse({ position: { x: NaN } }, 'E_NONFINITE', 'position.x');
    refuse({ position: {}, velocity: { y: NaN } }, 'E_NONFINITE', 'velocity.y');
  });

  it.each([Infinity, -Infinity])('2 a body created at %d is refused with E_NONFINITE', (bad) => {
    refuse({ position: { y: bad } }, 'E_NONFINITE', 'position.y');
    refuse({ position: {}, velocity: { x: bad } }, 'E_NONFINITE', 'velocity.x');
  });

  it('3 a body created at 1e30 m is refused with E_RANGE', () => {
    refuse({ position: { x: 1e30 } }, 'E_RANGE', 'position.x', /larger unit of length.*docs\/units\.md/);
  });

  it.each(NO_NUMBERS)('4 a coordinate of %s is refused with E_TYPE', (_, bad) => {
    refuse({ position: { x: bad } }, 'E_TYPE', 'position.x');
    refuse({ position: {}, velocity: { y: bad } }, 'E_TYPE', 'velocity.y');
  });

  it('5 NaN set through the API throws and changes nothing', () => {
    const world = groundWorld(kind);
    const eid = ball(world, 0, 1);
    const { Position, Velocity } = world.components;
    const expected = { code: 'E_NONFINITE', entity: eid };
    assertRefused(world, () => addComponent(world, eid, set(Position, { x: 3, y: NaN })), expected);
    assertRefused(world, () => addComponent(world, eid, set(Velocity, { x: NaN })), expected);
    assertWorldAlive(world);
  });

  it('5 refused values leave no partial component', () => {
    const world = groundWorld(kind);
    const eid = addEntity(world);
    const { Position } = world.components;
    assertRefused(world, () => addComponent(world, eid, set(Position, { x: NaN })), { code: 'E_NONFINITE' });
    addComponent(world, eid, Position);
    // It was added before by another call, so it stays.
    assertRefused(world, () => addComponent(world, eid, set(Position, { x: NaN })), { code: 'E_NONFINITE' });
  });

  it.each(['x', 'y'] as const)('6 NaN in Position.%s quarantines the body within one step', (axis) => {
    const { world, victim } = withWitness(({ world, victim }) => {
      step(world, DT);
      const last = [world.components.Position.x[victim], world.components.Position.y[victim]];
      world.components.Position[axis][victim] = NaN;
      step(world, DT);
      const { Position } = world.components;
      expect(world.faults.faults).toMatchObject([
        { code: 'E_NONFINITE', entity: victim, field: `Position.${axis}`, value: NaN, step: 1, phase: 'begin' },
      ]);
      // The body was reset to its last valid pose and stopped, and then fell for a step: g dt² / 2 is 1.4 mm.
      expect(Position.x[victim]).toBeCloseTo(last[0], 12);
      expect(Math.abs(Position.y[victim] - last[1])).toBeLessThan(2e-3);
    }, kind);
    expect(world.internal.counts.Quarantined).toBe(1);
    expect(world.components.Quarantined.step[victim]).toBe(1);
  });

  it.each([1e30, Infinity, -Infinity])('6 Position.x = %d written into the column is quarantined too', (bad) => {
    const { world, victim } = withWitness(({ world, victim }) => {
      world.components.Position.x[victim] = bad;
    }, kind);
    expect(world.faults.faults).toMatchObject([{ code: Number.isFinite(bad) ? 'E_RANGE' : 'E_NONFINITE', step: 0 }]);
    expect(world.components.Position.x[victim]).toBe(0);
  });

  it('6 a repaired body is no longer quarantined', () => {
    const world = groundWorld(kind);
    const eid = ball(world, 0, 1);
    world.components.Position.x[eid] = NaN;
    step(world, DT);
    // Valid values in the columns move it, and it goes on to rest.
    world.components.Velocity.x[eid] = 1;
    world.components.Position.x[eid] = 1;
    for (let i = 0; i < 2; i++) step(world, DT);
    expect(world.internal.counts.Quarantined).toBe(1);
    expect([world.components.Position.x[eid], world.components.Velocity.x[eid]]).toEqual([1, 0]);
    addComponent(world, eid, set(world.components.Position, { x: 2 }));
    expect(world.internal.counts.Quarantined).toBe(0);
    step(world, DT);
    expect(world.faults.faults).toHaveLength(1);
  });

  it.each([NaN, Infinity, -Infinity])('7 velocity %d written into the column is quarantined', (bad) => {
    const { world, victim } = withWitness(({ world, victim }) => {
      world.components.Velocity.x[victim] = bad;
    }, kind);
    expect(world.faults.faults).toMatchObject([{ code: 'E_NONFINITE', entity: victim, field: 'Velocity.x', step: 0 }]);
    expect(world.components.Velocity.x[victim]).toBe(0);
  });

  it('8 velocity 1e30 is refused by the API with E_RANGE', () => {
    refuse({ position: {}, velocity: { x: 1e30 } }, 'E_RANGE', 'velocity.x', /larger unit of length.*docs\/units\.md/);
  });

  it('8 velocity 1e30 written into the column quarantines the body where it is, with one fault', () => {
    const { world, victim } = withWitness(({ world, victim }) => {
      world.components.Velocity.x[victim] = -1e30;
    }, kind);
    expect(world.faults.faults).toMatchObject([{ code: 'E_RANGE', entity: victim, field: 'Velocity.x', step: 0 }]);
    expect(world.components.Velocity.x[victim]).toBe(0);
  });

  it('8 a speed beyond that of light that a force causes is clamped, with one fault', () => {
    const world = emptySpace({ ...kind, forces: [uniformGravity({ x: 1e12 })] });
    const eid = spawn(world, { position: {}, mass: 1 });
    step(world, 1e-3);
    expect(world.faults.faults).toMatchObject([{ code: 'E_SPEED', entity: eid, field: 'Velocity.x', phase: 'finish' }]);
    expect(world.components.Velocity.x[eid]).toBe(kind.precision === 'f32' ? Math.fround(MAX_SPEED) : MAX_SPEED);
  });

  it('6 a quarantined body rests until its position or velocity is set', () => {
    const world = groundWorld(kind);
    const eid = ball(world, 0, 5, { x: 1 });
    world.components.Velocity.y[eid] = Number.NaN;
    steps(world, 60);
    expect([world.components.Position.x[eid], world.components.Position.y[eid]]).toEqual([0, 5]);
    expect(world.faults.faults.length).toBe(1);
    addComponent(world, eid, set(world.components.Velocity, { x: 1 }));
    steps(world, 30);
    // Half a second of uniform motion, and of free fall, which velocity Verlet computes exactly.
    expect(world.components.Position.x[eid]).toBeCloseTo(0.5, 4);
    expect(world.components.Position.y[eid]).toBeCloseTo(5 - (9.80665 * 0.25) / 2, 4);
  });

  it.each([NaN, Infinity])('9 angular velocity %d: refused by the API, quarantined in the column', (bad) => {
    refuse({ position: {}, angularVelocity: { z: bad } }, 'E_NONFINITE', 'angularVelocity.z');
    const { world } = withWitness(({ world, victim }) => {
      addComponent(world, victim, set(world.components.AngularVelocity, 3));
      world.components.AngularVelocity.z[victim] = bad;
    }, kind);
    expect(world.faults.faults).toMatchObject([{ code: 'E_NONFINITE', field: 'AngularVelocity.z', step: 0 }]);
  });

  it('10 angular velocity 1e10 is refused by the API, and capped in the column', () => {
    refuse({ position: {}, angularVelocity: 1e10 }, 'E_RANGE', 'angularVelocity');
    const { world, victim } = withWitness(({ world, victim }) => {
      addComponent(world, victim, set(world.components.AngularVelocity, 3));
      world.components.AngularVelocity.z[victim] = 1e10;
    }, kind);
    expect(world.faults.faults).toMatchObject([{ code: 'E_SPEED', field: 'AngularVelocity.z', step: 0 }]);
    expect(world.components.AngularVelocity.z[victim]).toBe(MAX_ANGULAR_SPEED);
  });

  it('14 a teleport does not interpolate across the gap', () => {
    const world = groundWorld(kind);
    const eid = ball(world, 0, 50, { x: 1 });
    steps(world, 3);
    const { Position } = world.components;
    const { previous } = world;
    expect(previous.Position.x[eid]).not.toBe(Position.x[eid]);
    addComponent(world, eid, set(Position, { x: 400, y: 70 }));
    expect([previous.Position.x[eid], previous.Position.y[eid]]).toEqual([400, 70]);
    // The same holds for a set during a step.
    world.phases.events.push(() => addComponent(world, eid, set(Position, { x: -40 })));
    step(world, DT);
    expect([previous.Position.x[eid], Position.x[eid]]).toEqual([-40, -40]);
  });

  it('15 -0 and 0 hash alike', () => {
    const hashes = [0, -0].map((zero) => {
      const world = emptySpace(kind);
      spawn(world, { position: { x: zero, y: 1 }, velocity: { x: 1, y: zero } });
      return stateHash(world);
    });
    expect(hashes[0]).toBe(hashes[1]);
  });
});

describe('orientation', () => {
  const stage = () => groundWorld({ dimensions: 3 });

  it('12 a quaternion of another length than 1 is normalised', () => {
    const world = stage();
    const eid = spawn(world, { position: { y: 1 }, orientation: { x: 3, y: 0, z: 0, w: 4 } });
    const { x, w } = world.components.Orientation;
    expect(x[eid]).toBeCloseTo(0.6, 15);
    expect(w[eid]).toBeCloseTo(0.8, 15);
  });

  it('12 a quaternion that turns a body is refused in 2D with E_RANGE', () => {
    const world = groundWorld({ dimensions: 2 });
    assertRefused(world, () => spawn(world, { position: { y: 1 }, orientation: { z: 0.6, w: 0.8 } }), {
      code: 'E_RANGE',
      field: 'orientation.z',
      hint: /dimensions: 3.*rotation/,
    });
    const eid = spawn(world, { position: { y: 1 }, orientation: {} });
    expect(world.components.Orientation.w[eid]).toBe(1);
    assertWorldAlive(world);
  });

  it('12 a quaternion of zeros is refused with E_RANGE', () => {
    const world = stage();
    const zero = { x: 0, y: 0, z: 0, w: 0 };
    assertRefused(world, () => spawn(world, { position: {}, orientation: zero }), {
      code: 'E_RANGE',
      field: 'orientation',
      hint: /w: 1/,
    });
    const eid = spawn(world, { position: { y: 1 }, orientation: {} });
    assertRefused(world, () => addComponent(world, eid, set(world.components.Orientation, zero)), { code: 'E_RANGE' });
    assertWorldAlive(world);
  });

  it.each([NaN, 1e30])('12 %d in a quaternion is reset within one step', (bad) => {
    const { world, victim } = withWitness(
      ({ world, victim }) => {
        addComponent(world, victim, set(world.components.Orientation, { x: 0.6, w: 0.8 }));
        world.components.Orientation.y[victim] = bad;
      },
      { dimensions: 3 },
    );
    expect(world.faults.faults).toMatchObject([{ entity: victim, field: 'Orientation.y', step: 0 }]);
    expect(world.components.Orientation.y[victim]).toBe(0);
    expect(world.components.Orientation.x[victim]).toBeCloseTo(0.6, 15);
  });
});

describe('in two dimensions', () => {
  it('an angle in the column is validated and interpolated without angular velocity', () => {
    const world = groundWorld();
    const eid = spawn(world, { position: { y: 1 }, rotation: 1 });
    step(world, DT);
    world.components.Rotation.angle[eid] = 2;
    step(world, DT);
    expect(world.previous.Rotation.angle[eid]).toBe(2);
    world.components.Rotation.angle[eid] = NaN;
    step(world, DT);
    expect(world.components.Rotation.angle[eid]).toBe(2);
    expect(world.faults.faults).toMatchObject([{ code: 'E_NONFINITE', field: 'Rotation.angle' }]);
  });

  it('a nonzero z is refused, with a hint for 3D', () => {
    const world = groundWorld();
    const expected = { code: 'E_RANGE', hint: /dimensions: 3/ };
    assertRefused(world, () => spawn(world, { position: { z: 1 } }), expected);
    assertRefused(world, () => spawn(world, { position: {}, velocity: { z: 1 } }), expected);
    assertRefused(world, () => spawn(world, { position: {}, angularVelocity: { x: 1 } }), expected);
    const eid = spawn(world, { position: { x: 1, z: 0 } });
    expect(bodyState(world, entityRef(world, eid) % 2 ** 24)).toBe('Position.x=1');
  });
});
