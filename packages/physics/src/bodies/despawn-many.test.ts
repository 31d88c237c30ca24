import { entityExists, observe, onRemove, query } from 'bitecs';
import { describe, expect, it } from 'vitest';
import {
  box,
  createPhysicsWorld,
  despawnMany,
  isBody,
  on,
  type PhysicsWorld,
  particleContacts,
  partsOf,
  rigidBodies,
  spawn,
  spawnCompound,
  spawnMany,
  stateHash,
  step,
} from '../index.ts';

const make = () => createPhysicsWorld({ preset: rigidBodies, capacity: 100 });

const bodiesOf = (world: PhysicsWorld) => [...query(world, [world.components.Position])].sort((a, b) => a - b);

describe('despawnMany', () => {
  it('removes the bodies of a list, of a query or of nothing', () => {
    const world = make();
    const ids = spawnMany(world, 20, { position: {}, mass: 1 });
    despawnMany(world, ids.subarray(0, 5));
    despawnMany(world, [ids[7], ids[7]]);
    despawnMany(world, []);
    expect(bodiesOf(world)).toEqual([...ids].filter((_, i) => i > 4 && i !== 7));
    despawnMany(world, query(world, [world.components.Position]));
    expect(bodiesOf(world)).toEqual([]);
  });

  it('removes parts with their body, once', () => {
    const world = make();
    const { body } = spawnCompound(world, { parts: [0, 1].map((x) => ({ shape: box(1, 1), x, density: 1 })) });
    const parts = partsOf(world, body);
    despawnMany(world, [body, ...parts]);
    expect([body, ...parts].some((id) => isBody(world, id))).toBe(false);
  });

  it.each([[99], [1.5], ['1'], [undefined], [-1], [Number.NaN]])('leaves all where %s names nothing', (id) => {
    const world = make();
    const ids = spawnMany(world, 3, { position: {} });
    const before = stateHash(world);
    expect(() => despawnMany(world, [...ids, id as number])).toThrow(expect.objectContaining({ code: 'E_STALE' }));
    expect([bodiesOf(world), stateHash(world)]).toEqual([[...ids], before]);
  });

  it.each([[5], [null], [undefined], [{}], ['12']])('refuses %s for a list', (ids) => {
    expect(() => despawnMany(make(), ids as never)).toThrow(expect.objectContaining({ code: 'E_TYPE', field: 'ids' }));
  });

  it('refuses ids that another world returned', () => {
    const ids = spawnMany(make(), 2, { position: {} });
    const world = make();
    spawnMany(world, 2, { position: {} });
    expect(() => despawnMany(world, ids)).toThrow(expect.objectContaining({ code: 'E_TYPE' }));
    expect(bodiesOf(world)).toHaveLength(2);
  });

  it('removes all although an observer throws, and leaves what an observer spawns', () => {
    const world = make();
    const ids = spawnMany(world, 4, { position: {} });
    let late = 0;
    observe(world, onRemove(world.components.Position), (id: number) => {
      if (id === ids[0]) late = spawn(world, { position: { x: 7 } });
      throw new Error(`saw ${id}`);
    });
    expect(() => despawnMany(world, ids)).toThrow(`saw ${ids[0]}`);
    expect(bodiesOf(world)).toEqual([late]);
  });

  it('removes at the end of a step what a handler removes in it', () => {
    const world = createPhysicsWorld({ preset: particleContacts, capacity: 10 });
    const ids = spawnMany(world, 3, {
      position: { x: [0, 0.5, 5] },
      velocity: { x: [1, 0, 0] },
      mass: 1,
      collider: 0.2,
    });
    const during: boolean[] = [];
    on(world, 'contact', () => {
      despawnMany(world, ids);
      despawnMany(world, ids);
      // It is no body for who asks, and goes on to move until the step ends.
      during.push(isBody(world, ids[0]), entityExists(world, ids[0]));
    });
    step(world, 0.2);
    expect(during).toEqual([false, true]);
    expect(bodiesOf(world)).toEqual([]);
  });
});
