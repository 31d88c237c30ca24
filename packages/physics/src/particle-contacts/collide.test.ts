import { describe, expect, test } from 'vitest';
import {
  angularMomentum,
  ballInertia,
  boxWalls,
  contacts,
  createPhysicsWorld,
  createRandom,
  discInertia,
  energy,
  momentum,
  type PhysicsWorld,
  type PhysicsWorldOptions,
  particleContacts,
  spawn,
  stateHash,
  step,
  uniformGravity,
} from '../index.ts';

const make = (options: PhysicsWorldOptions = {}) =>
  createPhysicsWorld({ preset: particleContacts, capacity: 200, ...options });

function body(
  world: PhysicsWorld,
  [x, y, z = 0]: readonly number[],
  [vx, vy, vz = 0]: readonly number[],
  mass: number,
  radius: number,
  restitution = 1,
): number {
  return spawn(world, {
    position: { x, y, z },
    velocity: { x: vx, y: vy, z: vz },
    mass,
    collider: { radius, restitution },
  });
}

const run = (world: PhysicsWorld, steps: number, dt = 1 / 60) => {
  for (let i = 0; i < steps; i++) step(world, dt);
};

describe('two balls on a line, 1 kg at 250 and 125 kg at 50 m/s', () => {
  const meet = (restitution: number, precision: 'f32' | 'f64' = 'f64') => {
    const world = make({ precision });
    const small = body(world, [0, 200], [250, 0], 1, 15, restitution);
    const large = body(world, [300, 200], [50, 0], 125, 75, restitution);
    run(world, 90);
    return { world, small, large, v: world.components.Velocity.x, x: world.components.Position.x };
  };

  test('elastic: -146.8254 and 53.1746, touched at 1.05 s', () => {
    const { world, small, large, v, x } = meet(1);
    expect(Math.abs(v[small] / (-9250 / 63) - 1)).toBeLessThan(1e-12);
    expect(Math.abs(v[large] / (3350 / 63) - 1)).toBeLessThan(1e-12);
    expect(Math.abs(momentum(world).x / 6500 - 1)).toBeLessThan(1e-12);
    expect(Math.abs(energy(world).kinetic / 187_500 - 1)).toBeLessThan(1e-12);
    expect(x[small]).toBeCloseTo(262.5 - 0.45 * (9250 / 63), 8);
    expect(x[large]).toBeCloseTo(352.5 + 0.45 * (3350 / 63), 8);
  });

  test('in f32 equal to seven digits', () => {
    const { small, large, v } = meet(1, 'f32');
    expect(v[small]).toBeCloseTo(-9250 / 63, 3);
    expect(v[large]).toBeCloseTo(3350 / 63, 3);
  });

  test.each([0, 0.5])('with restitution %d', (e) => {
    const { world, small, large, v, x } = meet(e);
    expect(momentum(world).x).toBeCloseTo(6500, 9);
    expect(v[large] - v[small]).toBeCloseTo(200 * e, 9);
    const loss = 0.5 * (125 / 126) * (1 - e * e) * 200 * 200;
    expect(187_500 - energy(world).kinetic).toBeCloseTo(loss, 7);
    // After 1.05 s they separate; position correction must not have displaced them.
    expect(x[large] - x[small]).toBeCloseTo(90 + 0.45 * 200 * e, 8);
  });

  test('equal masses exchange velocities', () => {
    const world = make();
    const a = body(world, [0, 0], [3, 0], 2, 1);
    const b = body(world, [5, 0], [-1, 0], 2, 1);
    run(world, 90);
    expect([world.components.Velocity.x[a], world.components.Velocity.x[b]]).toEqual([-1, 3]);
  });
});

describe.each([
  [2, 'f32'],
  [2, 'f64'],
  [3, 'f32'],
  [3, 'f64'],
] as const)('two bodies in %d D, %s', (dimensions, precision) => {
  const small = precision === 'f64' ? 1e-12 : 1e-5;

  test('a glancing collision of equal masses separates at right angles', () => {
    const world = make({ dimensions, precision });
    const z = dimensions === 3 ? 0.4 : 0;
    const a = body(world, [-4, 0.9, z], [7, 0], 2, 1);
    const b = body(world, [0, 0], [0, 0], 2, 1);
    run(world, 90);
    const { x, y, z: w } = world.components.Velocity;
    expect(Math.abs(x[a] * x[b] + y[a] * y[b] + w[a] * w[b]) / 49).toBeLessThan(10 * small);
    expect(Math.abs(y[b])).toBeGreaterThan(1);
  });

  test('a pair with spin and friction conserves momentum and angular momentum, and friction only dissipates energy', () => {
    const world = make({ dimensions, precision });
    const inertia = dimensions === 2 ? discInertia : ballInertia;
    const spinning = (x: number, y: number, mass: number, radius: number, v: number, spin: number) =>
      spawn(world, {
        position: { x, y, ...(dimensions === 3 ? { z: 0.2 * x } : {}) },
        velocity: { x: v },
        mass,
        inertia: inertia(mass, radius),
        angularVelocity: { z: spin, ...(dimensions === 3 ? { x: 2, y: -spin } : {}) },
        collider: { radius, restitution: 0.8, friction: 0.6 },
      });
    spinning(-3, 0.4, 1, 1, 9, 5);
    spinning(3, -0.3, 30, 1.5, -2, -3);
    const [p, l, e] = [momentum(world), angularMomentum(world), energy(world).kinetic];
    run(world, 60);
    expect(energy(world).kinetic).toBeLessThan(0.97 * e);
    const [q, m] = [momentum(world), angularMomentum(world)];
    const scale = 30 * 9;
    for (const axis of ['x', 'y', 'z'] as const) {
      expect(Math.abs(q[axis] - p[axis]) / scale).toBeLessThan(small);
      // In f32 the torque is computed from differences of positions.
      expect(Math.abs(m[axis] - l[axis]) / scale).toBeLessThan(10 * small);
    }
  });

  test('a body without mass is immovable', () => {
    const world = make({ dimensions, precision });
    const post = spawn(world, { position: { x: 5 }, collider: { radius: 1, restitution: 0.5 } });
    const ball = body(world, [0, 0], [10, 0], 3, 1, 0);
    run(world, 60);
    expect(world.components.Position.x[post]).toBe(5);
    expect(world.components.Velocity.x[ball]).toBeCloseTo(-5, 4);
  });

  test('two falling balls bounce as in free space, and total energy is conserved', () => {
    const world = make({ dimensions, precision, forces: [uniformGravity({ y: -10 })] });
    const a = body(world, [-2, 0], [3, 5], 1, 0.5);
    const b = body(world, [2, 0.3], [-3, 5], 4, 0.5);
    const before = energy(world).total;
    run(world, 60);
    expect(world.components.Velocity.x[a]).toBeLessThan(-1);
    expect(world.components.Velocity.x[b]).toBeGreaterThan(-3);
    expect(Math.abs(energy(world).total / before - 1)).toBeLessThan(100 * small);
  });

  test('coincident bodies separate deterministically', () => {
    const places = () => {
      const world = make({ dimensions, precision });
      const ids = Array.from({ length: 8 }, () => body(world, [1, 2], [0, 0], 1, 0.5, 0));
      run(world, 300);
      const { x, y, z } = world.components.Position;
      for (const i of ids)
        for (const j of ids) if (i < j) expect(Math.hypot(x[i] - x[j], y[i] - y[j], z[i] - z[j])).toBeGreaterThan(0.97);
      expect(energy(world).kinetic).toBe(0);
      return stateHash(world);
    };
    expect(places()).toBe(places());
  });
});

test('a thousand bounces on a post under gravity conserve energy', () => {
  const world = make({ forces: [uniformGravity({ y: -10 })] });
  spawn(world, { position: {}, collider: { radius: 1 } });
  const ball = body(world, [0, 2.5], [0, 0], 1, 0.5);
  const [{ y }, { y: v }] = [world.components.Position, world.components.Velocity];
  let [count, last, worst] = [0, 0, 0];
  while (count < 1000) {
    step(world, 0.03);
    if (v[ball] > last) count++;
    last = v[ball];
    worst = Math.max(worst, Math.abs((0.5 * last * last + 10 * (y[ball] - 1.5)) / 10 - 1));
  }
  // Three Newton iterations and some roundings per bounce.
  expect(worst).toBeLessThan(1e-10);
});

describe('many balls that meet at one point', () => {
  const meet = (order: 1 | -1) => {
    const world = make();
    const random = createRandom(11);
    const places = Array.from({ length: 9 }, () => [random.uniform(0, 800), random.uniform(0, 600)]);
    const order9 = places.map((_, i) => (order === 1 ? i : 8 - i));
    const ids: number[] = [];
    for (const i of order9) {
      const [x, y] = places[i];
      ids[i] = body(world, [x, y], [0.2 * (400 - x), 0.2 * (300 - y)], 1, 15);
    }
    return { world, ids };
  };

  test('momentum and energy are constant to 1e-10 for the whole run', () => {
    const { world } = meet(1);
    const [p, e] = [momentum(world), energy(world).kinetic];
    let met = 0;
    for (let i = 0; i < 600; i++) {
      step(world, 1 / 60);
      met += contacts(world).count;
      expect(Math.abs(energy(world).kinetic / e - 1)).toBeLessThan(1e-10);
      expect(Math.abs(momentum(world).x - p.x)).toBeLessThan(1e-10);
      expect(Math.abs(momentum(world).y - p.y)).toBeLessThan(1e-10);
    }
    expect(met).toBeGreaterThan(8);
  });

  test('the result does not depend on the order of creation', () => {
    const [one, other] = [meet(1), meet(-1)];
    run(one.world, 600);
    run(other.world, 600);
    let [speed, difference] = [0, 0];
    for (let i = 0; i < 9; i++) {
      const [v, w] = [one.world.components.Velocity, other.world.components.Velocity];
      const [a, b] = [one.ids[i], other.ids[i]];
      speed += Math.hypot(v.x[a], v.y[a]) / 9;
      difference = Math.max(difference, Math.hypot(v.x[a] - w.x[b], v.y[a] - w.y[b]));
    }
    expect(difference).toBeLessThan(0.01 * speed);
  });
});

describe('a gas of molecules in a box', () => {
  const gas = (count: number, dimensions: 2 | 3, precision: 'f32' | 'f64', side: number) => {
    const world = make({
      dimensions,
      precision,
      walls: [boxWalls({ min: { x: 0, y: 0, z: 0 }, max: { x: side, y: side, z: side }, restitution: 1 })],
    });
    const random = createRandom(2);
    const across = Math.ceil(Math.sqrt(count));
    for (let i = 0; i < count; i++) {
      const radius = random.uniform(5, 25);
      const cell = side / across;
      const place = [
        ((i % across) + 0.5) * cell,
        (Math.floor(i / across) + 0.5) * cell,
        dimensions === 3 ? side / 2 : 0,
      ];
      const v = [random.uniform(-50, 50), random.uniform(-50, 50), dimensions === 3 ? random.uniform(-50, 50) : 0];
      body(world, place, v, 0.01 * radius ** 3, radius);
    }
    return world;
  };

  test.each([2, 3] as const)('kinetic energy is constant to 1e-9 over ten minutes, %d D', (dimensions) => {
    const world = gas(16, dimensions, 'f64', dimensions === 2 ? 400 : 150);
    const before = energy(world).kinetic;
    let met = 0;
    for (let i = 0; i < 36_000; i++) {
      step(world, 1 / 60);
      met += contacts(world).count;
    }
    expect(Math.abs(energy(world).kinetic / before - 1)).toBeLessThan(1e-9);
    expect(met).toBeGreaterThan(1000);
  });

  test('ten balls of radius 5 to 25 at 50 a second overlap by less than a pixel', () => {
    const world = gas(10, 2, 'f64', 600);
    const [p, { radius }] = [world.components.Position, world.components.Collider];
    let worst = 0;
    for (let i = 0; i < 36_000; i++) {
      step(world, 1 / 60);
      for (let a = 1; a < 10; a++) {
        for (let b = a + 1; b <= 10; b++) {
          worst = Math.max(worst, radius[a] + radius[b] - Math.hypot(p.x[a] - p.x[b], p.y[a] - p.y[b]));
        }
      }
    }
    expect(worst).toBeLessThan(1);
  });

  test('in f32 the energy is constant to the rounding of a thousand collisions', () => {
    const world = gas(16, 2, 'f32', 400);
    const before = energy(world).kinetic;
    run(world, 2000);
    expect(Math.abs(energy(world).kinetic / before - 1)).toBeLessThan(1e-4);
  });

  test('heavy and light bodies reach equal mean energy', () => {
    const world = gas(64, 2, 'f64', 700);
    const { mass, vx, vy } = {
      mass: world.components.Mass.value,
      vx: world.components.Velocity.x,
      vy: world.components.Velocity.y,
    };
    const ids = Array.from({ length: 64 }, (_, i) => i + 1).sort((i, j) => mass[i] - mass[j]);
    const mean = (list: number[]) =>
      list.reduce((sum, i) => sum + 0.5 * mass[i] * (vx[i] ** 2 + vy[i] ** 2), 0) / list.length;
    // The initial speeds are equal, so the heavy half has most of the energy.
    expect(mean(ids.slice(32)) / mean(ids.slice(0, 32))).toBeGreaterThan(3);
    run(world, 3000);
    let [light, heavy] = [0, 0];
    for (let i = 0; i < 12_000; i++) {
      step(world, 1 / 60);
      light += mean(ids.slice(0, 32));
      heavy += mean(ids.slice(32));
    }
    expect(Math.abs(heavy / light - 1)).toBeLessThan(0.1);
  });
});

test('restitution above one gains energy only as specified, and stays finite', () => {
  const world = make({ walls: [boxWalls({ min: { x: 0 }, max: { x: 3 } })] });
  const a = body(world, [0.5, 0], [1, 0], 1, 0.2, 10);
  const b = body(world, [2, 0], [0, 0], 1, 0.2, 10);
  run(world, 70);
  expect(world.components.Velocity.x[b] - world.components.Velocity.x[a]).toBeCloseTo(10, 9);
  run(world, 2000);
  for (const v of [world.components.Velocity.x[a], world.components.Velocity.x[b]])
    expect(Math.abs(v)).toBeLessThanOrEqual(299_792_458);
});

test('equal runs are bitwise equal, with friction, spin, gravity and walls', () => {
  const result = (precision: 'f32' | 'f64') => {
    const world = make({
      precision,
      forces: [uniformGravity({ y: -10 })],
      walls: [boxWalls({ min: { x: 0, y: 0 }, max: { x: 6 } })],
    });
    const random = createRandom(4);
    for (let i = 0; i < 80; i++) {
      spawn(world, {
        position: { x: random.uniform(0.5, 5.5), y: 0.3 + 0.2 * i },
        velocity: { x: random.uniform(-1, 1) },
        mass: random.uniform(0.5, 2),
        inertia: 0.02,
        angularVelocity: random.uniform(-5, 5),
        collider: { radius: random.uniform(0.1, 0.3), restitution: 0.4, friction: 0.4 },
      });
    }
    run(world, 300);
    return stateHash(world);
  };
  expect(result('f32')).toBe(result('f32'));
  expect(result('f64')).toBe(result('f64'));
});
