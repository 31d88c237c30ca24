import {
  createPhysicsWorld,
  defineForce,
  defineLaw,
  dormandPrince,
  type Force,
  linearDrag,
  type PhysicsWorld,
  particleContacts,
  quadraticDrag,
  rigidBodies,
  softStep,
  spawn,
  springs,
  standard,
  stateHash,
  step,
  uniformGravity,
  velocityVerlet,
} from '@principia/physics';
import { addComponent, set } from 'bitecs';
import { describe, expect, it } from 'vitest';
import {
  assertRefused,
  assertWorldAlive,
  ball,
  DT,
  groundWorld,
  KINDS,
  refusal,
  withWitness,
} from '../support/worlds.ts';

/** Returns a force on one body, with `newtons` along x. */
function push(eid: number, newtons: number): Force {
  return defineForce({
    name: 'push',
    accumulate({ scratch }, first, last) {
      if (eid >= first && eid < last) scratch.force.x[eid] += newtons;
    },
  });
}

/** A force on no body. */
function calm(world: PhysicsWorld): void {
  world.forces.push(push(0, 0));
}

function errorsOf(world: PhysicsWorld): unknown[] {
  try {
    step(world, DT);
  } catch (error) {
    expect(error).toBeInstanceOf(AggregateError);
    return (error as AggregateError).errors;
  }
  return [];
}

describe.each(KINDS)('forces, $dimensions D $precision', (kind) => {
  it('16 a NaN force stops its body, is reported once, and does not spread', () => {
    const { world, victim } = withWitness(({ world, victim }) => world.forces.push(push(victim, NaN)), kind, 20, calm);
    expect(world.faults.faults).toMatchObject([
      { code: 'E_NONFINITE', entity: victim, value: NaN, step: 0, phase: 'finish' },
    ]);
    expect(world.components.Position.x[victim]).toBe(0);
  });

  it('17 a force of 1e308 N keeps the state finite', () => {
    const { world, victim } = withWitness(
      ({ world, victim }) => world.forces.push(push(victim, 1e308)),
      kind,
      20,
      calm,
    );
    const { Position, Velocity } = world.components;
    expect([Position.x[victim], Velocity.x[victim]].every(Number.isFinite)).toBe(true);
    expect(world.faults.faults).toHaveLength(1);
  });

  it('20 a negative drag coefficient is refused', () => {
    const world = groundWorld(kind);
    const eid = ball(world, 0, 1);
    const { LinearDrag, QuadraticDrag } = world.components;
    const refused = { code: 'E_RANGE' };
    assertRefused(world, () => spawn(world, { position: {}, linearDrag: -1 }), { ...refused, field: 'linearDrag' });
    assertRefused(world, () => addComponent(world, eid, set(LinearDrag, -1)), { ...refused, entity: eid });
    assertRefused(world, () => addComponent(world, eid, set(QuadraticDrag, -1)), { ...refused, entity: eid });
  });

  it('20 a drag coefficient of -1e9 or NaN in the column affects only its body', () => {
    for (const bad of [-1e9, NaN]) {
      const { world } = withWitness(({ world, victim }) => {
        world.forces.push(linearDrag({ x: 1 }), quadraticDrag({ x: 1 }));
        addComponent(world, victim, set(world.components.LinearDrag, 1));
        world.components.LinearDrag.coefficient[victim] = bad;
      }, kind);
      expect(world.faults.faults.length).toBeGreaterThan(0);
    }
  });

  it('21 gravity of NaN is refused and the previous gravity stays', () => {
    const world = groundWorld(kind);
    ball(world, 0, 1);
    const forces = [...world.forces];
    assertRefused(world, () => world.forces.splice(0, 1, uniformGravity({ y: NaN })), {
      code: 'E_NONFINITE',
      field: 'uniform gravity.acceleration.y',
    });
    expect(world.forces).toEqual(forces);
    assertWorldAlive(world);
  });

  it('23 a force that throws makes the step throw after completion, and the world continues', () => {
    const world = groundWorld(kind);
    const eid = ball(world, 0, 5);
    const oops = new Error('oops');
    world.forces.push(
      defineForce({
        name: 'broken',
        accumulate() {
          throw oops;
        },
      }),
    );
    expect(errorsOf(world)[0]).toBe(oops);
    // Gravity acted nevertheless: v = -g dt.
    expect(world.components.Velocity.y[eid]).toBeCloseTo(-9.80665 * DT, 6);
    expect([world.tick, world.state]).toEqual([1, 'idle']);
    world.forces.pop();
    assertWorldAlive(world);
  });

  it('a force that adds forces ends: these act from the next step on', () => {
    const world = createPhysicsWorld({ ...kind, capacity: 100 });
    ball(world, 0, 5);
    let calls = 0;
    const growing = defineForce({
      name: 'growing',
      accumulate() {
        calls++;
        if (world.forces.length < 100) world.forces.push(growing);
      },
    });
    world.forces.push(growing);
    step(world, DT);
    expect(calls).toBeLessThan(100);
  });

  it.each([
    ['a name that is misspelt', { appliesTorqe: true }, 'E_UNKNOWN'],
    ['a flag that is a text', { local: 'no' }, 'E_TYPE'],
    ['a potential that is a number', { potential: 5 }, 'E_TYPE'],
  ])('defineForce refuses %s', (_, options, code) => {
    const force = { name: 'f', accumulate() {}, ...options } as Parameters<typeof defineForce>[0];
    expect(refusal(() => defineForce(force)).code).toBe(code);
  });

  it('23 a million exceptions per step are counted, not stored', () => {
    const world = createPhysicsWorld({ ...kind, capacity: 100 });
    ball(world, 0, 5);
    for (let i = 0; i < 1000; i++) {
      world.forces.push(
        defineForce({
          name: 'broken',
          accumulate() {
            throw new Error('oops');
          },
        }),
      );
    }
    const errors = errorsOf(world);
    expect(errors.length).toBeLessThanOrEqual(32);
    expect(() => step(world, DT)).toThrow('2000 error(s)'); // velocity Verlet evaluates twice
  });
});

describe('invalid forces, systems and integrators', () => {
  const NO_FORCES: readonly [string, unknown][] = [
    ['undefined', undefined],
    ['null', null],
    ['an empty object', {}],
    ['a string', 'gravity'],
    ['a function', () => 0],
    ['the maker instead of what it makes', uniformGravity],
  ];

  it.each(NO_FORCES)('23 %s among the forces is refused with its index, until it is removed', (_, bad) => {
    const world = groundWorld();
    ball(world, 0, 1);
    world.forces.push(bad as Force);
    assertRefused(world, () => step(world, DT), { code: 'E_TYPE', field: 'world.forces[1]', hint: /defineForce/ });
    world.forces.pop();
    assertWorldAlive(world);
  });

  it('23 a sparse array of forces is refused', () => {
    const world = groundWorld();
    world.forces[3] = uniformGravity();
    assertRefused(world, () => step(world, DT), { code: 'E_TYPE', field: 'world.forces[1]' });
  });

  it('23 an invalid system is refused', () => {
    const world = groundWorld();
    world.phases.input.push(undefined as never);
    assertRefused(world, () => step(world, DT), { code: 'E_TYPE', field: 'world.phases.input[0]' });
    world.phases.input.pop();
    assertWorldAlive(world);
  });

  it('23 an invalid integrator is refused, and the world continues with a valid one', () => {
    const world = groundWorld();
    ball(world, 0, 1);
    const { integrator } = world;
    world.integrator = undefined as never;
    assertRefused(world, () => step(world, DT), { code: 'E_TYPE', field: 'world.integrator' });
    world.integrator = integrator;
    assertWorldAlive(world);
  });

  it('23 a world is not created with them', () => {
    expect(refusal(() => createPhysicsWorld({ forces: [uniformGravity(), 5 as never] }))).toMatchObject({
      code: 'E_TYPE',
      field: 'forces[1]',
    });
    expect(refusal(() => createPhysicsWorld({ forces: 'gravity' as never })).code).toBe('E_TYPE');
    expect(refusal(() => createPhysicsWorld({ walls: [null as never] })).code).toBe('E_TYPE');
    expect(refusal(() => createPhysicsWorld({ integrator: {} as never })).code).toBe('E_TYPE');
    expect(refusal(() => createPhysicsWorld({ preset: 'standard' as never })).code).toBe('E_TYPE');
  });

  it.each([
    ['standard', standard],
    ['particleContacts', particleContacts],
    ['rigidBodies', rigidBodies],
  ])('23 the preset %s says that it was called, not passed', (name, preset) => {
    const { code, field, hint } = refusal(() => createPhysicsWorld({ preset: (preset as () => never)() }));
    expect([code, field]).toEqual(['E_TYPE', 'preset']);
    expect(hint).toContain(`createPhysicsWorld({ preset: ${name} })`);
  });

  it('23 an integrator that the preset would replace is refused', () => {
    const { code, field, hint } = refusal(() =>
      createPhysicsWorld({ preset: rigidBodies, integrator: velocityVerlet }),
    );
    expect([code, field]).toEqual(['E_RANGE', 'integrator']);
    expect(hint).toContain('the preset takes soft step');
    expect(createPhysicsWorld({ preset: rigidBodies, integrator: softStep({ substeps: 8 }) }).integrator.name).toBe(
      'soft step',
    );
  });

  it('23 a system, an integrator or a profile clock that throws does not lock the world', () => {
    const oops = () => {
      throw new Error('oops');
    };
    const world = groundWorld();
    ball(world, 0, 1);
    world.phases.input.push(oops);
    expect(() => step(world, DT)).toThrow(AggregateError);
    world.phases.input.pop();
    const { integrator } = world;
    world.integrator = { ...integrator, advance: oops };
    expect(() => step(world, DT)).toThrow(AggregateError);
    world.integrator = integrator;
    world.profile = { clock: oops, times: {} as never, stages: {} as never };
    expect(() => step(world, DT)).toThrow(AggregateError);
    world.profile = undefined;
    assertWorldAlive(world);
    expect(stateHash(world)).toMatch(/^[0-9a-f]{16}$/);
  });
});

it('a function in place of what it returns, and a component by its name, are refused with what to write', () => {
  const uncalled = refusal(() => createPhysicsWorld({ integrator: dormandPrince as never }));
  expect(uncalled.message).toContain('integrator is the function dormandPrince, and not what it returns.');
  expect(uncalled.hint).toBe('Call it: dormandPrince(), with its options if it takes any.');
  const force = refusal(() => createPhysicsWorld({ forces: [springs as never] }));
  expect(force.message).toContain('forces[0] is the function springs, and not what it returns.');
  const byName = refusal(() =>
    defineLaw({ name: 'pull', reads: { q: 'Charge' as never }, force: ({ position }) => position }),
  );
  expect(byName.hint).toBe('Import COMPONENTS and write COMPONENTS.Charge.');
});
