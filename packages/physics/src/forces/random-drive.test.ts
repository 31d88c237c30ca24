import { expect, test } from 'vitest';
import {
  createPhysicsWorld,
  linearDrag,
  randomDrive,
  semiImplicitEuler,
  spawnMany,
  step,
  velocityVerlet,
} from '../index.ts';

const BODIES = 20_000;

// v' = a v + b N(0, 1) has the variance b²/(1 - a²). With x = c dt/m and S = 2 c k T the step of semi-implicit Euler has
// a = 1 - x, b² = 2 x k T/m, and that of velocity Verlet a = 1 - x + x²/2, b² = 2 x (1 - x/2)² k T/m.
test.each([
  ['velocity Verlet', velocityVerlet, 0.1, (0.2 * 0.95 ** 2) / (1 - 0.905 ** 2)],
  ['velocity Verlet', velocityVerlet, 0.8, (1.6 * 0.6 ** 2) / (1 - 0.52 ** 2)],
  ['semi-implicit Euler', semiImplicitEuler, 0.1, 1 / 0.95],
  ['semi-implicit Euler', semiImplicitEuler, 0.8, 1 / 0.6],
] as const)(
  'under %s with c dt/m = %3$f the temperature is what the length of the step makes it',
  (_, integrator, x, expected) => {
    const forces = [linearDrag(), randomDrive({ spectralDensity: 2 })];
    const world = createPhysicsWorld({ capacity: BODIES + 1, integrator, forces, seed: 3 });
    spawnMany(world, BODIES, { position: {}, velocity: {}, mass: 1, linearDrag: 1 });
    for (let i = 0; i < 6 / x; i++) step(world, x);
    const { x: vx, y: vy } = world.components.Velocity;
    let squares = 0;
    for (let id = 1; id <= BODIES; id++) squares += vx[id] ** 2 + vy[id] ** 2;
    // The mean of 40 000 squares has a standard deviation of √(2/40 000) = 0.7 %; what is left of the start is e⁻¹².
    expect(Math.abs(squares / (2 * BODIES) / expected - 1)).toBeLessThan(4 * Math.sqrt(2 / (2 * BODIES)));
  },
);
