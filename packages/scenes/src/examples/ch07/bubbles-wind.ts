import {
  buoyancy,
  createPhysicsWorld,
  createRandom,
  quadraticDrag,
  rgba,
  spawn,
  uniformGravity,
} from '@principia/physics';
import type { SceneRun } from '../../scene.ts';
import { defineExample } from '../define-example.ts';
import { velocityArrow } from '../support/arrows.ts';
import { bubble, RISE } from '../support/bubble.ts';
import { tanh } from '../support/hyperbolic.ts';
import { velocityOf } from '../support/read.ts';

const RADII = [5, 15, 25] as const;
/** Speeds of bubbles of these radii at which drag balances their lift, px/s. */
const LIMITS = [8.206, 14.213, 18.349] as const;

/** Speed of a bubble that rises in still air and tends to a limit. */
const rising = (limit: number, t: number) => limit * tanh((RISE / limit) * t);

interface Run extends SceneRun {
  readonly wind: number;
  /** One bubble of each of the radii. */
  readonly measured: readonly number[];
}

export default defineExample({
  id: 'ch07-bubbles-wind',
  title: 'Soap bubbles in the wind',
  chapter: 7,
  tags: ['wind', 'drag', 'buoyancy'],
  about:
    'Bubbles of warm air are one per cent lighter than the air around them, and rise slowly. The wind carries them along by the drag on the difference between its velocity and theirs. Small ones have more surface for their mass, so that they follow the wind sooner, and rise more slowly.',
  duration: 60,
  parameters: {
    wind: { label: 'Wind', unit: 'px/s', initial: 40, min: -60, max: 60 },
    count: { label: 'Bubbles', initial: 10, min: 1, max: 100, integer: true },
  },
  presets: [{ label: 'Still air', values: { wind: 0 } }],
  build({ wind, count }, { seed, ...options }): Run {
    const gravity = { y: 10 };
    const forces = [uniformGravity(gravity), buoyancy({ density: 1, gravity }), quadraticDrag({ x: wind })];
    const world = createPhysicsWorld({ capacity: 110, forces, ...options });
    const random = createRandom(seed);
    const appearance = rgba(0.4, 0.9, 1, 0.45);
    for (let i = 0; i < count; i++) {
      const position = { x: random.uniform(50, 350), y: random.uniform(330, 480) };
      spawn(world, {
        position,
        velocity: { x: random.uniform(-10, 10) },
        appearance,
        ...bubble(random.uniform(5, 25)),
      });
    }
    const measured = RADII.map((r, i) =>
      spawn(world, { position: { x: 60 + 60 * i, y: 460 }, appearance: rgba(1, 0.85, 0.4, 0.8), ...bubble(r) }),
    );
    return { world, dt: 1 / 60, wind, measured };
  },
  picture({ world, measured }) {
    return {
      yDown: true,
      view: { minX: 0, maxX: 800, minY: 0, maxY: 500 },
      fills: [{ shape: { minX: -3000, maxX: 4000, minY: -3000, maxY: 3000 }, color: 0x22406b }],
      trails: measured.map((body) => ({ body, length: 1200, interval: 2 })),
      arrows: measured.map((body) => velocityArrow(world, body, 1)),
    };
  },
  plots: (plot) => [
    plot(
      'Speed along the wind',
      'v, px/s',
      ...RADII.map((r, i) => ({
        label: `radius ${r}`,
        value: ({ world, measured }: Run) => velocityOf(world, measured[i]).x,
      })),
    ),
    plot(
      'Speed upwards',
      'v, px/s',
      ...RADII.map((r, i) => ({
        label: `radius ${r}`,
        value: ({ world, measured }: Run) => -velocityOf(world, measured[i]).y,
      })),
    ),
  ],
  checks: ({ at }) => [
    at(
      0.5,
      'Upward acceleration at first, g (1/0.99 − 1)',
      { exact: RISE, unit: 'px/s²', relative: 0.01 },
      ({ world, measured }) => -velocityOf(world, measured[2]).y / world.time,
    ),
    at(
      20,
      'What the wind is ahead of the bubble of radius 5 after 20 s, w/(1 + k w t/m)',
      { exact: ({ wind }) => wind / (1 + (0.0075 / 5) * Math.abs(wind) * 20), unit: 'px/s', relative: 0.01 },
      ({ world, wind, measured }) => wind - velocityOf(world, measured[0]).x,
    ),
    ...RADII.map((r, i) =>
      at(
        60,
        `Speed of the bubble of radius ${r} after 60 s of still air; the limit is ${LIMITS[i]}`,
        { exact: rising(LIMITS[i], 60), unit: 'px/s', relative: 0.01, preset: 'Still air' },
        ({ world, measured }: Run) => -velocityOf(world, measured[i]).y,
      ),
    ),
  ],
  tryThis: [
    'Choose “Still air”: the large bubbles overtake the small ones.',
    'In a wind they rise more slowly at first than in still air: drag acts against the whole velocity, and so upwards as well.',
  ],
});
