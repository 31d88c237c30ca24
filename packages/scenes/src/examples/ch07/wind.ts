import { createPhysicsWorld, quadraticDrag, rgba, spawn } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { forceArrow, velocityArrow } from '../support/arrows.ts';
import { velocityOf } from '../support/read.ts';

/** Drag of the balls by their mass, 1/px. */
const DRAG = 5e-4;

export default defineExample({
  id: 'ch07-wind',
  title: 'Carried by the wind',
  chapter: 7,
  tags: ['wind', 'drag'],
  about:
    'Wind is drag turned round: it acts by the difference between its velocity and that of the body. The white ball already moves with the wind and feels nothing. The blue one starts at rest, is blown along ever faster, and never quite gets as fast as the wind.',
  duration: 60,
  parameters: {
    wind: { label: 'Wind', unit: 'px/s', initial: 40, min: 5, max: 100 },
    drag: { label: 'Drag coefficient by mass', unit: '1/px', initial: DRAG, min: 1e-4, max: 1e-2, scale: 'log' },
  },
  presets: [{ label: 'A feather', values: { drag: 1e-2 } }],
  build({ wind, drag }, options) {
    const world = createPhysicsWorld({ capacity: 4, forces: [quadraticDrag({ x: wind })], ...options });
    const body = { mass: 1, quadraticDrag: drag, collider: 25 };
    const still = spawn(world, { ...body, position: { x: 0, y: 100 }, velocity: {}, appearance: rgba(0.4, 0.7, 1) });
    const along = { position: { x: 0, y: -100 }, velocity: { x: wind }, appearance: rgba(0.95, 0.95, 1) };
    const carried = spawn(world, { ...body, ...along });
    return { world, dt: 1 / 60, still, carried };
  },
  picture({ world, still, carried }, { wind, drag }) {
    const force = () => {
      const ahead = wind - velocityOf(world, still).x;
      return { x: drag * Math.abs(ahead) * ahead, y: 0 };
    };
    return {
      view: { minX: -100, maxX: 60 * wind, minY: -15 * wind, maxY: 15 * wind },
      trails: [
        { body: still, length: 2000, interval: 2 },
        { body: carried, length: 2000, interval: 2 },
      ],
      arrows: [
        { ...forceArrow(world, still, 'force', force, 300), color: COLORS.red },
        velocityArrow(world, still, 8),
        velocityArrow(world, carried, 8),
      ],
    };
  },
  plots: (plot) => [
    plot(
      'Speed',
      'v, px/s',
      {
        label: 'from rest',
        value: ({ world, still }) => velocityOf(world, still).x,
        exact: (t, { wind, drag }) => wind - wind / (1 + drag * wind * t),
      },
      { label: 'with the wind', value: ({ world, carried }) => velocityOf(world, carried).x },
    ),
  ],
  checks: ({ at }) => [
    at(
      30,
      'What the wind is ahead of the ball after 30 s, w/(1 + k w t/m)',
      { exact: ({ wind, drag }) => wind / (1 + drag * wind * 30), unit: 'px/s', relative: 1e-4 },
      ({ world, still, carried }) => velocityOf(world, carried).x - velocityOf(world, still).x,
    ),
    at(
      60,
      'Speed of the ball that moves with the wind after 60 s',
      { exact: ({ wind }) => wind, unit: 'px/s', absolute: 0 },
      ({ world, carried }) => velocityOf(world, carried).x,
    ),
  ],
  tryThis: [
    'Choose “A feather”: it has nearly the speed of the wind after half a minute.',
    'Double the wind: the force on the resting ball becomes four times as large.',
  ],
});
