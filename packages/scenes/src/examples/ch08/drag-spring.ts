import { createPhysicsWorld, quadraticDrag, rgba, spawn, springs, uniformGravity } from '@principia/physics';
import { choiceOf, defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { distanceBetween, positionOf } from '../support/read.ts';

const ANCHOR = { x: 350, y: 50 };
/** A second figure, without drag, bounces or swings a little about the place of rest. */
const OTHER = { x: 600, y: 50 };
const [LENGTH, GRAVITY] = [200, 20];
/** How far that figure is from there at the start, px. */
const SMALL = 4;

export default defineExample({
  id: 'ch08-drag-spring',
  title: 'A puppet on a spring',
  chapter: 8,
  tags: ['spring', 'gravity', 'pendulum', 'drag the mouse'],
  about:
    'A figure hangs on a spring. Drag it anywhere with the mouse and let go: it bounces and swings at once, two motions with two periods. It comes to rest where the spring carries its weight.',
  duration: 60,
  parameters: {
    stiffness: { label: 'Stiffness k', unit: 'N/m', initial: 1, min: 0.5, max: 10 },
    drag: { label: 'Drag coefficient', unit: 'kg/px', initial: 0.1, min: 0, max: 1 },
    other: choiceOf('The second figure', ['bounces', 'swings']),
  },
  presets: [
    { label: 'No drag', values: { drag: 0 } },
    { label: 'A small swing', values: { other: 1 } },
  ],
  build({ stiffness, drag, other }, options) {
    const forces = [uniformGravity({ y: GRAVITY }), quadraticDrag(), springs()];
    const world = createPhysicsWorld({ capacity: 10, forces, ...options });
    const hang = (anchor: { x: number; y: number }, position: { x: number; y: number }, quadratic: number) => {
      const a = spawn(world, { position: anchor });
      const appearance = rgba(1, 0.72, 0.4);
      const b = spawn(world, { position, mass: 1, collider: 20, quadraticDrag: quadratic, appearance });
      spawn(world, { spring: { a, b, stiffness, length: LENGTH } });
      return b;
    };
    const rest = ANCHOR.y + LENGTH + GRAVITY / stiffness;
    const figure = hang(ANCHOR, { x: 300, y: 200 }, drag);
    const start = other === 1 ? { x: OTHER.x + SMALL, y: rest } : { x: OTHER.x, y: rest + SMALL };
    const free = hang(OTHER, start, 0);
    return { world, dt: 1 / 60, figure, free, rest };
  },
  picture({ world, figure, free, rest }) {
    const part = (body: number, x: number, y: number) => () => ({
      x: positionOf(world, body).x + x,
      y: positionOf(world, body).y + y,
    });
    const limbs = [figure, free].flatMap((body) =>
      [
        [-8, 16, -14, 36],
        [8, 16, 14, 36],
        [-16, -8, -32, 4],
        [16, -8, 32, 4],
      ].map(([x, y, toX, toY]) => ({
        from: part(body, x, y),
        to: part(body, toX, toY),
        width: 4,
        color: COLORS.orange,
      })),
    );
    return {
      yDown: true,
      view: { minX: 50, maxX: 720, minY: 20, maxY: 420 },
      springs: { coils: 20 },
      lines: [...limbs, { from: { x: 50, y: rest }, to: { x: 720, y: rest }, color: COLORS.ground, width: 1 }],
      dots: [figure, free].map((body) => ({ at: part(body, 0, -28), radius: 9, color: COLORS.orange })),
      trails: [{ body: figure, length: 600 }],
      arrows: [velocityArrow(world, figure, 0.6)],
      labels: [{ at: { x: 90, y: rest - 10 }, text: 'rest', color: COLORS.grey }],
    };
  },
  plots: (plot) => [
    plot(
      'Height above the place of rest',
      'h, px',
      { label: 'dragged', value: ({ world, figure, rest }) => rest - positionOf(world, figure).y },
      { label: 'without drag', value: ({ world, free, rest }) => rest - positionOf(world, free).y },
    ),
    plot('Length of the spring', 'length, px', {
      label: 'dragged',
      value: ({ world, figure }) => distanceBetween(positionOf(world, figure), ANCHOR),
    }),
  ],
  checks: ({ at, mean }) => [
    {
      label: 'Period of a small bounce, 2π √(m/k)',
      unit: 's',
      exact: 2 * Math.PI,
      tolerance: { relative: 1e-3 },
      at: { event: ({ world, free, rest }) => positionOf(world, free).y - rest, from: 1, to: 2 },
    },
    {
      label: 'Period of a small swing, that of a pendulum of the length at rest, 2π √((L + mg/k)/g)',
      unit: 's',
      exact: ({ stiffness }) => 2 * Math.PI * Math.sqrt((LENGTH + GRAVITY / stiffness) / GRAVITY),
      // The spring gives way, and turns by up to θ = 4/220: both shift the period by the order of θ², 3.3e-4.
      tolerance: { relative: 1e-3 },
      at: { event: ({ world, free }) => positionOf(world, free).x - OTHER.x, from: 1, to: 2 },
      preset: 'A small swing',
    },
    mean(
      12 * Math.PI,
      'Depth of rest below the hook, L + mg/k: the mean of six bounces',
      { exact: 220, unit: 'px', relative: 1e-3 },
      ({ world, free }) => positionOf(world, free).y - OTHER.y,
    ),
    at(
      60,
      'Depth of the dragged figure below the hook after 60 s',
      { exact: 220, unit: 'px', relative: 0.005 },
      ({ world, figure }) => positionOf(world, figure).y - ANCHOR.y,
    ),
  ],
  tryThis: [
    'Pull the figure far to the side and release it: it swings about three times more slowly than it bounces.',
    'Choose “A small swing”: the second figure swings like a stiff pendulum, once in 20.84 s.',
    'Make the spring ten times stiffer: the bounce becomes fast, the swing hardly changes.',
  ],
});
