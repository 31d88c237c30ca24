import { describe, expect, test } from 'vitest';
import {
  boxWalls,
  createPhysicsWorld,
  discInertia,
  type PhysicsWorld,
  particleContacts,
  rungeKutta4,
  semiImplicitEuler,
  spawn,
  step,
  uniformGravity,
  velocityVerlet,
} from '../index.ts';

const G = 9.81;
const SLOPE = 0.3;
const RADIUS = 0.25;
const DT = 1 / 60;
const ALONG = G * Math.sin(SLOPE);
const ACROSS = G * Math.cos(SLOPE);

const WALLS = ['box', 'plane', 'segment'] as const;
const INTEGRATORS = { velocityVerlet, rungeKutta4, semiImplicitEuler };

interface Slope {
  readonly wall: (typeof WALLS)[number];
  readonly dimensions?: 2 | 3;
  readonly integrator?: keyof typeof INTEGRATORS;
  readonly friction: number;
}

/** A slope that is drawn level, under a gravity that leans. */
function slope({ wall, dimensions = 2, integrator = 'velocityVerlet', friction }: Slope): PhysicsWorld {
  const world = createPhysicsWorld({
    dimensions,
    preset: particleContacts,
    integrator: INTEGRATORS[integrator],
    forces: [uniformGravity({ x: ALONG, y: -ACROSS })],
    walls: wall === 'box' ? [boxWalls({ min: { y: 0 }, friction })] : [],
  });
  if (wall === 'plane') spawn(world, { planeWall: { ny: 1, offset: 0, friction } });
  if (wall === 'segment') spawn(world, { segmentWall: { ax: -5, ay: 0, bx: 50, by: 0, friction } });
  return world;
}

const block = (world: PhysicsWorld, friction: number) =>
  spawn(world, { position: { y: RADIUS }, velocity: {}, mass: 2, collider: { radius: RADIUS, friction } });

function run(world: PhysicsWorld, steps: number): void {
  for (let i = 0; i < steps; i++) step(world, DT);
}

const CASES = WALLS.flatMap((wall) =>
  ([2, 3] as const).flatMap((dimensions) =>
    (Object.keys(INTEGRATORS) as (keyof typeof INTEGRATORS)[])
      .filter(() => wall !== 'segment' || dimensions === 2)
      .map((integrator) => ({ wall, dimensions, integrator })),
  ),
);

describe.each(CASES)('on a $wall in $dimensions D under $integrator', (parts) => {
  test('a block that static friction holds stays where it is', () => {
    const world = slope({ ...parts, friction: 1 });
    const id = block(world, 1);
    run(world, 600);
    // What the step moves it by, half of g sin α dt² or all of it, friction takes back, to rounding.
    expect(Math.abs(world.components.Position.x[id])).toBeLessThan(600 * 2 ** -50);
    expect(world.components.Velocity.x[id]).toBe(0);
    expect(world.components.Position.y[id]).toBeCloseTo(RADIUS, 12);
  });
});

describe.each(WALLS)('on a %s', (wall) => {
  test('a block that slides has gone (g sin α - μ g cos α) t²/2', () => {
    const world = slope({ wall, friction: 0.2 });
    const id = block(world, 0.2);
    run(world, 120);
    // Constant forces: velocity Verlet is exact, so that only the rounding of 120 steps is left.
    expect(world.components.Position.x[id]).toBeCloseTo((ALONG - 0.2 * ACROSS) * 2, 11);
  });

  test('a disc that rolls has gone g sin α t²/3', () => {
    const world = slope({ wall, friction: 1 });
    const id = spawn(world, {
      position: { y: RADIUS },
      velocity: {},
      angularVelocity: {},
      mass: 2,
      inertia: discInertia(2, RADIUS),
      collider: { radius: RADIUS, friction: 1 },
    });
    run(world, 120);
    expect(world.components.Position.x[id]).toBeCloseTo((ALONG / 3) * 4, 11);
  });

  test.each([0, 0.5, 1])('a block that strikes it with e = %d goes on from there with the slower speed', (e) => {
    const world = createPhysicsWorld({
      preset: particleContacts,
      walls: wall === 'box' ? [boxWalls({ min: { y: 0 }, friction: 0.1 })] : [],
    });
    if (wall === 'plane') spawn(world, { planeWall: { ny: 1, offset: 0, friction: 0.1 } });
    if (wall === 'segment') spawn(world, { segmentWall: { ax: -5, ay: 0, bx: 50, by: 0, friction: 0.1 } });
    // It meets the wall after 2.3 steps, without other forces.
    const position = { y: RADIUS + 2.3 * DT };
    const collider = { radius: RADIUS, friction: 0.1, restitution: e };
    const id = spawn(world, { position, velocity: { x: 3, y: -1 }, mass: 2, collider });
    run(world, 10);
    const { Position, Velocity } = world.components;
    expect(Velocity.x[id]).toBeCloseTo(3 - 0.1 * (1 + e), 12);
    expect(Position.x[id]).toBeCloseTo(DT * (3 * 2.3 + (3 - 0.1 * (1 + e)) * 7.7), 12);
    expect(Position.y[id]).toBeCloseTo(RADIUS + e * 7.7 * DT, 12);
  });
});

test('friction of a floor moves no body out of the box through a wall beside it', () => {
  const room = { min: { x: 0, y: 0 }, max: { x: 10 }, restitution: 1, friction: 1 };
  for (let i = 0; i < 40; i++) {
    const world = createPhysicsWorld({ preset: particleContacts, walls: [boxWalls(room)] });
    const position = { x: RADIUS + 0.02, y: RADIUS + 0.001 + 0.001 * i };
    const velocity = { x: -3, y: -4 };
    const id = spawn(world, { position, velocity, mass: 1, collider: { radius: RADIUS, friction: 1 } });
    for (let k = 0; k < 4; k++) {
      step(world, DT);
      expect(world.components.Position.x[id]).toBeGreaterThanOrEqual(RADIUS);
    }
  }
});
