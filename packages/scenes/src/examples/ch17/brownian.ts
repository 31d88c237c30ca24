import {
  boxWalls,
  createPhysicsWorld,
  createRandom,
  energy,
  exp,
  particleContacts,
  rgba,
  spawn,
} from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { speedOf } from '../support/read.ts';
import { boxOf, linesOf } from '../support/walls.ts';

type Values = ValuesOf<'speed' | 'mass'>;

const [HALF_X, HALF_Y, SMALL, BIG] = [12, 8, 0.12, 1];
/** Molecules start on a grid, except where the dust grain is. */
const [COLUMNS, ROWS] = [36, 24];

export default defineExample({
  id: 'ch17-brownian',
  title: 'A grain of dust among molecules',
  chapter: 17,
  tags: ['gas', 'collision', 'random', 'temperature', 'energy', 'statistics'],
  about:
    'All molecules start with the same speed. After a few collisions some are slow and some are fast, with the shares that Maxwell found in 1860. They push a grain of dust from all sides, never quite evenly, and so it wanders. Brown saw that dance under his microscope in 1827; Einstein explained it in 1905.',
  duration: 160,
  parameters: {
    speed: { label: 'Start speed', unit: 'm/s', initial: 3, min: 0.5, max: 6 },
    mass: { label: 'Mass of the grain', unit: 'kg', initial: 20, min: 2, max: 200 },
  },
  presets: [{ label: 'A heavy grain', values: { mass: 200 } }],
  build({ speed, mass }: Values, { seed, ...options }: BuildOptions) {
    const walls = [boxWalls({ min: { x: -HALF_X, y: -HALF_Y }, max: { x: HALF_X, y: HALF_Y }, restitution: 1 })];
    const world = createPhysicsWorld({ preset: particleContacts, capacity: 1000, walls, ...options });
    const random = createRandom(seed);
    const material = { restitution: 1 };
    const grain = spawn(world, {
      position: {},
      velocity: {},
      mass,
      collider: { radius: BIG, ...material },
      appearance: rgba(1, 0.7, 0.28),
    });
    const molecules: number[] = [];
    for (let i = 0; i < COLUMNS * ROWS; i++) {
      const x = ((2 * (i % COLUMNS) + 1) / COLUMNS - 1) * HALF_X;
      const y = ((2 * Math.floor(i / COLUMNS) + 1) / ROWS - 1) * HALF_Y;
      if (x * x + y * y < (BIG + SMALL) * (BIG + SMALL)) continue;
      const velocity = random.onCircle(speed);
      molecules.push(
        spawn(world, {
          position: { x, y },
          velocity,
          mass: 1,
          collider: { radius: SMALL, ...material },
          appearance: rgba(0.43, 0.72, 1),
        }),
      );
    }
    const start = energy(world).kinetic;
    /** Mean energy of a molecule: kT in the plane. */
    const temperature = start / (molecules.length + 1);
    const grainEnergy = () => (mass * speedOf(world, grain) * speedOf(world, grain)) / 2;
    const meanSpeed = () => molecules.reduce((sum, id) => sum + speedOf(world, id), 0) / molecules.length;
    return { world, dt: 1 / 60, grain, molecules, start, temperature, grainEnergy, meanSpeed };
  },
  picture({ grain }) {
    return {
      view: { minX: -HALF_X - 0.3, maxX: HALF_X + 0.3, minY: -HALF_Y - 0.3, maxY: HALF_Y + 0.3 },
      lines: linesOf(boxOf(-HALF_X, -HALF_Y, HALF_X, HALF_Y)),
      trails: [{ body: grain, length: 1900, interval: 4, color: COLORS.yellow }],
    };
  },
  plots: (plot) => [plot('Energy of the grain', 'E, J', { label: 'grain', value: ({ grainEnergy }) => grainEnergy() })],
  histograms: [
    {
      title: 'Speeds of the molecules',
      x: { label: 'v, m/s', min: 0, max: 12 },
      intervals: 30,
      samples: ({ world, molecules }) => molecules.map((id) => speedOf(world, id)),
      // Maxwell's law in the plane, v/σ² e^(−v²/2σ²) with σ² = kT/m; the energy of the start is m v²/2 = kT.
      exact: (v, _, { speed }: Values) => ((2 * v) / (speed * speed)) * exp(-(v * v) / (speed * speed)),
    },
  ],
  checks: ({ at, mean }) => [
    // A fifth of the relative deviation of the mean of 860 speeds, 0.52/√860, of which hundreds are averaged.
    mean(
      160,
      'Mean speed of the molecules by Maxwell, √π/2 times that at the start',
      { exact: ({ speed }) => (speed * Math.sqrt(Math.PI)) / 2, unit: 'm/s', relative: 4e-3 },
      ({ meanSpeed }) => meanSpeed(),
    ),
    // Energies in the plane are distributed exponentially: three errors of the mean of about 80 independent ones.
    mean(
      160,
      'Mean energy of the grain by that of a molecule',
      { exact: 1, absolute: 0.35 },
      ({ grainEnergy, temperature }) => grainEnergy() / temperature,
    ),
    at(
      60,
      'Change of the whole energy in a minute, as a fraction',
      { exact: 0, absolute: 1e-10 },
      ({ world, start }) => energy(world).kinetic / start - 1,
    ),
  ],
  tryThis: [
    'Watch the histogram in the first second: a single bar, which spreads to Maxwell’s curve.',
    'Choose “A heavy grain”: it is slower, but on average it has the same energy as a molecule.',
  ],
});
