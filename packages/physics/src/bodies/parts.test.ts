// Which parts a body has, however bodies and parts came and went: compared with a look at every entity.
import { addComponent, removeComponent, removeEntity, set } from 'bitecs';
import { describe, expect, test } from 'vitest';
import {
  applyImpulse,
  bodyOf,
  box,
  createJoint,
  createPhysicsWorld,
  despawn,
  isBody,
  momentum,
  type PhysicsWorld,
  partsOf,
  restore,
  revolute,
  rigidBodies,
  snapshot,
  spawn,
  spawnCompound,
  spawnMany,
  springs,
  step,
} from '../index.ts';

const make = (capacity = 1000) => createPhysicsWorld({ preset: rigidBodies, capacity });

const compound = (world: PhysicsWorld, count: number) =>
  spawnCompound(world, {
    parts: Array.from({ length: count }, (_, i) => ({ shape: box(1, 1), x: i, density: 1 })),
  });

/** What `partsOf` says, by a look at every entity. */
function searched({ components, internal, lastId }: PhysicsWorld, body: number): number[] {
  const { body: of, bodyGeneration } = components.Attachment;
  const ids = Array.from({ length: lastId }, (_, i) => i + 1);
  return ids.filter((id) => of[id] === body && bodyGeneration[id] === internal.generations[body]);
}

const expectAll = (world: PhysicsWorld, bodies: Iterable<number>) => {
  for (const body of bodies) expect(partsOf(world, body)).toEqual(searched(world, body));
};

describe('parts of a body are', () => {
  test('those of its last life, while bodies and parts come and go', () => {
    const world = make(4000);
    const bodies = new Set<number>();
    for (let i = 0; i < 900; i++) {
      bodies.add(compound(world, 1 + ((i * 7) % 5)).body);
      const [oldest] = bodies;
      if (i % 3 > 0) {
        expectAll(world, [oldest]);
        const parts = partsOf(world, oldest);
        despawn(world, oldest);
        bodies.delete(oldest);
        expect(parts.map((id) => isBody(world, id))).toEqual(parts.map(() => false));
      }
      if (i % 5 === 0) for (const part of partsOf(world, [...bodies][0]).slice(1)) despawn(world, part);
    }
    expectAll(world, bodies);
  });

  test('found when more were made than are noted', () => {
    const world = make(20_000);
    const first = compound(world, 2).body;
    expectAll(world, [first]);
    const made = Array.from({ length: 3000 }, () => compound(world, 3).body);
    expectAll(world, [first, made[0], made[2999]]);
    despawn(world, made[1500]);
    expect(world.internal.counts.Attachment).toBe(2 + 2999 * 3);
  });

  test('also those that were attached by hand, in bulk, and to another body than before', () => {
    const world = make();
    const { Attachment } = world.components;
    const [one, other] = [compound(world, 1).body, compound(world, 1).body];
    const part = spawn(world, { position: {}, rotation: 0, collider: { shape: box(1, 1) } });
    addComponent(world, part, set(Attachment, { body: one, x: 2 }));
    spawnMany(world, 3, { position: {}, rotation: {}, collider: { shape: box(1, 1) }, attachment: { body: one } });
    expectAll(world, [one, other]);
    addComponent(world, part, set(Attachment, { body: other }));
    expectAll(world, [one, other]);
    expect(partsOf(world, other)).toContain(part);
    removeComponent(world, part, Attachment);
    expectAll(world, [one, other]);
    despawn(world, other);
    expect(isBody(world, part)).toBe(true);
  });

  test('those of a world that was brought back', () => {
    const world = make();
    const { body } = compound(world, 3);
    const taken = snapshot(world);
    despawn(world, partsOf(world, body)[1]);
    const later = compound(world, 2).body;
    expectAll(world, [body, later]);
    restore(world, taken);
    expectAll(world, [body]);
    expect(partsOf(world, body).length).toBe(3);
  });

  test('gone after the next step where bitECS removed the body', () => {
    const world = make();
    const { body, parts } = compound(world, 3);
    const rest = compound(world, 2);
    removeEntity(world, body);
    step(world, 1 / 60);
    expect([...parts, ...rest.parts].map((id) => isBody(world, id))).toEqual([false, false, false, true, true]);
  });

  test('of no other body that takes the id of theirs', () => {
    const world = make();
    const { body, parts } = compound(world, 2);
    removeEntity(world, body);
    const other = spawn(world, { position: { x: 100 }, mass: 1, collider: { radius: 0.5 } });
    expect(other).toBe(body);
    expect(() => bodyOf(world, parts[0])).toThrow(/E_STALE: part .* has lost its body/);
    expect(() => applyImpulse(world, parts[0], { x: 7 })).toThrow(/E_STALE/);
    expect(() => createJoint(world, revolute({ b: parts[0], anchor: {} }))).toThrow(/E_STALE/);
    expect(world.components.Velocity.x[other]).toBe(0);
  });
});

describe('a spring to a part of a body', () => {
  const joined = () => {
    const world = createPhysicsWorld({ preset: rigidBodies, forces: [springs()] });
    const made = compound(world, 2);
    const ball = spawn(world, { position: { y: 3 }, collider: { radius: 0.2, density: 10 } });
    return { world, made, ball };
  };

  test('is refused, and one to the body acts on it', () => {
    const { world, made, ball } = joined();
    const values = { a: ball, stiffness: 10, length: 1 };
    expect(() => spawn(world, { spring: { ...values, b: made.parts[1] } })).toThrow(/E_RANGE: spring.b .* part of a/);
    spawn(world, { spring: { ...values, b: made.body } });
    for (let i = 0; i < 20; i++) step(world, 1 / 60);
    expect(world.components.Velocity.y[ball]).toBeLessThan(-0.1);
    // What one end gets the other loses: Newton's third law, to rounding.
    expect(Math.abs(momentum(world).y)).toBeLessThan(1e-12);
  });

  test('is refused by the next step where its end became a part later', () => {
    const { world, made, ball } = joined();
    const end = spawn(world, { position: { x: 5 }, rotation: 0, collider: { radius: 0.1 } });
    spawn(world, { spring: { a: ball, b: end, stiffness: 10, length: 1 } });
    addComponent(world, end, set(world.components.Attachment, { body: made.body, x: 5 }));
    expect(() => step(world, 1 / 60)).toThrow(/E_RANGE: spring .* joins .* bodyOf\(world, part\)/s);
    expect(world.components.Velocity.y[ball]).toBe(0);
  });

  test('that only a written column says lets the islands end', () => {
    const { world, made, ball } = joined();
    const spring = spawn(world, { spring: { a: ball, b: made.body, stiffness: 10, length: 3 } });
    step(world, 1 / 60);
    world.components.Spring.b[spring] = made.parts[1];
    world.components.Spring.bGeneration[spring] = world.internal.generations[made.parts[1]];
    for (let i = 0; i < 120; i++) step(world, 1 / 60);
    expect(world.tick).toBe(121);
  });
});
