import { describe, expect, test } from 'vitest';
import {
  boxWalls,
  createPhysicsWorld,
  energy,
  type PhysicsWorldOptions,
  particleContacts,
  replaceBoxWalls,
  rigidBodies,
  semiImplicitEuler,
  spawn,
  standard,
  step,
  uniformGravity,
} from '../index.ts';

const floor = (g: number, options: PhysicsWorldOptions = {}) =>
  createPhysicsWorld({
    capacity: 10,
    forces: [uniformGravity({ y: -g })],
    walls: [boxWalls({ min: { y: 0 } })],
    ...options,
  });

/** Heights of successive apexes, relative to the resting position. */
function apexes(count: number, restitution: number, options: PhysicsWorldOptions = {}): number[] {
  // The bouncing ball of a book, in pixels and frames, released 430 px above the floor.
  const world = floor(0.1, options);
  const ball = spawn(world, {
    position: { y: 450 },
    velocity: { x: 2 },
    mass: 1,
    collider: { radius: 20, restitution },
  });
  const { y } = world.components.Position;
  const found: number[] = [];
  let [before, last] = [0, 450];
  for (let frame = 0; found.length < count && frame < 2000; frame++) {
    step(world, 1);
    if (last > before && last > y[ball]) found.push(last - 20);
    [before, last] = [last, y[ball]];
  }
  return found.slice(1);
}

describe.each(['f32', 'f64'] as const)('a ball that bounces on the floor, %s', (precision) => {
  test('each bounce reaches e² of the previous height', () => {
    const expected = [275.2, 176.1, 112.7, 72.1];
    // The sampled height may be off by half a frame: g/8 px.
    apexes(5, 0.8, { precision }).forEach((apex, n) => {
      expect(Math.abs(apex / expected[n] - 1)).toBeLessThan(0.005);
    });
  });

  test('comes to rest at the time of the geometric series and then does not move', () => {
    const world = floor(0.1, { precision });
    const ball = spawn(world, {
      position: { y: 450 },
      velocity: {},
      mass: 1,
      collider: { radius: 20, restitution: 0.8 },
    });
    const [{ y }, { y: v }] = [world.components.Position, world.components.Velocity];
    let frames = 0;
    for (; frames < 2000 && !(v[ball] === 0 && y[ball] === 20); frames++) step(world, 1);
    // The total time is t₁ (1 + e)/(1 - e) with t₁ = √(2 · 430/0.1), to half a per cent, 4.2 frames. The series ends
    // once a bounce fits into a frame, which omits at most 1/(1 - e) = 5 frames.
    expect(Math.abs(frames / (9 * Math.sqrt(8600)) - 1)).toBeLessThan(0.005);
    for (let i = 0; i < 100; i++) {
      step(world, 1);
      expect([y[ball], v[ball]]).toEqual([20, 0]);
    }
  });
});

test('an elastic bounce off a vertical wall at the time of impact leaves the speed bitwise equal', () => {
  const world = createPhysicsWorld({ walls: [boxWalls({ max: { x: 400 } })] });
  const ball = spawn(world, {
    position: { x: 100, y: 100 },
    velocity: { x: 200, y: 50 },
    mass: 1,
    collider: { radius: 15, restitution: 1 },
  });
  for (let i = 0; i < 90; i++) step(world, 1 / 60);
  const { Position, Velocity } = world.components;
  expect([Velocity.x[ball], Velocity.y[ball]]).toEqual([-200, 50]);
  // The ball touched the wall at t = 1.425 s at x = 385.
  expect(Position.x[ball]).toBeCloseTo(385 - 200 * (1.5 - 1.425), 9);
  expect(Position.y[ball]).toBeCloseTo(100 + 50 * 1.5, 9);
});

test('an inelastic bounce loses (1 - e²) of the energy of the normal motion', () => {
  const world = createPhysicsWorld({ walls: [boxWalls({ max: { x: 0 }, restitution: 0.8 })] });
  const ball = spawn(world, { position: { x: -30 }, velocity: { x: 200, y: 50 }, mass: 1, collider: 15 });
  const before = energy(world).kinetic;
  for (let i = 0; i < 30; i++) step(world, 1 / 60);
  const { x, y } = world.components.Velocity;
  expect(x[ball]).toBeCloseTo(-160, 10);
  expect(y[ball]).toBe(50);
  expect(before - energy(world).kinetic).toBeCloseTo(7200, 8);
});

describe('ten thousand elastic bounces', () => {
  const [g, height, dt] = [10, 1, 0.037];
  const bounces = (integrator: PhysicsWorldOptions['integrator'], watch: (energyByMass: number) => void) => {
    const world = floor(g, integrator === undefined ? {} : { integrator });
    const ball = spawn(world, {
      position: { y: 0.5 + height },
      velocity: {},
      mass: 1,
      collider: { radius: 0.5, restitution: 1 },
    });
    const [{ y }, { y: v }] = [world.components.Position, world.components.Velocity];
    let [count, last] = [0, 0];
    // One bounce takes 2 √(2 h/g) = 0.9 s, 24 steps.
    for (let steps = 0; count < 10_000 && steps < 300_000; steps++) {
      step(world, dt);
      if (v[ball] > last) count++;
      last = v[ball];
      watch(0.5 * v[ball] * v[ball] + g * (y[ball] - 0.5));
    }
    expect(count).toBe(10_000);
  };

  test('velocity Verlet conserves energy to rounding', () => {
    let worst = 0;
    bounces(undefined, (e) => {
      worst = Math.max(worst, Math.abs(e / (g * height) - 1));
    });
    // Each bounce rounds about 10 times; in the worst case the errors add up to 10⁴ · 10 · 2⁻⁵³ = 1.1e-11.
    expect(worst).toBeLessThan(2e-11);
  });

  test('semi-implicit Euler conserves it within the error of the scheme', () => {
    // The scheme conserves v²/2 + g y - g v dt/2 exactly (v upwards), so the energy error is at most g |v| dt/2.
    const maxError = 0.5 * g * dt * Math.sqrt(2 * g * height) * 1.1;
    let [smallest, largest] = [Infinity, 0];
    bounces(semiImplicitEuler, (e) => {
      smallest = Math.min(smallest, e);
      largest = Math.max(largest, e);
    });
    expect(largest).toBeLessThan(g * height + maxError);
    expect(smallest).toBeGreaterThan(g * height - 2 * maxError);
  });
});

describe('friction of a body that slides on the floor', () => {
  test.each([
    ['disc', 2, 0.5, 2 / 3],
    ['ball', 3, 0.4, 5 / 7],
  ] as const)('a %s ends up rolling at the expected fraction of its speed', (_, dimensions, factor, share) => {
    const world = floor(10, { dimensions });
    const [mass, radius] = [2, 0.3];
    const body = spawn(world, {
      position: { y: radius },
      velocity: { x: 7 },
      mass,
      inertia: factor * mass * radius * radius,
      angularVelocity: {},
      collider: { radius, friction: 0.2 },
    });
    const [v, w] = [world.components.Velocity, world.components.AngularVelocity];
    // Sliding friction decelerates the body by μ g.
    step(world, 0.01);
    expect(v.x[body]).toBeCloseTo(7 - 0.2 * 10 * 0.01, 10);
    for (let i = 0; i < 1000; i++) step(world, 0.01);
    expect(v.x[body]).toBeCloseTo(7 * share, 10);
    expect(w.z[body] * radius).toBeCloseTo(-7 * share, 10);
  });

  test.each([{}, { inertia: 0, angularVelocity: {} }, { inertia: 1 }])(
    'a body that cannot rotate slides to rest: %o',
    (parts) => {
      const world = floor(10);
      const body = spawn(world, {
        position: { y: 0.3 },
        velocity: { x: 1 },
        mass: 1,
        collider: { radius: 0.3, friction: 0.5 },
        ...parts,
      });
      for (let i = 0; i < 100; i++) step(world, 0.01);
      expect(world.components.Velocity.x[body]).toBe(0);
      expect(world.components.AngularVelocity.z[body]).toBe(0);
      // The stopping distance is v²/(2 μ g).
      expect(world.components.Position.x[body]).toBeCloseTo(0.1, 2);
    },
  );

  test('the friction coefficient is the geometric mean of wall and body', () => {
    const world = createPhysicsWorld({
      forces: [uniformGravity({ y: -10 })],
      walls: [boxWalls({ min: { y: 0 }, friction: 0.4 })],
    });
    const body = spawn(world, {
      position: { y: 0.3 },
      velocity: { x: 9 },
      mass: 1,
      collider: { radius: 0.3, friction: 0.1 },
    });
    step(world, 0.01);
    expect(world.components.Velocity.x[body]).toBeCloseTo(9 - 0.2 * 10 * 0.01, 10);
  });
});

describe('edge cases within a step', () => {
  test.each(['f32', 'f64'] as const)(
    'a body that crosses the box many times in a step stays inside, %s',
    (precision) => {
      const world = createPhysicsWorld({
        precision,
        walls: [boxWalls({ min: { x: 0, y: 0 }, max: { x: 1, y: 1 }, restitution: 1 })],
      });
      const body = spawn(world, { position: { x: 0.5, y: 0.5 }, velocity: { x: 1e4, y: 731 }, mass: 1, collider: 0.1 });
      const [{ x, y }, v] = [world.components.Position, world.components.Velocity];
      for (let i = 0; i < 1000; i++) {
        step(world, 1 / 60);
        for (const at of [x[body], y[body]]) expect(at >= 0.0999 && at <= 0.9001).toBe(true);
      }
      expect(Math.abs(v.x[body])).toBe(1e4);
      expect(Math.abs(v.y[body])).toBe(731);
    },
  );

  test('a body wider than the box is held in the middle', () => {
    const world = createPhysicsWorld({ walls: [boxWalls({ min: { x: 0 }, max: { x: 1 } })] });
    const body = spawn(world, { position: { x: 0.2 }, velocity: { x: 3, y: 1 }, mass: 1, collider: 2 });
    for (let i = 0; i < 3; i++) step(world, 0.1);
    expect(world.components.Position.x[body]).toBe(0.5);
    expect(world.components.Velocity.x[body]).toBe(0);
    expect(world.components.Velocity.y[body]).toBe(1);
  });

  test('a body placed far beyond a wall returns at no more than its initial speed', () => {
    const world = floor(10);
    const body = spawn(world, {
      position: { y: -1000 },
      velocity: { y: -1 },
      mass: 1,
      collider: { radius: 0.5, restitution: 1 },
    });
    step(world, 0.01);
    expect(world.components.Position.y[body]).toBeGreaterThanOrEqual(0.5);
    expect(Math.abs(world.components.Velocity.y[body])).toBeLessThanOrEqual(1.1);
  });
});

test.each(Object.entries({ standard, particleContacts, rigidBodies }))(
  'with the preset %s another box takes the place of the first, wherever that stands, and other walls stay',
  (name, preset) => {
    const world = floor(10, { preset });
    spawn(world, { segmentWall: { ax: 4, ay: 3, bx: 6, by: 3 } });
    const ball = spawn(world, { position: { y: 1 }, mass: 1, collider: 0.2 });
    const shelf = spawn(world, { position: { x: 5, y: 4 }, mass: 1, collider: 0.2 });
    const { y } = world.components.Position;
    const run = () => {
      for (let i = 0; i < 150; i++) step(world, 1 / 60);
    };
    // Contacts of rigid bodies leave an overlap of 5 mm.
    run();
    expect(Math.abs(y[ball] - 0.2)).toBeLessThan(0.006);
    const count = world.phases.walls.length;
    replaceBoxWalls(world, { min: { y: -2 } });
    expect(world.phases.walls.length).toBe(count);
    run();
    expect(Math.abs(y[ball] + 1.8)).toBeLessThan(0.006);
    if (name !== 'standard') expect(Math.abs(y[shelf] - 3.2)).toBeLessThan(0.006);
  },
);

test('a world without a box gets one', () => {
  const world = createPhysicsWorld({ capacity: 10 });
  replaceBoxWalls(world, { min: { y: 0 } });
  expect(world.phases.walls.map(({ name }) => name)).toEqual(['box walls']);
  expect(() => replaceBoxWalls(world, { min: { y: 1 }, max: { y: 0 } })).toThrow(/E_RANGE/);
});
