import { createPhysicsWorld, createRandom, energy, momentum, mutualGravity, rgba, spawn } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { lengthOf } from '../support/read.ts';

const STAGE = { minX: 0, maxX: 800, minY: 0, maxY: 600 };

export default defineExample({
  id: 'ch12-nbody-cutoff',
  title: 'Two hundred stars attract each other',
  chapter: 12,
  tags: ['gravity', 'n-body', 'momentum', 'energy'],
  about:
    'Every star pulls every other: 19 900 pairs. The cloud falls together, swings back, and throws some stars out for ever. Since the two forces of each pair are opposite, the momentum of the whole stays to the last digits. Very close pairs are softened, as if each star were a little cloud.',
  duration: 100,
  parameters: {
    count: { label: 'Stars', initial: 200, min: 2, max: 400, integer: true },
    softening: { label: 'Softening ε', unit: 'px', initial: 10, min: 1, max: 50, scale: 'log' },
    gravity: { label: 'Strength of gravity G', unit: 'px³/(kg s²)', initial: 1, min: 0, max: 10 },
  },
  presets: [{ label: 'A dozen', values: { count: 12, gravity: 10 } }],
  build({ count, softening, gravity }, { seed, ...options }) {
    const forces = [mutualGravity({ G: gravity, softening })];
    const world = createPhysicsWorld({ capacity: 420, forces, ...options });
    const random = createRandom(seed);
    const ids = Array.from({ length: count }, () => {
      const mass = random.uniform(10, 110);
      const appearance = { size: 1.5 + mass / 40, color: rgba(1, 0.75 + mass / 450, 0.5 + mass / 220) };
      const position = { x: random.uniform(STAGE.minX, STAGE.maxX), y: random.uniform(STAGE.minY, STAGE.maxY) };
      const velocity = { x: random.uniform(-5, 5), y: random.uniform(-5, 5) };
      return spawn(world, { position, velocity, mass, appearance });
    });
    const { Velocity, Mass } = world.components;
    const scale = ids.reduce((sum, id) => sum + Mass.value[id] * lengthOf({ x: Velocity.x[id], y: Velocity.y[id] }), 0);
    const before = { momentum: momentum(world), energy: energy(world).total };
    /** Change of the momentum, by the sum of the sizes of all at the start. */
    const drift = () => {
      const { x, y } = momentum(world);
      return lengthOf({ x: x - before.momentum.x, y: y - before.momentum.y }) / scale;
    };
    return { world, dt: 1 / 60, ids, drift, loss: () => energy(world).total / before.energy - 1 };
  },
  picture({ ids }) {
    return {
      yDown: true,
      view: STAGE,
      fills: [{ shape: { minX: -3000, maxX: 4000, minY: -3000, maxY: 4000 }, color: 0x05070f }],
      trails: ids.slice(0, 12).map((body) => ({ body, length: 500, interval: 4 })),
    };
  },
  plots: (plot) => [
    plot(
      'Energies',
      'E, kg px²/s²',
      { label: 'kinetic', value: ({ world }) => energy(world).kinetic },
      { label: 'potential', value: ({ world }) => energy(world).potential },
      { label: 'total', value: ({ world }) => energy(world).total },
    ),
  ],
  checks: ({ at }) => [
    at(100, 'Change of the momentum in 100 s, by the sum of all sizes', { exact: 0, absolute: 1e-10 }, ({ drift }) =>
      drift(),
    ),
    at(100, 'Change of the energy in 100 s', { exact: 0, absolute: 0.01 }, ({ loss }) => loss()),
  ],
  tryThis: [
    'Turn gravity off: the cloud slowly spreads.',
    'Choose “A dozen”: close pairs form, and fling the others out.',
  ],
});
