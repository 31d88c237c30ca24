import { describe, expect, it, test } from 'vitest';
import {
  createPhysicsWorld,
  explicitEuler,
  heun,
  type Integrator,
  implicitEuler,
  lift,
  magneticField,
  magnus,
  midpoint,
  mutualGravity,
  positionFirstEuler,
  positionVerlet,
  rigidBodies,
  rungeKutta4,
  semiImplicitEuler,
  spawn,
  step,
  velocityVerlet,
  wisdomHolman,
} from '../index.ts';
import { growthRate } from './gyration-growth.ts';

const DT = 1 / 64;

/** Slow enough to stay below the speed at which bodies are stopped, m/s. */
const SPEED = 1e-6;

/** A charge that the field turns by `theta` a step, its growth in the last half of the steps, 1/s, and what its world says. */
function turned(integrator: Integrator, theta: number, steps: number) {
  const isOrbits = integrator.name === 'Wisdom-Holman';
  const world = createPhysicsWorld({
    integrator,
    precision: 'f64',
    capacity: 4,
    forces: [magneticField({ z: theta / DT }), ...(isOrbits ? [mutualGravity()] : [])],
  });
  const messages: string[] = [];
  world.onWarning = ({ message }) => messages.push(message);
  // So far from the star an orbit is a straight line.
  if (isOrbits) spawn(world, { position: { x: -1e3 }, mass: 1, velocity: {} });
  const id = spawn(world, { position: {}, velocity: { x: SPEED }, mass: 1e-9, charge: 1e-9 });
  const { x, y } = world.components.Velocity;
  for (let i = 0; i < steps / 2; i++) step(world, DT);
  const before = Math.hypot(x[id], y[id]);
  for (let i = 0; i < steps / 2; i++) step(world, DT);
  return { messages, growth: Math.log(Math.hypot(x[id], y[id]) / before) / ((steps / 2) * DT) };
}

const INTEGRATORS: Integrator[] = [
  explicitEuler,
  semiImplicitEuler,
  positionFirstEuler,
  wisdomHolman(),
  velocityVerlet,
  midpoint,
  heun,
  rungeKutta4,
  positionVerlet,
  implicitEuler(),
];

describe.each(INTEGRATORS)('the speed of a charge under $name', (integrator) => {
  it.each([0.3, 1, 2])('changes by the rate that is told, at %d rad a step', (theta) => {
    const rate = growthRate(integrator, theta / DT, DT) as number;
    // Position Verlet begins otherwise, which its shorter root forgets in the first half of the steps.
    const { growth } = turned(integrator, theta, 24);
    expect(growth / rate).toBeCloseTo(1, 4);
  });

  it('is warned of at 1 rad a step, and not where it changes by less than 1 % a minute', () => {
    const { messages, growth } = turned(integrator, 1, 2);
    expect(messages).toEqual([
      expect.stringMatching(
        growth < 0
          ? /^charges in the magnetic field lose .* of their speed .*, because the integrator is/
          : /^charges in the magnetic field double their speed every 0.[0-9]+ s, because the integrator is/,
      ),
    ]);
    expect(turned(integrator, 1e-3, 2).messages).toEqual([]);
  });
});

test('the default integrator tells by how much', () => {
  // (1 + 1/4)^(1/2) a step: twice as much in ln 2/(ln(5/4)/2) = 6.2 steps of 1/64 s.
  expect(turned(velocityVerlet, 1, 2).messages).toEqual([
    'charges in the magnetic field double their speed every 0.097 s, because the integrator is velocity Verlet.',
  ]);
  // 1 - 1/72 + 1/576 = 0.98785 of the square a step: 1 - e^-0.39 a second.
  expect(turned(rungeKutta4, 1, 2).messages).toEqual([
    'charges in the magnetic field lose 39 % of their speed a second, because the integrator is Runge-Kutta 4.',
  ]);
});

test.each([
  ['lift', lift(), { lift: 4 }],
  ['Magnus force', magnus({ density: 1 }), { angularVelocity: 1e3, inertia: 1, rotation: 0, collider: 0.2 }],
] as const)('%s is warned of in a world of the default integrator', (name, force, more) => {
  const world = createPhysicsWorld({ forces: [force] });
  const messages: string[] = [];
  world.onWarning = ({ message, hint }) => messages.push(`${message} ${hint}`);
  spawn(world, { position: {}, velocity: { x: 10 }, mass: 1, ...more });
  step(world, 1 / 60);
  expect(messages).toEqual([
    expect.stringMatching(
      `^"${name}" (doubles the speed of body 1 every|makes body 1 faster by) .*, though it does no work, because the integrator is velocity Verlet. Take rungeKutta4, or shorter steps.$`,
    ),
  ]);
});

test('rigid bodies have the rate of their sub-steps', () => {
  const world = createPhysicsWorld({ preset: rigidBodies });
  const h = DT / world.integrator.evaluations;
  expect(growthRate(world.integrator, 2, DT)).toBeCloseTo(Math.log1p((2 * h) ** 2) / 2 / h, 12);
});
