// A force may be limited to a group, a region or a time: asked of every law of the package.
import { addComponent } from 'bitecs';
import { describe, expect, test } from 'vitest';
import { LAW_CASES, lawWorld } from '../../../../test/support/law-records.ts';
import { forceOn, run, single } from '../../../../test/support/laws.ts';
import { type Force, type Restrictions, restrictForce, rocketEngines, spawn, uniformGravity } from '../index.ts';

/** For those laws that answer the forces before them. */
const before = () => [uniformGravity({ x: 1, y: -10 })];

describe.each(LAW_CASES)('$name', ({ record, dimensions }) => {
  const on = (wrap: (force: Force) => Force, prepare: (stage: ReturnType<typeof lawWorld>) => void = () => {}) => {
    const stage = lawWorld(record, dimensions, { before: before(), wrap });
    prepare(stage);
    return forceOn(stage.world, stage.subject);
  };
  const kept = (limits: Restrictions) => (force: Force) => restrictForce(force, limits);
  const free = on((force) => force);
  const none = on(() => restrictForce(uniformGravity({}), {}));

  test('acts on the group alone', () => {
    const group = kept({ group: 'Appearance' });
    expect(on(group)).toEqual(none);
    const tagged = on(group, ({ world, subject }) => addComponent(world, subject, world.components.Appearance));
    expect(tagged).toEqual(free);
  });

  test('acts in the region alone', () => {
    const here = { min: { x: 1, y: 0 }, max: { x: 2, y: 1 } };
    expect(on(kept({ region: here }))).toEqual(free);
    expect(on(kept({ region: { centre: { x: 1.1, y: 0.3, z: 0.2 }, radius: 0.01 } }))).toEqual(free);
    expect(on(kept({ region: { min: { x: 1.2 }, max: {} } }))).toEqual(none);
    expect(on(kept({ region: { centre: { x: 5 }, radius: 1 } }))).toEqual(none);
  });

  test('acts in its time alone', () => {
    expect(on(kept({ from: 0, until: 1e-9 }))).toEqual(free);
    expect(on(kept({ until: 0 }))).toEqual(none);
    expect(on(kept({ from: 1e-9 }))).toEqual(none);
  });
});

describe('a restricted engine', () => {
  const engine = { exhaustSpeed: 100, burnRate: 0.5, fuel: 4, y: 1 };
  const rocket = (limits: Restrictions) =>
    single([restrictForce(rocketEngines({ frame: 'world' }), limits)], { mass: 10, engine });

  test('burns in its time alone, and gains v_e ln(m₀/m₁)', () => {
    const { world, eid, going } = rocket({ from: 1, until: 3 });
    run(world, 5, 1 / 64);
    expect(world.components.Engine.fuel[eid]).toBeCloseTo(3, 12);
    expect(world.components.Mass.value[eid]).toBeCloseTo(9, 12);
    expect(going().y).toBeCloseTo(100 * Math.log(10 / 9), 11);
  });

  test('burns for its group alone', () => {
    const { world, eid, going } = rocket({ group: 'Charge' });
    const charged = spawn(world, { position: {}, velocity: {}, mass: 10, engine, charge: 1 });
    run(world, 2, 1 / 64);
    const { fuel } = world.components.Engine;
    expect([fuel[eid], world.components.Mass.value[eid], going().y]).toEqual([4, 10, 0]);
    expect(fuel[charged]).toBeCloseTo(3, 12);
    expect(world.components.Velocity.y[charged]).toBeCloseTo(100 * Math.log(10 / 9), 11);
  });

  test('burns in its region alone', () => {
    const { world, eid } = rocket({ region: { min: { x: 5 }, max: {} } });
    run(world, 2, 1 / 64);
    expect(world.components.Engine.fuel[eid]).toBe(4);
  });
});
