// Elastic impacts under forces that depend on position or velocity keep the energy.
import { describe, expect, test } from 'vitest';
import { steps } from '../../../../test/support/worlds.ts';
import {
  boris,
  createPhysicsWorld,
  createRandom,
  defineLaw,
  energy,
  type Force,
  gaussRadau,
  type Integrator,
  magneticField,
  type PhysicsWorld,
  particleContacts,
  powerLaw,
  rungeKutta4,
  spawn,
  vectorOverTime,
  velocityVerlet,
} from '../index.ts';

const FIELD = { z: 2 };

function worldOf(integrator: Integrator, forces: readonly Force[], dimensions: 2 | 3 = 2): PhysicsWorld {
  return createPhysicsWorld({
    preset: particleContacts,
    precision: 'f64',
    dimensions,
    integrator,
    forces: [...forces],
  });
}

/** A lattice of 49 elastic discs with random velocities. */
function addGas(world: PhysicsWorld, spacing: number, radius: number, speed: number): void {
  const random = createRandom(3);
  for (let i = 0; i < 49; i++) {
    spawn(world, {
      position: { x: spacing * ((i % 7) - 3), y: spacing * (Math.floor(i / 7) - 3) },
      velocity: { x: random.uniform(-speed, speed), y: random.uniform(-speed, speed) },
      mass: 1,
      charge: 1,
      collider: { radius, restitution: 1 },
    });
  }
}

/** Relative change of the kinetic energy in 20 s. */
function changeOfEnergy(world: PhysicsWorld, dt: number): number {
  const before = energy(world).kinetic;
  steps(world, Math.round(20 / dt), dt);
  return energy(world).kinetic / before - 1;
}

const PLANES = [
  { nx: 0, ny: 1 },
  { nx: 0, ny: -1 },
  { nx: 1, ny: 0 },
  { nx: -1, ny: 0 },
];
const CORNERS = [
  [-4, -4],
  [4, -4],
  [4, 4],
  [-4, 4],
];
const ROOMS = {
  'no walls': () => {},
  planes: (world: PhysicsWorld) => {
    for (const normal of PLANES) spawn(world, { planeWall: { ...normal, offset: -4, restitution: 1 } });
  },
  segments: (world: PhysicsWorld) => {
    for (let i = 0; i < 4; i++) {
      const [[ax, ay], [bx, by]] = [CORNERS[i], CORNERS[(i + 1) % 4]];
      spawn(world, { segmentWall: { ax, ay, bx, by, restitution: 1 } });
    }
  },
};

// A magnetic field and an elastic impact keep the speed. Boris' rotation does so to rounding; Runge-Kutta 4 loses
// (Ω dt)⁶/72 a step, 10⁻⁹ in all, and velocity Verlet gains up to (Ω dt)⁴/4 a step, 8·10⁻⁵.
describe.each(Object.entries(ROOMS))('a magnetised gas keeps its energy: %s', (_, addWalls) => {
  test.each([
    ['Boris', boris({ field: FIELD }), [], 1e-11],
    ['Runge-Kutta 4', rungeKutta4, [magneticField(FIELD)], 1e-8],
    ['velocity Verlet', velocityVerlet, [magneticField(FIELD)], 2e-4],
    ['Gauss-Radau', gaussRadau(), [magneticField(FIELD)], 1e-8],
  ] as const)('%s', (_, integrator, forces, tolerance) => {
    const world = worldOf(integrator, forces);
    addWalls(world);
    addGas(world, 1, 0.3, 3);
    expect(Math.abs(changeOfEnergy(world, 0.005))).toBeLessThan(tolerance);
  });
});

test('balls under a field keep their energy in three dimensions', () => {
  const world = worldOf(boris({ field: { x: 1, y: -1, z: 2 } }), [], 3);
  for (const ny of [1, -1]) spawn(world, { planeWall: { nx: 0, ny, offset: -4, restitution: 1 } });
  addGas(world, 1, 0.3, 3);
  expect(Math.abs(changeOfEnergy(world, 0.005))).toBeLessThan(1e-11);
});

// The charge meets the wall each time at the same angle, so an error of first order would add up.
test.each(['planes', 'segments'] as const)('a charge that skips along %s keeps its speed and its way', (walls) => {
  const paths = [0.02, 0.0025].map((dt) => {
    const world = worldOf(boris({ field: FIELD }), []);
    if (walls === 'planes') spawn(world, { planeWall: { nx: 0, ny: 1, offset: 0, restitution: 1 } });
    else spawn(world, { segmentWall: { ax: -100, ay: 0, bx: 100, by: 0, restitution: 1 } });
    const charge = spawn(world, {
      position: { y: 0.6 },
      velocity: { x: 3, y: 0.4 },
      mass: 1,
      charge: 1,
      collider: { radius: 0.3, restitution: 1 },
    });
    expect(Math.abs(changeOfEnergy(world, dt))).toBeLessThan(1e-12);
    return world.components.Position.x[charge];
  });
  // Boris turns too slowly by (Ω dt)²/12 of the angle, 1/7500: in 40 radians of 1.5 m that is 8 mm.
  expect(Math.abs(paths[0] - paths[1])).toBeLessThan(0.02);
});

// Impacts do not change the potential energy. Verlet's energy wavers by (ω dt)²/8 = 10⁻⁵ of that of a body, in all less.
describe('discs in a harmonic trap keep their energy', () => {
  const K = 4;
  test.each([
    ['velocity Verlet', velocityVerlet],
    ['Runge-Kutta 4', rungeKutta4],
    ['Gauss-Radau', gaussRadau()],
  ] as const)('%s', (_, integrator) => {
    const world = worldOf(integrator, [powerLaw({ strength: -K, exponent: 1 })]);
    addGas(world, 0.7, 0.2, 1.5);
    const before = energy(world).total;
    steps(world, 4000, 0.005);
    expect(Math.abs(energy(world).total / before - 1)).toBeLessThan(1e-4);
  });
});

// One impact of each kind, under a force that changes with position and time. With a quarter of the step
// an error of second order in the impact would be a sixteenth; Runge-Kutta 4 leaves a 256th.
test.each(['plane', 'segment', 'disc'] as const)('a hit on a %s keeps the order of the integrator', (target) => {
  const drive = defineLaw({
    name: 'drive',
    parameters: { u: vectorOverTime('N') },
    force: ({ position }, { u }) => position.mul(-4).add(u),
  });
  const end = (count: number) => {
    const world = worldOf(rungeKutta4, [drive({ u: (t) => ({ x: 3 * Math.sin(10 * t) }) })]);
    if (target === 'plane') spawn(world, { planeWall: { nx: -1, ny: 0, offset: -0.5, restitution: 1 } });
    if (target === 'segment') spawn(world, { segmentWall: { ax: 0.5, ay: -5, bx: 0.5, by: 5, restitution: 1 } });
    const collider = { radius: 0.2, restitution: 1 };
    const body = spawn(world, { position: { x: -0.5 }, velocity: { x: 1 }, mass: 1, collider });
    if (target === 'disc') spawn(world, { position: { x: 0.6, y: 0.1 }, velocity: {}, mass: 2, collider });
    steps(world, count, 0.8 / count);
    return world.components.Position.x[body];
  };
  const exact = end(16_384);
  const [coarse, fine] = [32, 128].map((count) => Math.abs(end(count) - exact));
  expect(coarse).toBeLessThan(1e-4);
  expect(fine).toBeLessThan(coarse / 100);
});
