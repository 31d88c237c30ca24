import { defineExample } from '../define-example.ts';
import { COLORS, type Point } from '../picture.ts';
import { areaOf, type RealFunction } from '../support/functions.ts';
import { emptyWorld } from '../support/read.ts';

/** Rises from 0 to the period, and begins again. */
const sawtooth =
  (period: number): RealFunction =>
  (x) =>
    x - period * Math.floor(x / period);
/** 1 for a share of each unit of x, and 0 for the rest. */
const squareWave =
  (duty: number): RealFunction =>
  (x) =>
    x - Math.floor(x) < duty ? 1 : 0;

/** Corners of the teeth, a little apart where the value jumps. */
function corners(period: number): Point[] {
  const points: Point[] = [];
  for (let x = 0; x < 10; x += period) {
    const end = Math.min(10, x + period);
    points.push({ x, y: 2 }, { x: end, y: 2 + end - x });
  }
  return points;
}

function steps(duty: number): Point[] {
  return Array.from({ length: 10 }, (_, x) => [
    { x, y: 0 },
    { x, y: 1 },
    { x: x + duty, y: 1 },
    { x: x + duty, y: 0 },
  ]).flat();
}

export default defineExample({
  id: 'ch03-periodic',
  title: 'Sawtooth and square wave',
  chapter: 3,
  tags: ['functions', 'waves', 'periodic'],
  about:
    'A periodic function repeats itself: know one period, and you know all. The sawtooth rises evenly and drops at once, like the beam of an old television. The square wave is on or off, like a lamp that blinks. Its mean is the share of the time in which it is on.',
  duration: 10,
  parameters: {
    period: { label: 'Period of the sawtooth', initial: 2, min: 0.5, max: 4 },
    duty: { label: 'Share of time on', initial: 0.5, min: 0.05, max: 0.95 },
  },
  build: () => ({ world: emptyWorld(), dt: 1 / 60 }),
  picture({ world }, { period, duty }) {
    const x = () => world.time % 10;
    return {
      graph: { x: { label: 'x', step: 1 }, y: { label: 'y', step: 1 } },
      view: { minX: 0, maxX: 10, minY: -0.5, maxY: 2.5 + period },
      curves: [
        { points: corners(period), color: COLORS.blue },
        { points: steps(duty), color: COLORS.green },
      ],
      lines: [
        { from: () => ({ x: x(), y: -0.5 }), to: () => ({ x: x(), y: 2.5 + period }), color: COLORS.grey, width: 1 },
      ],
      dots: [
        { at: () => ({ x: x(), y: 2 + sawtooth(period)(x()) }) },
        { at: () => ({ x: x(), y: squareWave(duty)(x()) }) },
      ],
      labels: [
        { at: { x: 0.1, y: 2.1 + period }, text: 'sawtooth, drawn 2 higher', color: COLORS.blue },
        { at: { x: 0.1, y: 1.05 }, text: 'square wave', color: COLORS.green },
      ],
    };
  },
  plots: [],
  checks: ({ at }) => [
    at(
      0,
      'Mean of the sawtooth over five periods, half the period',
      { exact: 1, relative: 0.01 },
      () => areaOf(sawtooth(2), 0, 10, 1000) / 10,
    ),
    at(
      0,
      'Mean of the square wave, its share of time on',
      { exact: 0.5, relative: 0.01 },
      () => areaOf(squareWave(0.5), 0, 10, 1000) / 10,
    ),
  ],
  tryThis: [
    'Make the period of the sawtooth 1: both waves now begin anew at the same places.',
    'Let the square wave be on for nine tenths of the time: a dimmed lamp works like that, only faster.',
  ],
});
