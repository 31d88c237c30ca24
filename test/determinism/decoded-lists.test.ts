/** What a world hands out reads the state of a decoded snapshot, although it lies elsewhere in the memory than before. */
import {
  aliveCount,
  births,
  burst,
  collideBodies,
  contacts,
  createEmitter,
  createPattern,
  createPhysicsWorld,
  decodeSnapshot,
  dispatchContactEvents,
  encodeSnapshot,
  mutualGravity,
  on,
  type PhysicsWorld,
  planeWalls,
  restore,
  snapshot,
  spawn,
  step,
  uniformGravity,
  wallContacts,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';

const DT = 1 / 60;

/** Makes `to` go on as `from`. */
function load(to: PhysicsWorld, from: PhysicsWorld): void {
  restore(to, decodeSnapshot(to, encodeSnapshot(snapshot(from))));
}

describe('contacts of a world in which a force took memory before them', () => {
  const make = () => {
    const world = createPhysicsWorld({
      capacity: 100,
      forces: [mutualGravity({ G: 1 }), uniformGravity()],
      walls: [planeWalls],
    });
    world.phases.collide.push(collideBodies);
    world.phases.events.push(dispatchContactEvents);
    return world;
  };
  const read = (world: PhysicsWorld) => {
    const [pairs, walls] = [contacts(world), wallContacts(world)];
    return {
      a: [...pairs.a.slice(0, pairs.count)],
      b: [...pairs.b.slice(0, pairs.count)],
      impulses: [...pairs.impulse.slice(0, pairs.count)],
      bodies: [...walls.body.slice(0, walls.count)],
      walls: [...walls.wall.slice(0, walls.count)],
    };
  };
  const play = () => {
    const world = make();
    spawn(world, { planeWall: {} });
    // Neighbours overlap by 0.1 m, and all are 0.1 m in the ground.
    for (let i = 0; i < 6; i++) {
      spawn(world, { position: { x: i * 0.9, y: 0.4 }, mass: 1, collider: { radius: 0.5 } });
    }
    step(world, DT);
    read(world);
    return world;
  };

  it.each([false, true])('are listed in a world that listed contacts of its own before: %s', (readBefore) => {
    const [saved, loaded] = [play(), make()];
    if (readBefore) read(loaded);
    load(loaded, saved);
    for (let i = 0; i < 5; i++) {
      for (const world of [saved, loaded]) step(world, DT);
      expect(read(loaded)).toEqual(read(saved));
      expect(contacts(loaded).count).toBeGreaterThan(0);
      expect(wallContacts(loaded).count).toBeGreaterThan(0);
    }
  });

  it('are told to handlers', () => {
    const [saved, loaded] = [play(), make()];
    load(loaded, saved);
    const told = [saved, loaded].map((world) => {
      const counts = { contact: 0, wallContact: 0 };
      on(world, 'contact', () => counts.contact++);
      on(world, 'wallContact', () => counts.wallContact++);
      step(world, DT);
      return counts;
    });
    expect(told[0].contact).toBeGreaterThan(0);
    expect(told[0].wallContact).toBeGreaterThan(0);
    expect(told[1]).toEqual(told[0]);
  });
});

describe('an emitter', () => {
  it('names the bodies that the snapshot gave it', () => {
    const make = (bodies: number) => {
      const world = createPhysicsWorld({ capacity: 100 });
      for (let i = 0; i < bodies; i++) spawn(world, { position: { x: i } });
      return createEmitter(world, { capacity: 5, rate: 10, lifetime: 100 });
    };
    const [saved, loaded] = [make(10), make(0)];
    for (let i = 0; i < 60; i++) step(saved.world, DT);
    load(loaded.world, saved.world);
    expect([...loaded.ids]).toEqual([11, 12, 13, 14, 15]);
    expect(aliveCount(loaded)).toBe(5);
  });

  it('bursts in a pattern that the other world stored elsewhere', () => {
    const make = (steps: number) => {
      const world = createPhysicsWorld({ capacity: 100 });
      const emitter = createEmitter(world, { capacity: 20, lifetime: 100 });
      // The first step takes memory.
      for (let i = 0; i < steps; i++) step(world, DT);
      return { world, emitter, pattern: createPattern(world, [{ x: 3, y: 4 }]) };
    };
    const [saved, loaded] = [make(1), make(0)];
    load(loaded.world, saved.world);
    const { world, emitter, pattern } = loaded;
    burst(emitter, 2, { pattern });
    step(world, DT);
    const { ids, count } = births(emitter);
    const { Velocity } = world.components;
    expect([...ids.slice(0, count)].map((eid) => [Velocity.x[eid], Velocity.y[eid]])).toEqual([
      [3, 4],
      [3, 4],
    ]);
  });
});
