import {
  boxWalls,
  createPhysicsWorld,
  createRandom,
  energy,
  momentum,
  rgba,
  spawn,
  velocityVerlet,
} from '@principia/physics';
import { betweenAtoms, distancesOf } from '../../atoms.ts';
import type { SceneRun } from '../../scene.ts';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { lengthOf } from '../support/read.ts';
import { boxOf, linesOf } from '../support/walls.ts';

type Values = ValuesOf<'temperature' | 'rings'>;

const [HALF_X, HALF_Y] = [15, 10];

/**
 * Distance of neighbours in a crystal at rest, in diameters: (2 S₁₂/S₆)^(1/6), with the sums S of 1, √3 and 2 to the power −12 and
 * −6 over the six neighbours of each kind that are within the cutoff.
 */
const SPACING = 1.1132;

/** Neighbours are nearer than this: the next ones are at √3 times the spacing. */
const NEAR = 1.5;

interface CrystalRun extends SceneRun {
  readonly atoms: readonly number[];
  /** Kinetic energy of an atom in the mean, which is kT in the plane. */
  temperature(): number;
  readonly start: number;
}

/** Places in rings of six sides about the origin. */
function hexagon(rings: number): { x: number; y: number }[] {
  const places: { x: number; y: number }[] = [];
  for (let j = -rings; j <= rings; j++) {
    for (let i = -rings; i <= rings; i++) {
      if (Math.abs(i + j) > rings) continue;
      places.push({ x: SPACING * (i + j / 2), y: (SPACING * j * Math.sqrt(3)) / 2 });
    }
  }
  return places;
}

export default defineExample({
  id: 'ch17-melting-crystal',
  title: 'A crystal melts',
  chapter: 17,
  tags: ['molecules', 'crystal', 'temperature', 'energy', 'statistics'],
  about:
    'Atoms attract each other at a distance and repel each other when they come near: nothing else is in this picture. Cold, they sit in a crystal and tremble. Warmer, atoms change places and the corners grow round: a drop. Hot, they fly apart: a gas. The histogram of all distances tells which it is: a crystal has them in rows, a liquid in waves, a gas has nearly all alike.',
  duration: 20,
  parameters: {
    temperature: { label: 'Temperature at the start', initial: 0.2, min: 0, max: 6 },
    rings: { label: 'Rings of atoms', initial: 7, min: 1, max: 8, integer: true },
  },
  presets: [
    { label: 'Frozen', values: { temperature: 0 } },
    { label: 'A drop', values: { temperature: 1.2 } },
    { label: 'A gas', values: { temperature: 5 } },
  ],
  build({ temperature, rings }: Values, { seed, integrator = velocityVerlet }: BuildOptions): CrystalRun {
    const walls = [boxWalls({ min: { x: -HALF_X, y: -HALF_Y }, max: { x: HALF_X, y: HALF_Y }, restitution: 1 })];
    const world = createPhysicsWorld({ capacity: 300, forces: [betweenAtoms()], integrator, walls });
    const random = createRandom(seed);
    const places = hexagon(rings);
    const velocities = places.map(() => random.onCircle(Math.sqrt(2 * temperature)));
    const drift = {
      x: velocities.reduce((sum, { x }) => sum + x, 0) / places.length,
      y: velocities.reduce((sum, { y }) => sum + y, 0) / places.length,
    };
    const atoms = places.map((position, i) =>
      spawn(world, {
        position,
        velocity: { x: velocities[i].x - drift.x, y: velocities[i].y - drift.y },
        mass: 1,
        collider: { radius: 0.5, restitution: 1 },
        appearance: rgba(0.43, 0.72, 1),
      }),
    );
    return {
      world,
      dt: 1 / 240,
      atoms,
      temperature: () => energy(world).kinetic / atoms.length,
      start: energy(world).total,
    };
  },
  picture: () => ({
    view: { minX: -HALF_X - 0.4, maxX: HALF_X + 0.4, minY: -HALF_Y - 0.4, maxY: HALF_Y + 0.4 },
    lines: linesOf(boxOf(-HALF_X, -HALF_Y, HALF_X, HALF_Y)),
  }),
  plots: (plot) => [
    plot('Temperature', 'energy, kT', { label: 'mean kinetic energy', value: ({ temperature }) => temperature() }),
    plot('Energy per atom', 'E', {
      label: 'kinetic and potential',
      value: ({ world, atoms }) => energy(world).total / atoms.length,
    }),
  ],
  histograms: [
    {
      title: 'Distances of atoms',
      x: { label: 'r', min: 0.8, max: 4 },
      intervals: 64,
      samples: ({ world }) => distancesOf(world, 4),
    },
  ],
  checks: ({ at, mean }) => [
    at(
      10,
      'Change of the whole energy, per atom',
      { exact: 0, absolute: 1e-4 },
      ({ world, atoms, start }) => (energy(world).total - start) / atoms.length,
    ),
    at(10, 'Momentum of all', { exact: 0, absolute: 1e-11 }, ({ world }) => lengthOf(momentum(world))),
    // Half of the energy goes into the bonds, but for those at the edge.
    mean(
      20,
      'Temperature of the crystal by that at the start',
      { exact: 0.5, relative: 0.05 },
      ({ temperature }) => temperature() / 0.2,
    ),
    at(
      20,
      'Distance of neighbours in the frozen crystal',
      { exact: SPACING, relative: 5e-3, preset: 'Frozen' },
      ({ world }) => {
        const distances = distancesOf(world, NEAR);
        return distances.reduce((sum, r) => sum + r, 0) / distances.length;
      },
    ),
  ],
  tryThis: [
    'Choose “A drop”: the corners melt first, and the rows in the histogram become waves.',
    'Choose “A gas”: the order of the crystal is gone within two seconds, and the gas cools as its bonds break.',
    'Seven atoms, one ring: at which temperature does the first one fly off?',
  ],
});
