import {
  cos,
  createPhysicsWorld,
  keepState,
  rungeKutta4,
  sin,
  spawn,
  stringTension,
  uniformGravity,
} from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { pendulumPeriod } from '../support/pendulum.ts';
import { positionOf, velocityOf } from '../support/read.ts';

const PIVOT = { x: 300, y: 50 };
const DIAL = { x: 560, y: 150 };
const GRAVITY = 100;

export default defineExample({
  id: 'ch09-pendulum-timed',
  title: 'Time the pendulum yourself',
  chapter: 9,
  tags: ['pendulum', 'oscillation', 'measurement'],
  about:
    'The watch starts as the bob is let go. Stop it when the bob is back, and compare with 2π √(L/g). Whoever stops after ten swings and divides by ten makes the error of their own reaction ten times smaller.',
  duration: 100,
  parameters: {
    degrees: { label: 'Start', unit: '°', initial: 30, min: 1, max: 85 },
    length: { label: 'Length L', unit: 'px', initial: 200, min: 50, max: 250 },
  },
  presets: [{ label: 'A small swing', values: { degrees: 1 } }],
  build({ degrees, length }, { integrator = rungeKutta4 }) {
    const forces = [uniformGravity({ y: GRAVITY }), stringTension({ pivot: PIVOT, length })];
    const world = createPhysicsWorld({ capacity: 4, forces, integrator });
    const angle = (degrees * Math.PI) / 180;
    const position = { x: PIVOT.x + length * sin(angle), y: PIVOT.y + length * cos(angle) };
    const bob = spawn(world, { position, mass: 1, collider: 14 });
    /** Reading of the watch when it was stopped, s; it runs while this is negative. */
    const watch = { stopped: -1 };
    keepState(world, watch);
    const reading = () => (watch.stopped < 0 ? world.time : watch.stopped);
    return { world, dt: 1 / 60, bob, watch, reading };
  },
  picture({ world, bob, reading }) {
    const hand = () => {
      const angle = (reading() * Math.PI) / 5;
      return { x: DIAL.x + 55 * sin(angle), y: DIAL.y - 55 * cos(angle) };
    };
    const mark = (i: number, radius: number) => ({
      x: DIAL.x + radius * sin((i * Math.PI) / 5),
      y: DIAL.y - radius * cos((i * Math.PI) / 5),
    });
    return {
      yDown: true,
      view: { minX: 90, maxX: 660, minY: 10, maxY: 360 },
      fills: [
        { shape: { centre: DIAL, radius: 75 }, color: 0xe8ecfb },
        { shape: { centre: DIAL, radius: 68 }, color: 0x1d2647 },
      ],
      lines: [
        { from: { x: 250, y: PIVOT.y }, to: { x: 350, y: PIVOT.y }, color: COLORS.grey, width: 4 },
        { from: PIVOT, to: () => positionOf(world, bob) },
        ...Array.from({ length: 10 }, (_, i) => ({ from: mark(i, 58), to: mark(i, 66), color: COLORS.grey })),
        { from: DIAL, to: hand, width: 4, color: COLORS.red },
      ],
      labels: [{ at: { x: DIAL.x - 34, y: DIAL.y + 100 }, text: () => `${reading().toFixed(2)} s` }],
    };
  },
  actions: {
    action: {
      label: 'Stop',
      about: 'stop the watch, or let it go on',
      key: 's',
      press({ world, watch }) {
        watch.stopped = watch.stopped < 0 ? world.time : -1;
      },
    },
  },
  pointer: 'action',
  plots: (plot) => [
    plot('Displacement', 'x, px', { label: 'bob', value: ({ world, bob }) => positionOf(world, bob).x - PIVOT.x }),
  ],
  checks: [
    {
      label: 'A tenth of the time of ten swings',
      unit: 's',
      exact: ({ degrees, length }) => pendulumPeriod(length, GRAVITY, degrees),
      tolerance: { relative: 1e-4 },
      // The bob turns back from the left when its velocity to the left ends: at the tenth return it is on the right.
      at: { event: ({ world, bob }) => -velocityOf(world, bob).x, count: 10 },
      measure: ({ world }) => world.time / 10,
    },
    {
      label: 'A tenth of the time of ten small swings',
      unit: 's',
      exact: ({ degrees, length }) => pendulumPeriod(length, GRAVITY, degrees),
      tolerance: { relative: 1e-4 },
      at: { event: ({ world, bob }) => -velocityOf(world, bob).x, count: 10 },
      measure: ({ world }) => world.time / 10,
      preset: 'A small swing',
    },
  ],
  tryThis: [
    'Stop the watch after one swing, then after ten: which of your periods is nearer to the exact one?',
    'Choose “A small swing”: the period is shorter by not quite two per cent.',
  ],
});
