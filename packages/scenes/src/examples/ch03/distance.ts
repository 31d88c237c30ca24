import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { distanceBetween, emptyWorld } from '../support/read.ts';

export default defineExample({
  id: 'ch03-distance',
  title: 'How far apart?',
  chapter: 3,
  tags: ['vectors', 'pythagoras'],
  about:
    'Go from one point to the other along the grid: first across, then up. The straight line is the long side of a right-angled triangle, so its square is the sum of the two squares: 3² + 4² = 5². Games ask this question all the time: has the ball touched the player?',
  duration: 4,
  parameters: {
    ax: { label: 'First point, x', initial: 1, min: 0, max: 9 },
    ay: { label: 'First point, y', initial: 2, min: 0, max: 7 },
    bx: { label: 'Second point, x', initial: 4, min: 0, max: 9 },
    by: { label: 'Second point, y', initial: 6, min: 0, max: 7 },
  },
  presets: [{ label: 'Five and twelve, halved', values: { ax: 1, ay: 1, bx: 7, by: 3.5 } }],
  build({ ax, ay, bx, by }: ValuesOf<'ax' | 'ay' | 'bx' | 'by'>) {
    const world = emptyWorld();
    const [a, b] = [
      { x: ax, y: ay },
      { x: bx, y: by },
    ];
    // The walker goes over and back in eight seconds.
    const share = () => 1 - Math.abs(((world.time / 4) % 2) - 1);
    const walker = () => ({ x: a.x + share() * (b.x - a.x), y: a.y + share() * (b.y - a.y) });
    return { world, dt: 1 / 60, a, b, walker };
  },
  picture: ({ a, b, walker }) => ({
    graph: { x: { label: 'x', step: 1 }, y: { label: 'y', step: 1 } },
    view: { minX: 0, maxX: 10, minY: 0, maxY: 8 },
    lines: [
      { from: a, to: { x: b.x, y: a.y }, color: COLORS.green },
      { from: { x: b.x, y: a.y }, to: b, color: COLORS.orange },
      { from: a, to: b, color: COLORS.white, width: 3 },
    ],
    dots: [
      { at: a, color: COLORS.blue, radius: 8 },
      { at: b, color: COLORS.blue, radius: 8 },
      { at: walker, color: COLORS.yellow },
    ],
    labels: [
      { at: { x: (a.x + b.x) / 2, y: a.y }, text: Math.abs(b.x - a.x).toFixed(1), color: COLORS.green },
      { at: { x: b.x + 0.15, y: (a.y + b.y) / 2 }, text: Math.abs(b.y - a.y).toFixed(1), color: COLORS.orange },
      { at: walker, text: () => `  ${distanceBetween(a, walker()).toFixed(2)}` },
    ],
  }),
  plots: (plot) => [
    plot('Distance from the first point', 'distance', {
      label: 'distance',
      value: ({ a, walker }) => distanceBetween(a, walker()),
    }),
  ],
  checks: ({ at }) => [
    at(0, 'Distance of (1, 2) and (4, 6)', { exact: 5, absolute: 0 }, ({ a, b }) => distanceBetween(a, b)),
    at(
      4,
      'Distance that the walker has gone after 4 s',
      { exact: ({ ax, ay, bx, by }) => Math.sqrt((bx - ax) * (bx - ax) + (by - ay) * (by - ay)), absolute: 1e-9 },
      ({ a, walker }) => distanceBetween(a, walker()),
    ),
  ],
  tryThis: [
    'Choose the preset: 6 across and 2.5 up make 6.5, which is the triangle 5, 12, 13 at half its size.',
    'Exchange the two points: the distance stays the same.',
  ],
});
