import { createPhysicsWorld, rgba, spawn, velocityVerlet } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { positionOf } from '../support/read.ts';

const START = { x: 150, y: 50 };

export default defineExample({
  id: 'ch04-ball-move',
  title: 'Moving evenly',
  chapter: 4,
  tags: ['uniform motion', 'velocity'],
  about:
    'Nothing pushes the ball and nothing brakes it, so it keeps its velocity: in each second it goes 30 px to the right and 20 px down. The marks show where it will be after each second: they lie on a straight line at equal distances.',
  duration: 5,
  ends: true,
  parameters: {
    vx: { label: 'Velocity to the right', unit: 'px/s', initial: 30, min: -20, max: 80 },
    vy: { label: 'Velocity downwards', unit: 'px/s', initial: 20, min: 0, max: 50 },
  },
  build({ vx, vy }, { integrator = velocityVerlet }) {
    const world = createPhysicsWorld({ capacity: 4, integrator });
    const look = { collider: 20, appearance: rgba(1, 0.35, 0.3) };
    const ball = spawn(world, { position: START, velocity: { x: vx, y: vy }, mass: 1, ...look });
    return { world, dt: 1 / 60, ball };
  },
  picture: ({ world, ball }, { vx, vy }) => ({
    yDown: true,
    view: { minX: 0, maxX: 600, minY: 0, maxY: 350 },
    trails: [{ body: ball, length: 300 }],
    arrows: [velocityArrow(world, ball, 1.5)],
    dots: [1, 2, 3, 4, 5].map((t) => ({
      at: { x: START.x + vx * t, y: START.y + vy * t },
      radius: 4,
      color: COLORS.grey,
    })),
    labels: [1, 2, 3, 4, 5].map((t) => ({
      at: { x: START.x + vx * t, y: START.y + vy * t - 22 },
      text: `${t} s`,
      color: COLORS.grey,
    })),
  }),
  plots: (plot) => [
    plot(
      'Distance from the start',
      'distance, px',
      {
        label: 'to the right',
        value: ({ world, ball }) => positionOf(world, ball).x - START.x,
        exact: (t, { vx }) => vx * t,
      },
      {
        label: 'downwards',
        value: ({ world, ball }) => positionOf(world, ball).y - START.y,
        exact: (t, { vy }) => vy * t,
      },
    ),
  ],
  checks: ({ at }) => [
    at(
      5,
      'x after 5 s, from 150 px at the start',
      { exact: ({ vx }) => START.x + 5 * vx, unit: 'px', absolute: 1e-9 },
      ({ world, ball }) => positionOf(world, ball).x,
    ),
    at(
      5,
      'y after 5 s, from 50 px at the start',
      { exact: ({ vy }) => START.y + 5 * vy, unit: 'px', absolute: 1e-9 },
      ({ world, ball }) => positionOf(world, ball).y,
    ),
  ],
  tryThis: [
    'Give it the velocity 60 and 40: the direction is the same, and it gets twice as far.',
    'Set the velocity downwards to 0: the downward curve in the plot becomes level.',
  ],
});
