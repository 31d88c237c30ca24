import { columnsOf, createPhysicsWorld, defineComponent, realField, spawn, stateHash } from '@principia/physics';
import { addComponent, removeComponent, set } from 'bitecs';
import { describe, expect, test } from 'vitest';

const Sail = defineComponent({ fields: { area: realField('m²') } });
const Tag = defineComponent({ fields: {} });

describe.each(['f32', 'f64'] as const)('in %s the hash', (precision) => {
  function make() {
    const world = createPhysicsWorld({ precision, capacity: 20, components: [Sail, Tag] });
    const id = spawn(world, { position: {}, velocity: { x: 1 }, mass: 1 });
    return { world, id, sail: columnsOf(world, Sail), tag: columnsOf(world, Tag) };
  }

  test('covers columns and membership of components of one’s own', () => {
    const { world, id, sail, tag } = make();
    const hashes = new Set([stateHash(world)]);
    addComponent(world, id, set(sail, { area: 1 }));
    hashes.add(stateHash(world));
    sail.area[id] = 2;
    hashes.add(stateHash(world));
    addComponent(world, id, tag);
    hashes.add(stateHash(world));
    expect(hashes.size).toBe(4);
    removeComponent(world, id, sail);
    removeComponent(world, id, tag);
    expect(stateHash(world)).toBe(stateHash(make().world));
    sail.area[id] = -0;
    expect(stateHash(world)).toBe(stateHash(make().world));
  });
});
