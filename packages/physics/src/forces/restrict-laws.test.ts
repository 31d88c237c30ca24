// Every law of the package can be restricted to a group, a region or a time.
import { addComponent } from 'bitecs';
import { describe, expect, test } from 'vitest';
import { LAW_CASES, lawWorld } from '../../../../test/support/law-records.ts';
import { forceOn, run, single } from '../../../../test/support/laws.ts';
import { type Force, type Restrictions, restrictForce, rocketEngines, spawn, uniformGravity } from '../index.ts';

/** A force for the laws that react to the forces before them. */
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

  test('acts only on the group', () => {
    const group = kept({ group: 'Appearance' });
    expect(on(group)).toEqual(none);
    const tagged = on(group, ({ world, subject }) => addComponent(world, subject, world.components.Appearance));
    expect(tagged).toEqual(free);
  });

  test('acts only in the region', () => {
    const here = { min: { x: 1, y: 0 }, max: { x: 2, y: 1 } };
    expect(on(kept({ region: here }))).toEqual(free);
    expect(on(kept({ region: { centre: { x: 1.1, y: 0.3, z: 0.2 }, radius: 0.01 } }))).toEqual(free);
    expect(on(kept({ region: { min: { x: 1.2 }, max: {} } }))).toEqual(none);
    expect(on(kept({ region: { centre: { x: 5 }, radius: 1 } }))).toEqual(none);
  });

  test('acts only within its time', () => {
    expect(on(kept({ from: 0, until: 1e-9 }))).toEqual(free);
    expect(on(kept({ until: 0 }))).toEqual(none);
    expect(on(kept({ from: 1e-9 }))).toEqual(none);
  });
});

describe('a restricted engine', () => {
  const engine = { exhaustSpeed: 100, burnRate: 0.5, fuel: 4, y: 1 };
  const rocket = (limits: Restrictions) =>
    single([restrictForce(rocketEngines({ frame: 'world' }), limits)], { mass: 10, engine });

  test('burns only within its time and gains v_e ln(m₀/m₁)', () => {
    const { world, eid, going } = rocket({ from: 1, until: 3 });
    run(world, 5, 1 / 64);
    expect(world.components.Engine.fuel[eid]).toBeCloseTo(3, 12);
    expect(world.components.Mass.value[eid]).toBeCloseTo(9, 12);
    expect(going().y).toBeCloseTo(100 * Math.log(10 / 9), 11);
  });

  test('burns only for its group', () => {
    const { world, eid, going } = rocket({ group: 'Charge' });
    const charged = spawn(world, { position: {}, velocity: {}, mass: 10, engine, charge: 1 });
    run(world, 2, 1 / 64);
    const { fuel } = world.components.Engine;
    expect([fuel[eid], world.components.Mass.value[eid], going().y]).toEqual([4, 10, 0]);
    expect(fuel[charged]).toBeCloseTo(3, 12);
    expect(world.components.Velocity.y[charged]).toBeCloseTo(100 * Math.log(10 / 9), 11);
  });

  test('burns only in its region', () => {
    const { world, eid } = rocket({ region: { min: { x: 5 }, max: {} } });
    run(world, 2, 1 / 64);
    expect(world.components.Engine.fuel[eid]).toBe(4);
  });
});
