// Queries by the trees of the broad phase find what queries that look at every body find, whatever happened since the step.
import {
  box,
  capsule,
  castShapeAll,
  circle,
  createPhysicsWorld,
  createRandom,
  decodeSnapshot,
  despawn,
  encodeSnapshot,
  nearestPoint,
  overlapShape,
  type PhysicsWorld,
  type Random,
  rayCast,
  rayCastAll,
  rayCastMany,
  restore,
  rigidBodies,
  segment,
  setShape,
  snapshot,
  spawn,
  spawnCompound,
  standard,
  step,
  uniformGravity,
} from '@principia/physics';
import { addComponent, query, set } from 'bitecs';
import { expect, test } from 'vitest';
import { bitOf } from '../components/membership.ts';
import { RigidTableWord } from '../memory/layouts.gen.ts';
import { rigidTable } from '../solver/rigid-table.ts';
import { openQuery } from './body-query.ts';

const SHAPES = [box(0.6, 0.4), capsule(0.5, 0.15), circle(0.3)];

/** A pile in motion, with fast bodies, sensors, walls and compounds. */
function pile(precision: 'f32' | 'f64', random: Random): PhysicsWorld {
  const world = createPhysicsWorld({ preset: rigidBodies, precision, capacity: 1000, forces: [uniformGravity()] });
  spawn(world, { position: { y: -0.5 }, collider: { shape: box(60, 1), friction: 0.5 } });
  spawn(world, { planeWall: { nx: 1, ny: 0, offset: -30 } });
  for (let i = 0; i < 300; i++) {
    const position = { x: random.uniform(-20, 20), y: random.uniform(0, 20) };
    const velocity = { x: random.uniform(-1, 1) * (i % 50 === 0 ? 200 : 5) };
    const collider = { shape: SHAPES[i % 3], density: 1, sensor: i % 40 === 0 };
    spawn(world, { position, velocity, rotation: random.uniform(-3, 3), collider });
  }
  for (let i = 0; i < 10; i++) {
    const part = { shape: SHAPES[i % 3], density: 1 };
    spawnCompound(world, { position: { x: 3 * i - 15, y: 22 }, parts: [part, { ...part, x: 0.8, y: 0.5 }] });
  }
  return world;
}

/** The same bodies where they are now, without a solver and without trees. */
function copyOf(world: PhysicsWorld): PhysicsWorld {
  const { precision } = world;
  const copy = createPhysicsWorld({ preset: standard, precision, capacity: 1000 });
  const { Position, Rotation, Collider } = world.components;
  for (let id = 1; id <= world.lastId; id++) {
    const isPlane = (world.internal.members[id] & bitOf('PlaneWall')) !== 0;
    const made = spawn(
      copy,
      isPlane
        ? { planeWall: { nx: 1, ny: 0, offset: -30 } }
        : { position: {}, rotation: 0, collider: { shape: SHAPES[0] } },
    );
    expect(made).toBe(id);
    if (isPlane) continue;
    const isBody = (world.internal.members[id] & 1) !== 0 && Collider.radius[id] > 0;
    copy.components.Position.x[id] = Position.x[id];
    copy.components.Position.y[id] = Position.y[id];
    copy.components.Rotation.angle[id] = Rotation.angle[id];
    // What is no body there is on no layer here.
    copy.components.Collider.layers[id] = isBody ? Collider.layers[id] : 0;
    copy.components.Collider.sensor[id] = Collider.sensor[id];
    const shape = SHAPES.find((each) => Math.abs(each.extent - Collider.radius[id]) < 1e-6) ?? box(60, 1);
    setShape(copy, id, shape);
  }
  return copy;
}

function ask(world: PhysicsWorld, random: Random): unknown[] {
  const at = () => ({ x: random.uniform(-25, 25), y: random.uniform(-2, 25) });
  return Array.from({ length: 12 }, () => [
    rayCast(world, at(), at()),
    rayCastAll(world, at(), at(), { sensors: true }),
    overlapShape(world, box(4, 3), { ...at(), angle: 0.4 }),
    castShapeAll(world, circle(0.5), at(), { x: random.uniform(-15, 15), y: random.uniform(-9, 9) }),
    nearestPoint(world, at()),
    nearestPoint(world, at(), { maxDistance: 2 }),
    nearestPoint(world, { x: 5000, y: 100 }),
  ]);
}

const usesTrees = (world: PhysicsWorld) => openQuery(world, { x: 0, y: 0, angle: 0, dx: 0, dy: 0 }, 0, {}).trees !== 0;

test.each(['f32', 'f64'] as const)('trees and all bodies give the same answers in %s', (precision) => {
  const random = createRandom(7);
  const world = pile(precision, random);
  usesTrees(world);
  for (let round = 0; round < 8; round++) {
    for (let i = 0; i < 5; i++) step(world, 1 / 60);
    expect(usesTrees(world)).toBe(true);
    const copy = copyOf(world);
    expect(ask(world, createRandom(round))).toEqual(ask(copy, createRandom(round)));
  }
});

test('bodies that moved, came, went or changed between two steps are seen as they are', () => {
  const random = createRandom(3);
  const world = pile('f64', random);
  usesTrees(world);
  const changes: ((id: number) => void)[] = [
    (id) => {
      world.components.Position.x[id] += 7;
    },
    (id) => {
      world.components.Rotation.angle[id] += 1;
    },
    (id) => {
      setShape(world, id, SHAPES[1]);
    },
    () => {
      spawn(world, { position: { x: 1, y: 1 }, collider: { shape: SHAPES[0] } });
    },
  ];
  for (const [i, change] of changes.entries()) {
    step(world, 1 / 60);
    expect(usesTrees(world)).toBe(true);
    change(20 + i);
    expect(usesTrees(world)).toBe(true);
    expect(ask(world, createRandom(i))).toEqual(ask(copyOf(world), createRandom(i)));
  }
  step(world, 1 / 60);
  despawn(world, 50);
  expect(overlapShape(world, circle(100), { x: 0, y: 0 })).not.toContain(50);
});

/** Makes queries look at all bodies until the next step. */
const forgetTrees = (world: PhysicsWorld) => {
  rigidTable(world).words[RigidTableWord.rememberedVersion] = -1;
};

test.each(['f32', 'f64'] as const)(
  'whatever changes between two steps, trees and all bodies give the same answers in %s',
  (precision) => {
    const random = createRandom(11);
    const world = pile(precision, random);
    const { Position, Rotation, Collider } = world.components;
    const bodies = () => [...query(world, [Position, Collider])].filter((id) => id > 2);
    const edits: ((id: number) => void)[] = [
      (id) => Object.assign(Position.x, { [id]: random.uniform(-25, 25) }),
      (id) => Object.assign(Rotation.angle, { [id]: random.uniform(-3, 3) }),
      // So many shapes that records of the pool are written over.
      (id) => setShape(world, id, box(random.uniform(0.2, 6), random.uniform(0.2, 6))),
      (id) => despawn(world, id),
      (id) => spawn(world, { position: { x: Position.x[id], y: 9 }, collider: { shape: SHAPES[id % 3], density: 1 } }),
      () => spawn(world, { position: { x: random.uniform(-25, 25) }, mass: 1 }),
    ];
    usesTrees(world);
    for (let round = 0; round < 40; round++) {
      step(world, 1 / 60);
      for (let i = 0; i < 8; i++) {
        const ids = bodies();
        edits[random.integer(0, edits.length - 1)](ids[random.integer(0, ids.length - 1)]);
        if (i % 3 > 0) continue;
        expect(usesTrees(world)).toBe(true);
        const answers = ask(world, createRandom(round));
        forgetTrees(world);
        expect(usesTrees(world)).toBe(false);
        expect(answers).toEqual(ask(world, createRandom(round)));
        step(world, 1 / 60);
      }
    }
  },
);

test.each(['f32', 'f64'] as const)(
  'where no step prepared for them, queries get a tree of their own, in %s',
  (precision) => {
    const random = createRandom(17);
    const world = pile(precision, random);
    const { Position } = world.components;
    const expectSame = (seed: number) => {
      expect(ask(world, createRandom(seed))).toEqual(ask(copyOf(world), createRandom(seed)));
      expect(usesTrees(world)).toBe(true);
    };
    expect(usesTrees(world)).toBe(false);
    expectSame(1);
    // As many steps without a query as they wait for one.
    for (let i = 0; i < 70; i++) step(world, 1 / 60);
    expect(usesTrees(world)).toBe(false);
    expectSame(2);
    // One row, then all of them.
    Position.x[40] += 3;
    expectSame(3);
    for (let id = 1; id <= world.lastId; id++) Position.x[id] += 1000;
    for (let id = 1; id <= world.lastId; id++) Position.x[id] -= 990;
    expectSame(4);
    const saved = snapshot(world);
    step(world, 1 / 60);
    restore(world, saved);
    expect(usesTrees(world)).toBe(false);
    expectSame(5);
    step(world, 1 / 60);
    expectSame(6);
  },
);

test('many rays find what they find one by one', () => {
  const random = createRandom(5);
  const world = pile('f64', random);
  for (let i = 0; i < 3; i++) step(world, 1 / 60);
  const at = () => ({ x: random.uniform(-25, 25), y: random.uniform(-2, 25) });
  const rays = Array.from({ length: 40 }, () => ({ from: at(), to: at() }));
  const alone = rays.map(({ from, to }) => rayCast(world, from, to, { ignore: 7 }));
  expect(alone.filter((hit) => hit !== undefined).length).toBeGreaterThan(20);
  expect(rayCastMany(world, rays, { ignore: 7 })).toEqual(alone);
  expect(rayCastMany(world, [])).toEqual([]);
  expect(() => rayCastMany(world, undefined as never)).toThrow('rayCastMany: rays must be an array');
  expect(() => rayCastMany(world, [rays[0], { from: at(), to: { x: Number.NaN, y: 0 } }])).toThrow(/rays\[1\]/);
});

test('in a world that takes the snapshot of another, bodies that change one by one are all found', () => {
  const make = () => createPhysicsWorld({ preset: rigidBodies, capacity: 1000 });
  const saved = make();
  for (let i = 0; i < 300; i++) spawn(saved, { position: { x: 3 * i }, mass: 1, collider: { radius: 0.5 } });
  // Each restore raises the versions by which trees are known to be out of date.
  for (let i = 0; i < 12; i++) restore(saved, snapshot(saved));
  usesTrees(saved);
  step(saved, 1 / 60);
  expect(usesTrees(saved)).toBe(true);
  const loaded = make();
  restore(loaded, decodeSnapshot(loaded, encodeSnapshot(snapshot(saved))));
  for (let i = 0; i < 30; i++) {
    addComponent(loaded, i + 1, set(loaded.components.Collider, { radius: 1.4 }));
    const [above, below] = [10, -10].map((y) => ({ x: 3 * i + 1.2, y }));
    expect(rayCast(loaded, above, below)?.body).toBe(i + 1);
    expect(overlapShape(loaded, circle(0.01), { x: 3 * i + 1.2 })).toEqual([i + 1]);
  }
});

test('sensors are seen when asked for, and lines without thickness are found', () => {
  const world = createPhysicsWorld({ preset: rigidBodies, capacity: 500 });
  const zone = spawn(world, { position: { x: 5 }, collider: { shape: box(1, 1), sensor: true } });
  const line = spawn(world, { position: { x: 9 }, collider: { shape: segment({ y: -1 }, { y: 1 }) } });
  for (let i = 0; i < 250; i++) spawn(world, { position: { x: i, y: 50 }, collider: { radius: 0.1 } });
  for (let i = 0; i < 3; i++) {
    expect(rayCast(world, {}, { x: 20 })?.body).toBe(line);
    expect(rayCast(world, {}, { x: 20 }, { sensors: true })?.body).toBe(zone);
    expect(overlapShape(world, circle(1), { x: 5 })).toEqual([]);
    step(world, 1 / 60);
  }
  expect(() => rayCast(world, {}, { x: 1 }, { sensors: 1 as never })).toThrow(
    expect.objectContaining({ code: 'E_TYPE' }),
  );
});
