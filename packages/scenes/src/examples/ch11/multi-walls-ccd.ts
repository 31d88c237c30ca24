import { createRandom, energy, rgba, spawn } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { positionOf } from '../support/read.ts';
import { linesOf, ROOM, worldWithWalls } from '../support/walls.ts';

const SCALE = 100 * 310;
const MAX_COUNT = 200;

export default defineExample({
  id: 'ch11-multi-walls-ccd',
  title: 'Ten minutes behind thin walls',
  chapter: 11,
  tags: ['collision', 'wall', 'tunnelling', 'energy'],
  about:
    'Twenty small balls bounce in the room with the inclined walls for ten minutes, thousands of times each. None may leave, none may gain or lose energy. A program that repairs each bounce a little wrongly would be found out here.',
  duration: 600,
  parameters: {
    count: { label: 'Balls', initial: 20, min: 1, max: MAX_COUNT, integer: true },
    radius: { label: 'Radius', unit: 'px', initial: 4, min: 1, max: 10 },
    restitution: { label: 'Restitution e', initial: 1, min: 0, max: 1 },
  },
  presets: [{ label: 'Dust', values: { count: MAX_COUNT, radius: 1 } }],
  build({ count, radius, restitution }, { seed, ...options }) {
    const world = worldWithWalls(ROOM, { gravity: 100, capacity: MAX_COUNT + 20, ...options });
    const random = createRandom(seed);
    const balls = Array.from({ length: count }, () => {
      const position = { x: random.uniform(220, 330), y: random.uniform(70, 180) };
      const velocity = { x: random.uniform(-50, 50) };
      const appearance = rgba(random.uniform(0.5, 1), random.uniform(0.5, 1), 1);
      return spawn(world, { position, velocity, mass: 1, collider: { radius, restitution }, appearance });
    });
    const start = energy(world).total;
    const loss = () => (energy(world).total - start) / (count * SCALE);
    const isOut = (id: number) => {
      const { x, y } = positionOf(world, id);
      return x < 50 || x > 550 || y < 50 || y > 400;
    };
    return { world, dt: 1 / 60, balls, loss, escaped: () => balls.filter(isOut).length };
  },
  picture({ balls }) {
    return {
      yDown: true,
      view: { minX: 30, maxX: 570, minY: 30, maxY: 420 },
      lines: linesOf(ROOM),
      trails: balls.slice(0, 5).map((body) => ({ body, length: 120 })),
    };
  },
  plots: (plot) => [
    plot('Change of the energy', 'fraction of m g · 310 px', { label: 'all', value: ({ loss }) => loss() }),
    plot('Balls outside', 'number', { label: 'escaped', value: ({ escaped }) => escaped() }),
  ],
  checks: ({ largest }) => [
    largest(600, 'Most balls outside at any time', { exact: 0, absolute: 0 }, ({ escaped }) => escaped()),
    largest(600, 'Largest change of the energy in ten minutes', { exact: 0, absolute: 0.005 }, ({ loss }) =>
      Math.abs(loss()),
    ),
  ],
  tryThis: [
    'Choose “Dust”: the balls start close together, and soon are everywhere.',
    'Set the restitution to 0.9: they bounce lower and lower, and all end on the floor.',
  ],
});
