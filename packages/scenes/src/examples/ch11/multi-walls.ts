import { energy, spawn } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { velocityArrow } from '../support/arrows.ts';
import { positionOf } from '../support/read.ts';
import { linesOf, ROOM, worldWithWalls } from '../support/walls.ts';

/** The energy that a ball of 1 kg gains by falling through the room, J. */
const SCALE = 100 * 310;

export default defineExample({
  id: 'ch11-multi-walls',
  title: 'A room with inclined walls',
  chapter: 11,
  tags: ['collision', 'wall', 'energy', 'chaos'],
  about:
    'The ball falls on one wall after the other, round their ends as well. If all bounces are elastic it never comes to rest: what it loses in height it has as speed, and the sum stays. Two balls that start a hair apart soon go quite different ways.',
  duration: 60,
  parameters: {
    restitution: { label: 'Restitution e', initial: 1, min: 0, max: 1 },
    radius: { label: 'Radius', unit: 'px', initial: 12, min: 2, max: 16 },
    apart: { label: 'A second ball, further right by', unit: 'px', initial: 1e-3, min: 1e-6, max: 10, scale: 'log' },
  },
  presets: [{ label: 'Duller walls', values: { restitution: 0.8 } }],
  build({ restitution, radius, apart }, options) {
    const world = worldWithWalls(ROOM, { gravity: 100, capacity: 16, ...options });
    const body = { velocity: {}, mass: 1, collider: { radius, restitution } };
    const ball = spawn(world, { ...body, position: { x: 200, y: 90 } });
    const twin = spawn(world, { ...body, position: { x: 200 + apart, y: 90 }, appearance: 0xff66b2ff });
    const start = energy(world).total;
    const loss = () => (energy(world).total - start) / (2 * SCALE);
    const outside = () =>
      Math.max(
        ...[ball, twin].map((id) => {
          const { x, y } = positionOf(world, id);
          return radius + Math.max(50 - x, x - 550, 50 - y, y - 400);
        }),
      );
    return { world, dt: 1 / 60, ball, twin, loss, outside };
  },
  picture({ world, ball, twin }) {
    return {
      yDown: true,
      view: { minX: 30, maxX: 570, minY: 30, maxY: 420 },
      lines: linesOf(ROOM),
      trails: [
        { body: ball, length: 200 },
        { body: twin, length: 200 },
      ],
      arrows: [velocityArrow(world, ball, 0.3)],
    };
  },
  plots: (plot) => [
    plot('Change of the energy', 'fraction of m g · 310 px', { label: 'both', value: ({ loss }) => loss() }),
    plot(
      'Places',
      'x, px',
      { label: 'ball', value: ({ world, ball }) => positionOf(world, ball).x },
      { label: 'second ball', value: ({ world, twin }) => positionOf(world, twin).x },
    ),
  ],
  checks: ({ largest }) => [
    largest(60, 'Largest change of the energy in 60 s, of m g · 310 px', { exact: 0, absolute: 0.005 }, ({ loss }) =>
      Math.abs(loss()),
    ),
    largest(
      60,
      'Deepest that a ball is ever in an outer wall',
      { exact: 0, unit: 'px', absolute: 1e-9 },
      ({ outside }) => Math.max(0, outside()),
    ),
  ],
  tryThis: [
    'Watch the two balls, which start a thousandth of a pixel apart: how many bounces does it take until you can tell them apart?',
    'Choose “Duller walls”: the ball ends on the floor.',
  ],
});
