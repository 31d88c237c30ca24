import { addComponent, addEntity, getEntityComponents, hasComponent, removeComponent } from 'bitecs';
import { describe, expect, it } from 'vitest';
import { spawnMany } from '../../bodies/spawn-many.ts';
import { createPhysicsWorld } from '../../world/create-world.ts';
import { ComponentSet } from './component-set.ts';

describe('the components of a body created in bulk', () => {
  it('equal the components that bitECS lists for a single body, including custom components', () => {
    const world = createPhysicsWorld({ capacity: 10 });
    const { Position, Velocity, Mass, Charge } = world.components;
    const Player = {};
    const [bulk] = spawnMany(world, 2, { position: {}, velocity: {}, mass: 1 });
    const hand = addEntity(world);
    for (const component of [Position, Velocity, Mass]) addComponent(world, hand, component);
    for (const eid of [bulk, hand]) {
      addComponent(world, eid, Player);
      addComponent(world, eid, Charge);
      removeComponent(world, eid, Velocity);
    }
    expect(new Set(getEntityComponents(world, bulk))).toEqual(new Set(getEntityComponents(world, hand)));
    expect(getEntityComponents(world, bulk)).toHaveLength(4);
    removeComponent(world, bulk, Player);
    expect(getEntityComponents(world, bulk)).not.toContain(Player);
    expect(hasComponent(world, bulk, Charge)).toBe(true);
  });
});

it('behaves as a set of components', () => {
  const world = createPhysicsWorld({ capacity: 1 });
  const { components } = world;
  const set = new ComponentSet(world, { first: 0, second: 0 });
  const Other = {};
  expect([set.size, set.has(Other), set.delete(Other)]).toEqual([0, false, false]);
  set.add(Other).add(components.Mass).add(components.Mass).add(components.Quarantined);
  expect([...set]).toEqual([components.Mass, components.Quarantined, Other]);
  expect([set.delete(components.Mass), set.delete(components.Mass), set.has(components.Mass)]).toEqual([
    true,
    false,
    false,
  ]);
  expect(set.size).toBe(2);
});
