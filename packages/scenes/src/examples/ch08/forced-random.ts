import {
  createPhysicsWorld,
  createRandom,
  exp,
  linearDrag,
  periodicDrive,
  powerLaw,
  randomDrive,
  rgba,
  spawn,
} from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { positionOf } from '../support/read.ts';

const [STIFFNESS, DAMPING] = [10, 0.5];
const COUNT = 2000;
const TIME = 20;
/** A force within ±500 N that changes 60 times a second has this power, N² s. */
const DENSITY = 1e6 / 12 / 60;

export default defineExample({
  id: 'ch08-forced-random',
  title: 'Pushed by chance',
  chapter: 8,
  tags: ['spring', 'oscillation', 'random', 'noise'],
  about:
    'Two thousand balls on springs of their own are pushed to the left and to the right by chance. Each one trembles in its own way, but together they obey a law: the root mean square of the displacement is √(S/2kc), whatever the length of the steps. Dust in air moves like that.',
  duration: TIME,
  parameters: {
    noise: { label: 'Power of the noise S', unit: 'N² s', initial: DENSITY, min: 0, max: 6000 },
    push: { label: 'Steady push to the right', unit: 'N', initial: 0, min: 0, max: 1000 },
  },
  presets: [{ label: 'Pushed to one side', values: { push: 500 } }],
  build({ noise, push }, { seed, ...options }) {
    const steady = periodicDrive({ cosine: { x: push }, angularFrequency: 0 });
    const spring = powerLaw({ strength: -STIFFNESS, exponent: 1 });
    const forces = [spring, linearDrag(), randomDrive({ spectralDensity: { x: noise } }), steady];
    const world = createPhysicsWorld({ capacity: COUNT + 2, seed, forces, ...options });
    const random = createRandom(seed, 1);
    // The spring acts along x only, because all balls are on the line y = 0; they are drawn apart.
    const appearance = rgba(0.45, 0.75, 1, 0.7);
    const balls = Array.from({ length: COUNT }, () =>
      spawn(world, { position: { x: push / STIFFNESS }, mass: 1, linearDrag: DAMPING, appearance }),
    );
    const rows = balls.map(() => random.uniform(-30, 30));
    const { x } = world.components.Position;
    const mean = () => balls.reduce((sum, ball) => sum + x[ball], 0) / COUNT;
    const rms = () => {
      const centre = push / STIFFNESS;
      return Math.sqrt(balls.reduce((sum, ball) => sum + (x[ball] - centre) * (x[ball] - centre), 0) / COUNT);
    };
    return { world, dt: 1 / 60, balls, rows, mean, rms };
  },
  picture({ world, balls, rows, rms }, { push }) {
    const centre = push / STIFFNESS;
    const bound = (sign: number, y: number) => () => ({ x: centre + sign * rms(), y });
    return {
      view: { minX: -60, maxX: 110, minY: -40, maxY: 40 },
      dots: balls.slice(0, 400).map((ball, i) => ({
        at: () => ({ x: positionOf(world, ball).x, y: rows[i] }),
        radius: i === 0 ? 7 : 2,
        color: i === 0 ? COLORS.orange : COLORS.blue,
      })),
      lines: [
        { from: { x: 0, y: -34 }, to: { x: 0, y: 34 }, color: COLORS.grey, width: 1 },
        { from: bound(-1, -34), to: bound(-1, 34), color: COLORS.green },
        { from: bound(1, -34), to: bound(1, 34), color: COLORS.green },
      ],
      labels: [{ at: { x: centre, y: 37 }, text: 'the green lines: root mean square', color: COLORS.green }],
    };
  },
  plots: (plot) => [
    plot('Root mean square of the displacement', 'x, px', {
      label: 'of 2000 balls',
      value: ({ rms }) => rms(),
      exact: (_, { noise }) => Math.sqrt(noise / (2 * STIFFNESS * DAMPING)),
    }),
    plot('One ball', 'x, px', { label: 'ball', value: ({ world, balls }) => positionOf(world, balls[0]).x }),
  ],
  checks: ({ at }) => [
    // Three and a half standard errors, 1/√(2 N) each; what is left of the start, e^(−c t), is far smaller.
    at(
      TIME,
      'Root mean square, √(S/2kc)',
      { exact: 11.785, unit: 'px', relative: 3.5 / Math.sqrt(2 * COUNT) + exp(-DAMPING * TIME) },
      ({ rms }) => rms(),
    ),
    at(
      TIME,
      'Mean displacement, F/k',
      { exact: 50, unit: 'px', absolute: (3.5 * 11.785) / Math.sqrt(COUNT), preset: 'Pushed to one side' },
      ({ mean }) => mean(),
    ),
  ],
  tryThis: [
    'Quadruple the power of the noise: the balls spread twice as far.',
    'Choose “Pushed to one side”: the middle of the cloud moves, its width stays.',
  ],
});
