// Restitution 1 keeps the energy, whatever else happens in the world.
import { describe, expect, test } from 'vitest';
import { steps } from '../../../../test/support/worlds.ts';
import {
  boxWalls,
  createPhysicsWorld,
  createRandom,
  type PhysicsWorld,
  particleContacts,
  spawn,
  uniformGravity,
} from '../index.ts';

const G = 2;
const COLLIDER = { radius: 0.3, restitution: 1 };

const FLOORS = {
  box: () => {},
  plane: (world: PhysicsWorld) => spawn(world, { planeWall: { nx: 0, ny: 1, offset: 0, restitution: 1 } }),
  segment: (world: PhysicsWorld) => spawn(world, { segmentWall: { ax: -1e5, ay: 0, bx: 1e5, by: 0, restitution: 1 } }),
};

function worldWithFloor(floor: keyof typeof FLOORS, dimensions: 2 | 3 = 2): PhysicsWorld {
  const walls = floor === 'box' ? [boxWalls({ min: { y: 0 }, restitution: 1 })] : [];
  const world = createPhysicsWorld({
    preset: particleContacts,
    dimensions,
    precision: 'f64',
    forces: [uniformGravity({ y: -G })],
    walls,
  });
  FLOORS[floor](world);
  return world;
}

function disc(world: PhysicsWorld, x: number, y: number, vx: number, vy: number): number {
  return spawn(world, { position: { x, y }, velocity: { x: vx, y: vy }, mass: 1, collider: COLLIDER });
}

describe.each([
  ['box', 2],
  ['plane', 2],
  ['segment', 2],
  ['box', 3],
  ['plane', 3],
] as const)('two discs at a floor: %s, %d D', (floor, dimensions) => {
  const DT = 0.0025;

  // The first rebounds from the floor and is hit back to it in the same step; the others touch at rest, in free fall.
  test('depend on no others far away', () => {
    const [alone, beside] = [false, true].map((hasOthers) => {
      const world = worldWithFloor(floor, dimensions);
      disc(world, 0, 0.30321, -0.85433, -0.95856);
      disc(world, -0.0475, 0.91337, 0.61238, -4.61366);
      if (hasOthers) for (const x of [10, 10.6]) disc(world, x, 5, 0, 0);
      steps(world, 4, DT);
      const { Position, Velocity } = world.components;
      return [1, 2].flatMap((i) =>
        [Position.x, Position.y, Velocity.x, Velocity.y].map((column) => column[i + ids(floor)]),
      );
    });
    expect(beside).toEqual(alone);
  });

  // A disc that is hit back to the floor gets there in the next step, which finds it up to v dt below: that is m g v dt.
  test('keep their energy', () => {
    const world = worldWithFloor(floor, dimensions);
    const random = createRandom(7);
    const pairs = Array.from({ length: 200 }, (_, i) => {
      const y = COLLIDER.radius + 3 * DT * random.uniform();
      const distance = 2 * COLLIDER.radius + 5 * DT * random.uniform();
      const angle = random.uniform(-1.2, 1.2);
      const a = disc(world, 10 * i, y, random.uniform(-2, 2), random.uniform(-3, 0));
      const x = 10 * i + distance * Math.sin(angle);
      return [a, disc(world, x, y + distance * Math.cos(angle), random.uniform(-2, 2), random.uniform(-6, 0))];
    });
    const { Position, Velocity } = world.components;
    const energyOf = (pair: readonly number[]) =>
      pair.reduce((sum, i) => sum + (Velocity.x[i] ** 2 + Velocity.y[i] ** 2) / 2 + G * Position.y[i], 0);
    const before = pairs.map(energyOf);
    steps(world, 6, DT);
    const fastest = 10;
    pairs.forEach((pair, k) => {
      expect(Math.abs(energyOf(pair) - before[k])).toBeLessThan(2 * G * fastest * DT);
    });
  });
});

/** Entities before the first disc. */
const ids = (floor: keyof typeof FLOORS) => (floor === 'box' ? 0 : 1);
