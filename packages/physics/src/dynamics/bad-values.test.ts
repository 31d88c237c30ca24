// Tests a law that fails for one body, and invalid values written by user code: only that body stops; its neighbours in
// the same SIMD vector continue unchanged.
import { describe, expect, test } from 'vitest';
import { crowd, WORLD_KINDS, type WorldKind } from '../../../../test/support/law-lab.ts';
import { bodyState, steps } from '../../../../test/support/worlds.ts';
import {
  COMPONENTS,
  createPhysicsWorld,
  defineForce,
  defineLaw,
  type Force,
  INTEGRATORS,
  linearDrag,
  MAX_SPEED,
  type PhysicsWorld,
  rungeKutta4,
  spawn,
  step,
  uniformGravity,
  vec3,
} from '../index.ts';

/** Gives a body with negative charge a NaN force, and the others a force that depends on their charge. */
const root = defineLaw({
  name: 'root of the charge',
  reads: { q: COMPONENTS.Charge },
  force: ({ position, velocity, q }) => velocity.sub(position).mul(q.sqrt()),
})();

/** Infinite for a body without mass, and for a row without a body. */
const perMass = defineLaw({
  name: 'per mass',
  force: ({ position, mass }) => position.add(vec3(1, 2, 3)).div(mass),
})();

const forces = (): Force[] => [uniformGravity({ y: -1 }), linearDrag({ x: 0.5 }), root];

function scene(kind: WorldKind, all: readonly Force[] = forces(), integrator = INTEGRATORS.velocityVerlet.create()) {
  const { world, eids } = crowd(all, { ...kind, integrator });
  const { Position, Velocity, Charge, LinearDrag } = world.components;
  eids.forEach((eid, i) => {
    Position.x[eid] = i * 0.3 - 2;
    Position.y[eid] = 1 / (i + 1);
    Velocity.x[eid] = 1 - i / 7;
    Charge.value[eid] = i / 5;
    LinearDrag.coefficient[eid] = 0.1 * (i % 3);
  });
  return { world, eids };
}

/** Returns the state of all other bodies, for bitwise comparison. */
function others({ world, eids }: { world: PhysicsWorld; eids: readonly number[] }, bad: number): string[] {
  return eids.filter((eid) => eid !== bad).map((eid) => bodyState(world, eid));
}

describe.each(WORLD_KINDS)('in $dimensions dimensions, $precision', (kind) => {
  test.each([0, 1, 2, 3, 9, 16])('a law that is NaN for body %i quarantines only that body, and is named', (which) => {
    const [good, bad] = [scene(kind), scene(kind)];
    const eid = bad.eids[which];
    steps(good.world, 2);
    steps(bad.world, 2);
    const { Position, Velocity, Charge } = bad.world.components;
    const before = [Position.x[eid], Position.y[eid]];
    Charge.value[eid] = -1;
    steps(good.world, 5);
    steps(bad.world, 5);
    expect(bad.world.faults.faults).toHaveLength(1);
    const [{ law, hint, ...fault }] = bad.world.faults.faults;
    expect(fault).toMatchObject({ code: 'E_NONFINITE', entity: eid, phase: 'finish', step: 2 });
    expect(law).toBe('root of the charge');
    expect(hint).toMatch(/Check the law "root of the charge"/);
    expect([Position.x[eid], Position.y[eid], Velocity.x[eid], Velocity.y[eid]]).toEqual([...before, 0, 0]);
    expect(others(bad, eid)).toEqual(others(good, eid));
  });

  test.each([
    ['Position', 'x', Number.NaN, 'E_NONFINITE'],
    ['Position', 'y', 1e300, kind.precision === 'f32' ? 'E_NONFINITE' : 'E_RANGE'],
    ['Velocity', 'x', Number.NaN, 'E_NONFINITE'],
    ['Velocity', 'y', -Infinity, 'E_NONFINITE'],
    ['Velocity', 'y', 1e300, kind.precision === 'f32' ? 'E_NONFINITE' : 'E_RANGE'],
  ] as const)('an invalid %s.%s = %d affects only its body: %s', (name, axis, value, code) => {
    const [good, bad] = [scene(kind), scene(kind)];
    const eid = bad.eids[6];
    steps(good.world, 1);
    steps(bad.world, 1);
    bad.world.components[name][axis][eid] = value;
    steps(good.world, 3);
    steps(bad.world, 3);
    const [fault] = bad.world.faults.faults;
    expect(fault).toMatchObject({ code, entity: eid, field: `${name}.${axis}`, phase: 'begin' });
    expect(fault.law).toBeUndefined();
    expect(others(bad, eid)).toEqual(others(good, eid));
    const { Position, Velocity } = bad.world.components;
    for (const column of [Position.x, Position.y, Velocity.x, Velocity.y])
      expect(Number.isFinite(column[eid])).toBe(true);
  });

  test.each([
    ['one loop', []],
    ['segments', [defineForce({ name: 'nothing', accumulate() {} })]],
  ])('a law that is infinite without mass does not move bodies without mass: %s', (_, more) => {
    const world = createPhysicsWorld({ capacity: 50, ...kind, forces: [perMass, ...more] });
    const wall = spawn(world, { position: { x: 1, y: 2 } });
    const platform = spawn(world, { position: { x: 3 }, velocity: { x: 0.5 } });
    const falling = spawn(world, { position: { x: 5 }, velocity: {}, mass: 2 });
    steps(world, 8, 0.25);
    const { Position: p, Velocity: v } = world.components;
    expect([p.x[wall], p.y[wall], p.x[platform], v.x[platform], v.y[platform]]).toEqual([1, 2, 4, 0.5, 0]);
    expect(v.y[falling]).not.toBe(0);
    // Rows without a body hold zeros; all kernels rely on this.
    expect([p.x[0], v.x[0], p.x[falling + 1], v.x[falling + 1]]).toEqual([0, 0, 0, 0]);
    expect(world.faults.faults).toEqual([]);
  });

  // The cheap check of a world without walls is that of the distance from the origin; the exact one decides beyond.
  test.each([0.05, 0.5, 0.99])('a body at %f of the speed limit is no fault, and one beyond it is', (part) => {
    const { world, eids } = crowd([uniformGravity({ y: -1 })], kind);
    world.components.Velocity.x[eids[3]] = part * MAX_SPEED;
    steps(world, 3);
    expect(world.faults.faults).toEqual([]);
    world.components.Velocity.x[eids[3]] = 1.01 * MAX_SPEED;
    step(world, 0.01);
    expect(world.faults.faults.map(({ entity }) => entity)).toEqual([eids[3]]);
  });

  // Near the origin the cheap check accepts it: such a body is noticed where it goes.
  test('a body beyond the speed limit that a step brings near the origin is a fault in the next step', () => {
    const dt = 0.01;
    const kick = defineLaw({ name: 'kick', force: ({ velocity, mass }) => velocity.mul(mass.mul(0.05 / dt)) })();
    const { world, eids } = crowd([kick], { ...kind, integrator: INTEGRATORS.semiImplicitEuler.create() });
    const { Position, Velocity } = world.components;
    Velocity.x[eids[3]] = 0.98 * MAX_SPEED;
    Position.x[eids[3]] = -1.05 * 0.98 * MAX_SPEED * dt;
    steps(world, 2, dt);
    expect(world.faults.faults.map(({ entity, code }) => [entity, code])).toEqual([[eids[3], 'E_RANGE']]);
    expect(Velocity.x[eids[3]]).toBe(0);
  });
});

describe('the law at fault', () => {
  const kind = WORLD_KINDS[0];

  test('the first non-finite law of the list is named, for every integrator', () => {
    for (const { create } of Object.values(INTEGRATORS)) {
      const integrator = create();
      if (integrator.scheme === undefined) continue;
      const { world, eids } = scene(kind, forces(), integrator);
      world.components.Charge.value[eids[4]] = -2;
      step(world, 0.01);
      expect(world.faults.faults.map(({ entity, law }) => [entity, law])).toEqual([[eids[4], 'root of the charge']]);
    }
  });

  test('a strong but finite law is not named', () => {
    const giant = defineLaw({ name: 'giant', force: () => vec3(1e300, 0) })();
    const world = createPhysicsWorld({ capacity: 10, forces: [giant] });
    const eid = spawn(world, { position: {}, velocity: {}, mass: 1e-20 });
    step(world, 1);
    const [fault] = world.faults.faults;
    expect(fault.entity).toBe(eid);
    expect(fault.law).toBeUndefined();
  });

  test('bodies of one SIMD vector may fail by different laws', () => {
    const log = defineLaw({
      name: 'log',
      reads: { motor: COMPONENTS.Motor },
      force: ({ motor }) => vec3(motor.power.log(), 0),
    })();
    const { world, eids } = scene(kind, [root, log], rungeKutta4);
    world.components.Motor.power.fill(1);
    world.components.Charge.value[eids[0]] = -1;
    world.components.Motor.power[eids[1]] = -1;
    step(world, 0.01);
    const blamed = world.faults.faults.map(({ entity, law }) => [entity, law]);
    expect(blamed).toEqual([
      [eids[0], 'root of the charge'],
      [eids[1], 'log'],
    ]);
  });
});
