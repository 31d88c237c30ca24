import { bodies, createRandom, destroyWorld, type Integrator, spawn, step, velocityVerlet } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import type { Point } from '../picture.ts';
import { distanceBetween, positionOf, velocityOf } from '../support/read.ts';
import { comeBack, GROUND, RADIUS, randomLaunch, STAGE, STAGE_VIEW, stageWorld } from '../support/stage.ts';

const START = { x: 50, y: 75 };
const FALL = STAGE.maxY - RADIUS - START.y;

/** Where a ball is after 16 s that was thrown alone. */
function placeAlone(velocity: Point, gravity: number, restitution: number, integrator: Integrator): Point {
  const world = stageWorld(gravity, { integrator });
  const ball = spawn(world, { position: START, velocity, mass: 1, collider: { radius: RADIUS, restitution } });
  comeBack(world, [ball]);
  for (let i = 0; i < 16 * 60; i++) step(world, 1 / 60);
  const place = positionOf(world, ball);
  destroyWorld(world);
  return place;
}

export default defineExample({
  id: 'ch02-bouncing-balls',
  title: 'Five bouncing balls',
  chapter: 2,
  tags: ['bounce', 'random numbers', 'energy'],
  about:
    'Five balls start at the same place with random velocities, and pass through each other: each moves as if it were alone. Every bounce leaves 80 % of the speed at which a ball hits the floor, and so 64 % of the energy of its motion up and down; the motion to the right goes on unchanged.',
  duration: 16,
  parameters: {
    balls: { label: 'Number of balls', initial: 5, min: 1, max: 50, integer: true },
    gravity: { label: 'Gravity', unit: 'px/s²', initial: 360, min: 60, max: 900 },
    restitution: { label: 'Speed kept in a bounce', initial: 0.8, min: 0, max: 0.95 },
  },
  build(
    { balls, gravity, restitution }: ValuesOf<'balls' | 'gravity' | 'restitution'>,
    { seed, integrator = velocityVerlet }: BuildOptions,
  ) {
    const world = stageWorld(gravity, { seed, integrator });
    const random = createRandom(seed);
    const collider = { radius: RADIUS, restitution };
    const launches = Array.from({ length: balls }, () => randomLaunch(random));
    const ids = launches.map((velocity) => spawn(world, { position: START, velocity, mass: 1, collider }));
    comeBack(world, ids);
    // Energy per mass of the motion up and down, of all balls.
    const verticalEnergy = () =>
      ids.reduce((sum, id) => {
        const { y } = velocityOf(world, id);
        return sum + (y * y) / 2 + gravity * (STAGE.maxY - RADIUS - positionOf(world, id).y);
      }, 0);
    const [{ y: vy }] = launches;
    const firstContact = (Math.sqrt(vy * vy + 2 * gravity * FALL) - vy) / gravity;
    const apart = () =>
      Math.max(
        ...ids.map((id, i) =>
          distanceBetween(positionOf(world, id), placeAlone(launches[i], gravity, restitution, integrator)),
        ),
      );
    return { world, dt: 1 / 60, ids, apart, verticalEnergy, start: verticalEnergy(), firstContact };
  },
  picture: ({ ids }) => ({
    yDown: true,
    view: STAGE_VIEW,
    fills: [GROUND],
    trails: ids.map((body) => ({ body, length: 90 })),
  }),
  plots: (plot) => [
    plot('Energy of the motion up and down', 'share of the start, %', {
      label: 'all balls',
      value: ({ verticalEnergy, start }) => (100 * verticalEnergy()) / start,
    }),
  ],
  checks: ({ at }) => [
    at(
      16,
      'Number of balls after 16 s',
      { exact: ({ balls }) => balls, absolute: 0 },
      ({ world }) => bodies(world).count,
    ),
    at(
      16,
      'Largest distance from a ball thrown alone, after 16 s',
      { exact: 0, unit: 'px', absolute: 0 },
      ({ apart }) => apart(),
    ),
    {
      label: 'First ball: time of the bounce, less (√(v² + 2 g h) − v)/g',
      unit: 's',
      exact: 0,
      tolerance: { absolute: 1 / 60 },
      at: { event: ({ world, ids }) => (velocityOf(world, ids[0]).y < 0 && world.time > 1 ? 1 : -1) },
      measure: ({ world, firstContact }) => world.time - firstContact,
    },
    // The five first bounces are over after 2.2 s at the latest, and none of the second has come by 3 s.
    at(
      3,
      'Energy after one bounce each, e²',
      { exact: 0.64, relative: 1e-9 },
      ({ verticalEnergy, start }) => verticalEnergy() / start,
    ),
  ],
  tryThis: [
    'Make it fifty balls: they form a cloud, whose last bounces are over within 15 seconds.',
    'Keep more of the speed: the staircase of the energy falls more slowly.',
  ],
});
