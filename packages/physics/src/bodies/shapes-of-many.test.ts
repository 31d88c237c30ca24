// Bodies with a shape each, made at once, are what they are made one by one.
import {
  box,
  capsule,
  chain,
  circle,
  createPhysicsWorld,
  type PhysicsWorld,
  polygon,
  rigidBodies,
  shapeAt,
  spawn,
  spawnChain,
  spawnMany,
  step,
  uniformGravity,
} from '@principia/physics';
import { query } from 'bitecs';
import { expect, it } from 'vitest';

const SHAPES = [
  box(1, 0.5),
  circle(0.3),
  capsule(1, 0.2),
  polygon([
    { x: 0, y: 0 },
    { x: 1, y: 0 },
    { x: 0, y: 1 },
  ]),
];
const COUNT = 8;
const shapes = Array.from({ length: COUNT }, (_, i) => SHAPES[i % SHAPES.length]);

const make = (): PhysicsWorld =>
  createPhysicsWorld({ preset: rigidBodies, precision: 'f64', capacity: 100, forces: [uniformGravity()] });

/** All values of the components of bodies. */
function valuesOf(world: PhysicsWorld): unknown {
  const names = ['Position', 'Rotation', 'Velocity', 'AngularVelocity', 'Mass', 'Inertia', 'Collider', 'Hull'] as const;
  return names.map((name) => {
    const columns = world.components[name] as unknown as Record<string, ArrayLike<number>>;
    const ids = [...query(world, [world.components[name]])];
    return [name, ids, Object.entries(columns).map(([field, column]) => [field, ids.map((id) => column[id])])];
  });
}

it.each([
  ['a density', { density: 3 }, {}],
  ['a mass', {}, { mass: 2 }],
  ['hulls', { density: 3 }, { hull: {} }],
  ['an inertia', { density: 3 }, { inertia: 7 }],
  ['nothing that moves them', { friction: 0.2 }, {}],
])('with %s', (_, collider, more) => {
  const [one, other] = [make(), make()];
  const x = shapes.map((__, i) => 3 * i);
  const ids = spawnMany(one, COUNT, { position: { x, y: 1 }, collider: { ...collider, shape: shapes }, ...more });
  expect([...ids]).toEqual(shapes.map((__, i) => i + 1));
  for (const [i, shape] of shapes.entries()) {
    spawn(other, { position: { x: x[i], y: 1 }, collider: { ...collider, shape }, ...more });
  }
  expect(valuesOf(one)).toEqual(valuesOf(other));
  for (let i = 0; i < 30; i++) {
    step(one, 1 / 60);
    step(other, 1 / 60);
  }
  expect(valuesOf(one)).toEqual(valuesOf(other));
});

it('a thousand different shapes are those of their bodies', () => {
  const world = createPhysicsWorld({ preset: rigidBodies, capacity: 2000 });
  const many = Array.from({ length: 1000 }, (_, i) => box(1, 1 + i / 1000));
  const ids = spawnMany(world, many.length, { position: {}, collider: { shape: many } });
  const { shape } = world.components.Collider;
  for (const [i, id] of ids.entries()) expect(shapeAt(world, shape[id])).toBe(many[i]);
});

it('masses may be given for each', () => {
  const world = make();
  const mass = shapes.map((_, i) => i + 1);
  spawnMany(world, COUNT, { position: {}, mass, collider: { shape: shapes } });
  const { Mass, Inertia } = world.components;
  for (const [i, shape] of shapes.entries()) {
    expect(Mass.value[i + 1]).toBe(i + 1);
    expect(Inertia.value[i + 1]).toBe((i + 1) * shape.inertiaPerMass);
  }
});

it('refuses lists that do not fit, and makes nothing', () => {
  const world = make();
  const spawnWith = (collider: object) => () => spawnMany(world, COUNT, { position: {}, collider });
  expect(spawnWith({ shape: shapes.slice(1) })).toThrow('collider.shape has 7 shapes for 8 bodies');
  expect(spawnWith({ shape: shapes.with(2, 9 as never) })).toThrow('collider.shape[2]');
  expect(spawnWith({ shape: shapes, radius: 1 })).toThrow('radius');
  expect(spawnWith({ shape: shapes, density: -1 })).toThrow('collider.density');
  const [segment] = chain([
    { x: 1, y: 0 },
    { x: 0, y: 0 },
  ]);
  expect(spawnWith({ shape: shapes.with(5, segment), density: 1 })).toThrow('collider.shape[5] is a segment');
  expect(world.lastId).toBe(0);
});

it('puts a chain where its position says', () => {
  const points = [
    { x: 2, y: 1 },
    { x: 1, y: 0 },
    { x: -3, y: 0 },
  ];
  const at = { x: 5e6, y: -20 };
  const far = make();
  const ids = spawnChain(far, points, { friction: 0.3 }, { position: at });
  const { Position } = far.components;
  expect(ids.map((id) => [Position.x[id], Position.y[id]])).toEqual([
    [at.x + 1.5, at.y + 0.5],
    [at.x - 1, at.y],
  ]);
  expect(() => spawnChain(far, points, {}, { position: { x: Number.NaN } })).toThrow('spawnChain: position');
  expect(() => spawnChain(far, points, {}, { place: at } as never)).toThrow('place');
});
