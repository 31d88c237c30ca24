import { createRandom, rgba, spawn } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { positionOf } from '../support/read.ts';
import { boxOf, linesOf, worldWithWalls } from '../support/walls.ts';

/** A room with a wall from side to side, from (50, 200) to (700, 500). */
const WALLS = [...boxOf(50, 50, 700, 550), [50, 200, 700, 500] as const];
const isBelow = ({ x, y }: { x: number; y: number }) => y > 200 + (300 / 650) * (x - 50);

export default defineExample({
  id: 'ch11-inclined-wall-ccd',
  title: 'Too fast to be seen, not too fast to be stopped',
  chapter: 11,
  tags: ['collision', 'wall', 'tunnelling'],
  about:
    'A thousand small balls are shot at 10 000 px/s: in one step of a sixtieth of a second each flies 167 px, far more than the thickness of any wall. A program that looks only at where the balls are would let them jump through. Here the path of each step is followed to the first wall, and no ball gets below the slope.',
  duration: 20,
  parameters: {
    speed: { label: 'Speed', unit: 'px/s', initial: 10_000, min: 100, max: 100_000, scale: 'log' },
    restitution: { label: 'Restitution e', initial: 0.6, min: 0, max: 1 },
    count: { label: 'Balls', initial: 1000, min: 1, max: 2000, integer: true },
  },
  presets: [{ label: 'Elastic walls', values: { restitution: 1 } }],
  build({ speed, restitution, count }, { seed, ...options }) {
    const world = worldWithWalls(WALLS, { gravity: 100, capacity: 2100, ...options });
    const random = createRandom(seed);
    const appearance = rgba(1, 0.75, 0.4);
    const balls = Array.from({ length: count }, () => {
      const position = { x: random.uniform(300, 680), y: random.uniform(60, 280) };
      const velocity = random.onCircle(speed);
      return spawn(world, { position, velocity, mass: 1, collider: { radius: 1, restitution }, appearance });
    });
    const escaped = () =>
      balls.filter((ball) => {
        const at = positionOf(world, ball);
        return at.x < 50 || at.x > 700 || at.y < 50 || isBelow(at);
      }).length;
    return { world, dt: 1 / 60, escaped };
  },
  picture() {
    return { yDown: true, view: { minX: 30, maxX: 720, minY: 30, maxY: 570 }, lines: linesOf(WALLS) };
  },
  plots: (plot) => [plot('Balls on the wrong side', 'number', { label: 'escaped', value: ({ escaped }) => escaped() })],
  checks: ({ largest }) => [
    largest(15, 'Most balls on the wrong side at any time', { exact: 0, absolute: 0 }, ({ escaped }) => escaped()),
    largest(15, 'The same with elastic walls', { exact: 0, absolute: 0, preset: 'Elastic walls' }, ({ escaped }) =>
      escaped(),
    ),
  ],
  tryThis: [
    'Shoot at 100 000 px/s: still none comes through.',
    'Choose “Elastic walls”: the balls never slow down, and fill the space above the wall evenly.',
  ],
});
