import { addComponent } from 'bitecs';
import { describe, expect, test } from 'vitest';
import { forceOn, lawOn, read, run, single } from '../../../../test/support/laws.ts';
import {
  columnsOf,
  constantTorque,
  createPhysicsWorld,
  defineComponent,
  defineForce,
  dormandPrince,
  energy,
  type Force,
  heun,
  linearDrag,
  PhysicsError,
  positionVerlet,
  type Region,
  realField,
  restrictForce,
  rungeKutta4,
  semiImplicitEuler,
  spawn,
  springs,
  step,
  uniformGravity,
  velocityVerlet,
  type Warning,
  yoshida4,
  yoshida6,
} from '../index.ts';

const gravity = uniformGravity({ y: -10 });

const Windy = defineComponent({ fields: { f: realField('') } });
const Marked = defineComponent({ fields: {} });

describe('restrictForce', () => {
  const pull = defineForce({
    name: 'pull',
    reads: ['Mass'],
    accumulate({ components: { Mass }, scratch: { force } }, first, last) {
      for (let eid = first; eid < last; eid++) force.y[eid] -= 10 * Mass.value[eid];
    },
    potential: ({ components: { Mass, Position }, lastId }) => {
      let sum = 0;
      for (let eid = 1; eid <= lastId; eid++) sum += 10 * Mass.value[eid] * Position.y[eid];
      return sum;
    },
  });

  test.each([
    ['a law', gravity],
    ['a function', pull],
  ])('%s to a group of custom components: acts only on bodies with all of them', (_, force) => {
    const limited = restrictForce(force, { group: [Windy, Marked, 'Charge'] });
    const world = createPhysicsWorld({ capacity: 20, components: [Windy, Marked], forces: [limited] });
    const ids = [0, 1, 2].map((y) => spawn(world, { position: { y }, velocity: {}, mass: 2, charge: 1 }));
    for (const id of ids.slice(1)) addComponent(world, id, columnsOf(world, Windy));
    addComponent(world, ids[2], columnsOf(world, Marked));
    expect(energy(world).potential).toBe(40);
    step(world, 0.5);
    expect(ids.map((id) => world.components.Velocity.y[id])).toEqual([0, 0, -5]);
  });

  test.each([
    ['a law', gravity],
    ['a function', pull],
  ])('%s to a custom component that the world lacks is refused before anything moves', (_, force) => {
    const world = createPhysicsWorld({ capacity: 20, forces: [restrictForce(force, { group: Windy })] });
    const id = spawn(world, { position: {}, velocity: { x: 1 }, mass: 2 });
    expect(() => step(world, 0.5)).toThrow(/created without the component \{f\}.*components: \[MyComponent\]/);
    expect([world.tick, world.components.Position.x[id]]).toEqual([0, 0]);
  });

  test('reads the components of its group, so that none of them is said to have no effect', () => {
    const warnings: string[] = [];
    const forces = [restrictForce(gravity, { group: 'Charge' }), restrictForce(pull, { group: ['Lift', 'Mass'] })];
    const onWarning = ({ message }: Warning) => warnings.push(message);
    const world = createPhysicsWorld({ capacity: 20, forces, onWarning });
    spawn(world, { position: {}, velocity: {}, mass: 1, charge: 1, lift: 1 });
    step(world, 0.1);
    expect(warnings).toEqual([]);
    expect(forces[1].reads).toEqual(['Mass', 'Lift']);
  });

  test('to a group: acts only on bodies with all of its components', () => {
    const law = restrictForce(gravity, { group: ['Mass', 'Charge'] });
    const world = createPhysicsWorld({ capacity: 20, forces: [linearDrag({ x: 1 }), law] });
    const with_ = spawn(world, { position: {}, velocity: {}, mass: 2, charge: 1, linearDrag: 3 });
    const without = spawn(world, { position: {}, velocity: {}, mass: 2, linearDrag: 3 });
    expect(forceOn(world, with_)).toMatchObject({ x: 3, y: -20 });
    expect(forceOn(world, without)).toMatchObject({ x: 3, y: 0 });
  });

  test('to a box or a ball: other bodies are unchanged to the bit', () => {
    const inside = (region: Region, x: number, y: number) => {
      const { world, eid } = single([linearDrag({ x: 0.1 }), restrictForce(gravity, { region })], {
        position: { x, y },
        linearDrag: 3,
      });
      const force = forceOn(world, eid);
      expect(force.x).toBe(0.1 * 3);
      return force.y === -10;
    };
    const box = { min: { x: -1 }, max: { x: 1, y: 5 } };
    expect([inside(box, 0, -1e9), inside(box, 1, 5), inside(box, 1.1, 0), inside(box, 0, 5.1)]).toEqual([
      true,
      true,
      false,
      false,
    ]);
    const ball = { centre: { x: 3 }, radius: 2 };
    expect([inside(ball, 5, 0), inside(ball, 3, 2), inside(ball, 4.5, 1.5)]).toEqual([true, true, false]);
  });

  test('to a time: a push from 1 s to 2 s', () => {
    const { world, going } = single([restrictForce(gravity, { from: 1, until: 2 })]);
    run(world, 3, 1 / 64);
    // Verlet evaluates the force at both ends of a step, so the two steps at the borders count half each.
    expect(going().y).toBeCloseTo(-10, 9);
  });

  test.each([30, 50, 60, 120, 144, 240])('to a time: 5 s are as many steps of 1/%d s as they should be', (rate) => {
    const pull = defineForce({
      name: 'pull',
      accumulate({ scratch: { force } }, first, last) {
        for (let row = first; row < last; row++) force.y[row] -= 10;
      },
    });
    for (const force of [gravity, pull]) {
      const limited = restrictForce(force, { from: 2, until: 7 });
      const { world, going } = single([limited], {}, { integrator: semiImplicitEuler });
      for (let i = 0; i < 8 * rate; i++) step(world, 1 / rate);
      // A step more or less would be 10/rate.
      expect(going().y).toBeCloseTo(-50, 8);
    }
  });

  test.each(Object.entries({ semiImplicitEuler, velocityVerlet, rungeKutta4, heun }))(
    'to a time: a torque from 1 s to 2 s turns by τ t/I, whatever stages %s has',
    (_name, integrator) => {
      const own = defineForce({
        name: 'own torque',
        appliesTorque: true,
        accumulate({ scratch: { force, torque }, components }, first, last) {
          for (let row = first; row < last; row++) {
            torque.z[row] += 3 * components.Mass.value[row];
            force.x[row] += 3 * components.Mass.value[row];
          }
        },
      });
      for (const force of [constantTorque({ z: 3 }), own]) {
        const forces = [restrictForce(force, { from: 1, until: 2 })];
        const world = createPhysicsWorld({ capacity: 10, integrator, forces });
        const eid = spawn(world, {
          position: {},
          velocity: {},
          mass: 1,
          inertia: 1,
          rotation: {},
          angularVelocity: {},
        });
        run(world, 3, 1 / 64);
        expect(world.components.AngularVelocity.z[eid]).toBeCloseTo(3, 12);
        // A force with torque acts in the same steps.
        expect(world.components.Velocity.x[eid]).toBeCloseTo(force === own ? 3 : 0, 12);
      }
    },
  );

  test('works with user-defined forces, nested and with torque', () => {
    const plain = defineForce({
      name: 'plain',
      accumulate({ scratch, components }, first, last) {
        for (let eid = first; eid < last; eid++) scratch.force.x[eid] += components.Mass.value[eid];
      },
    });
    const nested = restrictForce(restrictForce(plain, { region: { centre: {}, radius: 2 } }), { group: 'Charge' });
    const turned = restrictForce(constantTorque({ z: 3 }), { group: 'Charge' });
    const at = (x: number, charge?: number) => {
      const body = { position: { x }, inertia: 1, rotation: {}, angularVelocity: {} };
      const { world, eid } = single([gravity, nested, turned], charge === undefined ? body : { ...body, charge });
      const { x: fx, y: fy, torque } = forceOn(world, eid);
      return [fx, fy, torque];
    };
    expect(at(1, 1)).toEqual([1, -10, 3]);
    expect(at(3, 1)).toEqual([0, -10, 3]);
    expect(at(1)).toEqual([0, -10, 0]);
  });

  test('chunks and whole ranges give the same, to the bit', () => {
    const moved = (local: boolean) => {
      const law = restrictForce(gravity, { region: { min: { x: 10 }, max: { x: 30 } } });
      const world = createPhysicsWorld({ capacity: 6000, forces: [law] });
      if (!local) world.forces.push(defineForce({ name: 'nothing', local: false, accumulate: () => {} }));
      for (let i = 0; i < 5000; i++) spawn(world, { position: { x: i / 100 }, velocity: { x: 1 }, mass: 1 });
      for (let i = 0; i < 5; i++) step(world, 0.1);
      return Array.from(world.components.Position.y.subarray(0, 5002));
    };
    expect(moved(true)).toEqual(moved(false));
  });

  test('springs, which are not local, can be restricted to bodies', () => {
    const world = createPhysicsWorld({ capacity: 20, forces: [restrictForce(springs(), { group: 'Charge' })] });
    const a = spawn(world, { position: {}, velocity: {}, mass: 1, charge: 1 });
    const b = spawn(world, { position: { x: 2 }, velocity: {}, mass: 1 });
    spawn(world, { spring: { a, b, stiffness: 1, length: 1 } });
    step(world, 0.1);
    expect(read(world, a).speed()).toBeGreaterThan(0);
    expect(read(world, b).speed()).toBe(0);
  });

  test('has the potential of the group and of the time, and none for a region', () => {
    const world = createPhysicsWorld({ capacity: 20, forces: [restrictForce(gravity, { group: 'Charge' })] });
    spawn(world, { position: { y: 7 }, velocity: {}, mass: 2, charge: 1 });
    spawn(world, { position: { y: 5 }, velocity: {}, mass: 3 });
    expect(energy(world).potential).toBe(140);
    expect(world.components.Mass.value[2]).toBe(3);
    run(world, 1);
    expect(energy(world).total).toBeCloseTo(140, 9);
    expect(restrictForce(gravity, { from: 1 }).potential?.(world)).toBe(gravity.potential?.(world));
    expect(restrictForce(gravity, { from: 2 }).potential?.(world)).toBe(0);
    expect(restrictForce(gravity, { region: { centre: {}, radius: 1 } }).potential).toBeUndefined();
  });

  test('keeps a law a law, and other limits need no recompilation', () => {
    const structure = (force: Force) => force.law?.structure;
    const limits = { group: 'Charge', from: 1, region: { centre: { x: 1 }, radius: 2 } } as const;
    const other = { group: 'Charge', from: 7, region: { centre: { y: 3 }, radius: 5 } } as const;
    expect(structure(restrictForce(gravity, limits))).toBe(structure(restrictForce(gravity, other)));
    expect(structure(restrictForce(gravity, limits))).not.toBe(structure(gravity));
    const { world } = single([restrictForce(restrictForce(gravity, limits), other)]);
    step(world, 0.1);
    expect(world.internal.plan?.isOneLoop).toBe(true);
  });

  // Whatever the limits, what they give is that of a whole number of stages.
  test.each([
    [velocityVerlet, 1],
    [rungeKutta4, 1],
    [yoshida4, 2],
    [yoshida6, 1.5],
    [positionVerlet, 1.5],
    [dormandPrince(), 0.1],
  ] as const)('under $0.name limits of time are rounded by at most $1 steps', (integrator, most) => {
    for (let k = 0; k < 10; k++) {
      const [from, length, dt] = [0.1 + k * 0.0037, 0.2503 + k * 0.001, 1 / 60];
      const within = restrictForce(gravity, { from, until: from + length });
      const world = createPhysicsWorld({ integrator, precision: 'f64', capacity: 4, forces: [within] });
      const id = spawn(world, { position: {}, velocity: {}, mass: 1 });
      for (let i = 0; i < 40; i++) step(world, dt);
      const seconds = -world.components.Velocity.y[id] / 10;
      expect(Math.abs(seconds - length)).toBeLessThan(most * dt * (1 + 1e-9));
    }
  });

  test('applies nested limits together', () => {
    const nested = restrictForce(restrictForce(gravity, { region: { min: { x: 0 }, max: {} } }), {
      region: { min: {}, max: { x: 2 } },
    });
    const at = (x: number) => lawOn(nested, { position: { x } }).y;
    expect([at(-1), at(1), at(3)]).toEqual([0, -10, 0]);
  });

  test('refuses invalid limits', () => {
    expect(() => restrictForce(gravity, { group: 'Colour' as never })).toThrow(/"Colour" is not a component/);
    for (const group of [{}, 3, new Set(['Charge']), [Windy, 3], [['Charge']]]) {
      expect(() => restrictForce(gravity, { group: group as never })).toThrow(
        /E_TYPE.*restrictForce\.group must be the name of a component, a component made by defineComponent, or a list of these/,
      );
    }
    expect(() => restrictForce(gravity, { region: { min: { x: 1 }, max: { x: 0 } } })).toThrow(PhysicsError);
    expect(() => restrictForce({} as never, {})).toThrow(PhysicsError);
    expect(() => restrictForce(gravity, { until: Number.NaN })).toThrow(PhysicsError);
  });
});
