// Impacts on the walls of a box under forces that depend on position or velocity.
import { describe, expect, test } from 'vitest';
import { steps } from '../../../../test/support/worlds.ts';
import {
  boris,
  boxWalls,
  createPhysicsWorld,
  defineLaw,
  energy,
  type Integrator,
  linearDrag,
  magneticField,
  particleContacts,
  powerLaw,
  quadraticDrag,
  rungeKutta4,
  spawn,
  standard,
  uniformGravity,
  vec3,
  vectorOverTime,
  velocityVerlet,
  yoshida4,
} from '../index.ts';

const PRESETS = { standard, particleContacts };

/** Relative change of the speed of a charge that skips along an elastic wall for 1000 s, in which it hits it about 300 times. */
function speedOfSkippingCharge(preset: 'standard' | 'particleContacts', usesBoris: boolean, dt: number): number {
  const field = { z: 2 };
  const world = createPhysicsWorld({
    preset: PRESETS[preset],
    precision: 'f64',
    integrator: usesBoris ? boris({ field }) : rungeKutta4,
    forces: usesBoris ? [] : [magneticField(field)],
    walls: [boxWalls({ min: { y: 0 }, restitution: 1 })],
  });
  const charge = spawn(world, {
    position: { y: 0.3 },
    velocity: { x: 1, y: 1 },
    mass: 1,
    charge: 1,
    collider: { radius: 0.1, restitution: 1 },
  });
  steps(world, Math.round(1000 / dt), dt);
  const { x, y } = world.components.Velocity;
  return Math.hypot(x[charge], y[charge]) / Math.SQRT2 - 1;
}

describe('a charge at a wall in a magnetic field keeps its speed', () => {
  // A step turns the velocity by Ω dt = 1/30. Boris's rotation is exact in the speed, and what is left comes from the
  // correction of the time of impact, (Ω dt)³/12 v in each hit with either sign; Runge-Kutta 4 loses (Ω dt)⁶/72 a step
  // besides, 10⁻⁶ in 60 000 steps.
  test.each([
    ['standard', true],
    ['standard', false],
    ['particleContacts', true],
    ['particleContacts', false],
  ] as const)('%s, Boris: %s', (preset, usesBoris) => {
    expect(Math.abs(speedOfSkippingCharge(preset, usesBoris, 1 / 60))).toBeLessThan(1e-4);
  });
});

describe('an oscillator at an elastic wall keeps its energy', () => {
  // In 600 s it hits the wall about 300 times. An error of the fourth order is (ω dt)⁴ = 10⁻⁶ in each at most; one of the second
  // would be 10⁻³ in each, in sum far above.
  test.each([
    ['velocity Verlet', velocityVerlet, 5e-3],
    ['Runge-Kutta 4', rungeKutta4, 1e-4],
  ] as const)('%s', (_, integrator, tolerance) => {
    const world = createPhysicsWorld({
      precision: 'f64',
      integrator,
      forces: [powerLaw({ strength: -4, exponent: 1 })],
      walls: [boxWalls({ min: { y: -0.5 }, restitution: 1 })],
    });
    spawn(world, { position: { y: 1 }, velocity: {}, mass: 1, collider: { radius: 0.1, restitution: 1 } });
    const before = energy(world).total;
    let worst = 0;
    for (let i = 0; i < 36_000; i++) {
      steps(world, 1, 1 / 60);
      worst = Math.max(worst, Math.abs(energy(world).total / before - 1));
    }
    expect(worst).toBeLessThan(tolerance);
  });
});

describe('drag between two elastic walls', () => {
  /** Relative error of the speed after 2 s: v = v₀ e^(-t), whatever the walls do. */
  function errorOfSpeed(integrator: Integrator, stepsPerSecond: number): number {
    const world = createPhysicsWorld({
      precision: 'f64',
      integrator,
      forces: [linearDrag()],
      walls: [boxWalls({ min: { x: 0 }, max: { x: 1 }, restitution: 1 })],
    });
    const ball = spawn(world, {
      position: { x: 0.5 },
      velocity: { x: 5 },
      mass: 1,
      linearDrag: 1,
      collider: { radius: 0.1, restitution: 1 },
    });
    steps(world, 2 * stepsPerSecond, 1 / stepsPerSecond);
    return Math.abs(Math.abs(world.components.Velocity.x[ball]) / (5 * Math.exp(-2)) - 1);
  }

  test.each([
    ['velocity Verlet', velocityVerlet, 2],
    ['Runge-Kutta 4', rungeKutta4, 4],
  ] as const)('%s keeps its order', (_, integrator, order) => {
    const [coarse, fine] = [60, 120].map((n) => errorOfSpeed(integrator, n));
    // Half a step divides the error by 2^order, apart from where in its step each impact is.
    expect(coarse / fine).toBeGreaterThan(0.8 * 2 ** order);
  });
});

describe('a driven oscillator at an elastic wall', () => {
  const byTime = defineLaw({
    name: 'drive',
    force: ({ position, time }) => vec3(position.x.mul(-4).add(time.mul(10).sin().mul(3)), 0),
  });
  const byParameter = defineLaw({
    name: 'drive',
    parameters: { u: vectorOverTime('N') },
    force: ({ position }, { u }) => position.mul(-4).add(u),
  });
  const DRIVES = {
    'by the time': byTime(),
    'by a parameter': byParameter({ u: (t) => ({ x: 3 * Math.sin(10 * t) }) }),
  };
  /** x(1.2 s) by Runge-Kutta 4 with 600 000 steps, that of the one impact divided where it is by bisection. */
  const EXACT = 0.05370890842651994;

  function errorOf(drive: keyof typeof DRIVES, integrator: Integrator, count: number): number {
    const world = createPhysicsWorld({
      precision: 'f64',
      integrator,
      forces: [DRIVES[drive]],
      walls: [boxWalls({ min: { x: -0.35 }, restitution: 1 })],
    });
    const ball = spawn(world, { position: { x: 1 }, velocity: {}, mass: 1, collider: { radius: 0.1, restitution: 1 } });
    steps(world, count, 1.2 / count);
    return Math.abs(world.components.Position.x[ball] - EXACT);
  }

  // Where in its step the impact is changes the error by some factor; from 30 to 480 steps that matters little.
  test.each([
    ['by the time', 'velocity Verlet', velocityVerlet, 2],
    ['by the time', 'Runge-Kutta 4', rungeKutta4, 4],
    ['by the time', 'Yoshida 4', yoshida4, 4],
    ['by a parameter', 'Runge-Kutta 4', rungeKutta4, 4],
  ] as const)('%s, %s keeps its order', (drive, _, integrator, order) => {
    const [coarse, fine] = [30, 480].map((count) => errorOf(drive, integrator, count));
    expect(Math.log2(coarse / fine) / 4).toBeGreaterThan(order - 0.2);
  });
});

test('a force of the time alone keeps the order of Runge-Kutta 4 at a wall', () => {
  // x = 1 - 1.3 t - t²/2 + 0.3 t - 0.03 sin 10t falls below -0.25, and what follows depends on when.
  const drive = defineLaw({ name: 'drive', force: ({ time }) => vec3(time.mul(10).sin().mul(3).sub(1), 0) });
  const [coarse, middle, fine] = [60, 120, 960].map((count) => {
    const world = createPhysicsWorld({
      precision: 'f64',
      integrator: rungeKutta4,
      forces: [drive()],
      walls: [boxWalls({ min: { x: -0.35 }, restitution: 1 })],
    });
    const ball = spawn(world, {
      position: { x: 1 },
      velocity: { x: -1.3 },
      mass: 1,
      collider: { radius: 0.1, restitution: 1 },
    });
    steps(world, count, 1.2 / count);
    return world.components.Position.x[ball];
  });
  expect(Math.log2((coarse - fine) / (middle - fine))).toBeGreaterThan(3.5);
});

const RELIEF = defineLaw({
  name: 'relief',
  parameters: { lift: vectorOverTime('m/s²') },
  acceleration: ({ position }, { lift }) => lift.sub(position.mul(0.1)),
});

test.each([
  ['f32', 'constant'],
  ['f64', 'constant'],
  ['f32', 'changing'],
  ['f64', 'changing'],
] as const)('bodies that hit in one vector of rows do not disturb each other, %s, %s forces', (precision, kind) => {
  const changing = kind === 'constant' ? [] : [RELIEF({ lift: (t: number) => ({ y: 5 * Math.sin(9 * t) }) })];
  const make = (only?: number) => {
    const world = createPhysicsWorld({
      precision,
      forces: [uniformGravity(), quadraticDrag(), ...changing],
      walls: [boxWalls({ min: { x: 0, y: 0 }, max: { x: 20, y: 3 }, restitution: 0.8 })],
    });
    for (let i = 0; i < 20; i++) {
      const isThere = only === undefined || only === i;
      spawn(world, {
        position: { x: 0.5 + i * 0.95, y: 1 },
        velocity: { x: isThere ? 3 * Math.sin(i) : 0, y: isThere ? -9 + (i % 3) : 0 },
        ...(isThere && { mass: 1 + i }),
        quadraticDrag: 0.1,
        collider: 0.1,
      });
    }
    steps(world, 60);
    return world;
  };
  const all = make();
  for (const i of [0, 1, 7, 19]) {
    const alone = make(i);
    expect(alone.components.Position.y[i + 1]).toBe(all.components.Position.y[i + 1]);
    expect(alone.components.Velocity.x[i + 1]).toBe(all.components.Velocity.x[i + 1]);
  }
});

test('friction of a wall acts once', () => {
  // A ball that slides into a wall with friction loses μ (1 + e) v of its tangential speed, drag apart.
  const world = createPhysicsWorld({
    precision: 'f64',
    forces: [linearDrag()],
    walls: [boxWalls({ min: { y: 0 }, restitution: 1, friction: 0.1 })],
  });
  const ball = spawn(world, {
    position: { y: 0.15 },
    velocity: { x: 10, y: -5 },
    mass: 1,
    linearDrag: 1e-9,
    collider: { radius: 0.1, restitution: 1, friction: 0.1 },
  });
  steps(world, 1, 1 / 60);
  const { x, y } = world.components.Velocity;
  expect(y[ball]).toBeCloseTo(5, 7);
  expect(x[ball]).toBeCloseTo(10 - 0.1 * 2 * 5, 7);
});
