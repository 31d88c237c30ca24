// Steps pass over groups of bodies that stand, as long as nothing of them changes: whatever users write between two steps is seen, and
// all goes on as if every step looked at every body.
import {
  box,
  capsule,
  circle,
  createPhysicsWorld,
  createRandom,
  despawn,
  type PhysicsWorld,
  type Random,
  restore,
  rigidBodies,
  setShape,
  snapshot,
  spawn,
  stateHash,
  step,
  uniformGravity,
} from '@principia/physics';
import { addComponent, addComponents, hasComponent, query, removeComponent, set } from 'bitecs';
import { expect, it } from 'vitest';
import { RigidTableWord, ROW_GROUP_BYTES, RowGroupWord } from '../memory/layouts.gen.ts';
import { rigidTable } from './rigid-table.ts';

const TILES = 96;

/** Rows of tiles, and boxes that fall on them and slide. */
function landscape(precision: 'f32' | 'f64'): PhysicsWorld {
  const world = createPhysicsWorld({ preset: rigidBodies, precision, capacity: 300, forces: [uniformGravity()] });
  for (let i = 0; i < TILES; i++) {
    spawn(world, { position: { x: i % 32, y: -Math.floor(i / 32) }, collider: { shape: box(1, 1), friction: 0.5 } });
  }
  for (let i = 0; i < 40; i++) {
    const shape = [box(0.6, 0.6), circle(0.3), capsule(0.4, 0.2)][i % 3];
    const position = { x: 2 + 0.7 * i, y: 1 + (i % 5) };
    spawn(world, { position, velocity: { x: i % 2 }, collider: { shape, density: 1, friction: 0.3 } });
  }
  return world;
}

/** The words of each group of rows. */
function* groupsOf(world: PhysicsWorld): Generator<Uint32Array> {
  const at = rigidTable(world).words[RigidTableWord.rowGroups];
  for (let first = 0; first < world.rows; first += 16) {
    yield new Uint32Array(world.memory.buffer, at + (ROW_GROUP_BYTES * first) / 16, ROW_GROUP_BYTES / 4);
  }
}

/** Makes the next step look at all rows. */
function lookAtAll(world: PhysicsWorld): void {
  for (const words of groupsOf(world)) words[RowGroupWord.isPlain] = 0;
}

const passed = (world: PhysicsWorld) =>
  [...groupsOf(world)].filter((words) => words[RowGroupWord.isPassed] === 1).length;

type Edit = (world: PhysicsWorld, tile: number, random: Random) => void;

const EDITS: Record<string, Edit> = {
  position: ({ components: { Position } }, tile, random) =>
    Object.assign(Position.y, { [tile]: random.uniform(-2, 0.3) }),
  rotation: ({ components: { Rotation } }, tile, random) =>
    Object.assign(Rotation.angle, { [tile]: random.uniform(-1, 1) }),
  shape: (world, tile) => setShape(world, tile, capsule(0.8, 0.3)),
  disc: ({ components: { Collider } }, tile) => Object.assign(Collider.radius, { [tile]: 0.7 }),
  friction: ({ components: { Collider } }, tile, random) =>
    Object.assign(Collider.friction, { [tile]: random.uniform(0, 2) }),
  belt: ({ components: { Collider } }, tile, random) =>
    Object.assign(Collider.tangentSpeed, { [tile]: random.uniform(-3, 3) }),
  rolling: ({ components: { Collider } }, tile) => Object.assign(Collider.rollingResistance, { [tile]: 0.2 }),
  bouncy: ({ components: { Collider } }, tile) => Object.assign(Collider.restitution, { [tile]: 0.8 }),
  layers: ({ components: { Collider } }, tile) => Object.assign(Collider.layers, { [tile]: 2 }),
  mask: ({ components: { Collider } }, tile, random) => Object.assign(Collider.mask, { [tile]: random.integer(0, 1) }),
  group: ({ components: { Collider } }, tile) => Object.assign(Collider.group, { [tile]: 3 }),
  sensor: ({ components: { Collider } }, tile) => Object.assign(Collider.sensor, { [tile]: 1 }),
  platform: ({ components: { Collider } }, tile) => Object.assign(Collider.oneWay, { [tile]: 1 }),
  moves: (world, tile, random) => {
    const { Velocity } = world.components;
    addComponent(world, tile, set(Velocity, { x: 0, y: 0 }));
    Velocity.y[tile] = random.uniform(-0.2, 0.2);
  },
  stops: ({ components: { Velocity } }, tile) => Object.assign(Velocity.y, { [tile]: 0 }),
  falls: (world, tile) => {
    const { AngularVelocity, Inertia, Mass, Velocity } = world.components;
    addComponents(
      world,
      tile,
      set(Velocity, {}),
      set(AngularVelocity, {}),
      set(Inertia, { value: 0.2 }),
      set(Mass, { value: 1 }),
    );
  },
  stands: (world, tile) => {
    const { Mass } = world.components;
    if (hasComponent(world, tile, Mass)) removeComponent(world, tile, Mass);
  },
  goes: (world, tile) => despawn(world, tile),
  comes: (world, tile) => {
    spawn(world, { position: { x: tile % 32, y: 0.5 }, collider: { shape: box(0.5, 0.5), friction: 0.5 } });
  },
};

it.each(['f32', 'f64'] as const)('a step that passes over groups is one that looks at all, in %s', (precision) => {
  const [quick, thorough] = [landscape(precision), landscape(precision)];
  let most = 0;
  const names = Object.keys(EDITS);
  for (let round = 0; round < 160; round++) {
    // One after the other, then at random.
    for (const world of [quick, thorough]) {
      const random = createRandom(round);
      const name = round < names.length ? names[round] : names[random.integer(0, names.length - 1)];
      const tiles = [...query(world, [world.components.Collider])].filter((id) => id <= TILES);
      EDITS[name](world, tiles[random.integer(0, tiles.length - 1)], random);
    }
    for (let i = 0; i < 6; i++) {
      lookAtAll(thorough);
      step(quick, 1 / 60);
      step(thorough, 1 / 60);
      most = Math.max(most, passed(quick));
      expect(passed(thorough)).toBe(0);
    }
    expect(stateHash(quick), `round ${round}`).toBe(stateHash(thorough));
  }
  expect(most).toBeGreaterThan(3);
});

it('what a snapshot brings back is looked at', () => {
  const world = landscape('f64');
  for (let i = 0; i < 5; i++) step(world, 1 / 60);
  const saved = snapshot(world);
  for (let i = 0; i < 60; i++) step(world, 1 / 60);
  const expected = stateHash(world);
  world.components.Position.y.fill(-50, 1, TILES);
  for (let i = 0; i < 5; i++) step(world, 1 / 60);
  expect(passed(world)).toBeGreaterThan(3);
  restore(world, saved);
  for (let i = 0; i < 60; i++) step(world, 1 / 60);
  expect(stateHash(world)).toBe(expected);
});
