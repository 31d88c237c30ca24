import { createRandom, spawn, velocityVerlet } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { velocityArrow } from '../support/arrows.ts';
import { speedOf } from '../support/read.ts';
import { comeBack, GROUND, RADIUS, randomLaunch, STAGE_VIEW, stageWorld } from '../support/stage.ts';

const DRAWS = 10_000;

/** Mean and variance of each component of many random velocities. */
function momentsOf(seed: number) {
  const random = createRandom(seed, 1);
  const draws = Array.from({ length: DRAWS }, () => randomLaunch(random));
  const mean = (values: number[]) => values.reduce((sum, value) => sum + value, 0) / DRAWS;
  const momentsAlong = (values: number[]) => {
    const average = mean(values);
    return { mean: average, variance: mean(values.map((value) => (value - average) * (value - average))) };
  };
  return { x: momentsAlong(draws.map(({ x }) => x)), y: momentsAlong(draws.map(({ y }) => y)) };
}

/** Three standard deviations of the mean, and of the variance, of so many numbers that are uniform over a width. */
const ofMean = (width: number) => (3 * width) / Math.sqrt(12 * DRAWS);
const ofVariance = (width: number) => 3 * width * width * Math.sqrt((1 / 80 - 1 / 144) / DRAWS);

export default defineExample({
  id: 'ch02-bouncing-ball-random',
  title: 'A random launch',
  chapter: 2,
  tags: ['bounce', 'random numbers', 'statistics'],
  about:
    'The ball starts with a velocity that the computer draws by lot: up to 300 px/s to the right, and up to 120 px/s up or down. The numbers look random, but they follow from the seed: the same seed gives the same throw again. Of ten thousand draws the mean is close to the middle of the range.',
  duration: 12,
  parameters: {
    restitution: { label: 'Speed kept in a bounce', initial: 0.8, min: 0, max: 0.95 },
    balls: { label: 'Number of balls', initial: 1, min: 1, max: 30, integer: true },
  },
  presets: [{ label: 'Thirty balls at once', values: { balls: 30 } }],
  build({ restitution, balls }, { seed, integrator = velocityVerlet }) {
    const world = stageWorld(360, { seed, integrator });
    const random = createRandom(seed);
    const collider = { radius: RADIUS, restitution };
    const launches = Array.from({ length: balls }, () => randomLaunch(random));
    const ids = launches.map((velocity) => spawn(world, { position: { x: 50, y: 50 }, velocity, mass: 1, collider }));
    comeBack(world, ids);
    return { world, dt: 1 / 60, ball: ids[0], ids, moments: momentsOf(seed) };
  },
  picture: ({ world, ball, ids }) => ({
    yDown: true,
    view: STAGE_VIEW,
    fills: [GROUND],
    trails: ids.map((body) => ({ body, length: 120 })),
    arrows: [velocityArrow(world, ball, 0.3)],
  }),
  plots: (plot) => [
    plot('Speed of the first ball', 'speed, px/s', {
      label: 'speed',
      value: ({ world, ball }) => speedOf(world, ball),
    }),
  ],
  checks: ({ at }) => [
    at(
      0,
      'Mean velocity to the right of 10 000 draws',
      { exact: 150, unit: 'px/s', absolute: ofMean(300) },
      ({ moments }) => moments.x.mean,
    ),
    at(
      0,
      'Its variance, 300²/12',
      { exact: 7500, unit: 'px²/s²', absolute: ofVariance(300) },
      ({ moments }) => moments.x.variance,
    ),
    at(
      0,
      'Mean velocity downwards',
      { exact: 0, unit: 'px/s', absolute: ofMean(240) },
      ({ moments }) => moments.y.mean,
    ),
    at(
      0,
      'Its variance, 240²/12',
      { exact: 4800, unit: 'px²/s²', absolute: ofVariance(240) },
      ({ moments }) => moments.y.variance,
    ),
  ],
  tryThis: [
    'Start again with another seed: another throw. With the old seed the old throw comes back.',
    'Launch thirty balls: they spread out, but all of them slide along the floor in the end.',
  ],
});
