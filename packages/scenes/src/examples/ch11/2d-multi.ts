import {
  createPhysicsWorld,
  createRandom,
  destroyWorld,
  energy,
  momentum,
  particleContacts,
  rgba,
  spawn,
  step,
} from '@principia/physics';
import { defineExample } from '../define-example.ts';
import type { Point } from '../picture.ts';
import { distanceBetween, lengthOf, speedOf, velocityOf } from '../support/read.ts';

const CENTRE = { x: 400, y: 300 };
const MAX_COUNT = 60;

interface Throw {
  readonly position: Point;
  readonly velocity: Point;
}

/** Velocities after ten seconds of the same balls, which were spawned in reverse order. */
function velocitiesReversed(throws: readonly Throw[], collider: { radius: number }): Point[] {
  const world = createPhysicsWorld({ preset: particleContacts, capacity: MAX_COUNT + 8 });
  const ids = throws.map((_, i) => spawn(world, { ...throws[throws.length - 1 - i], mass: 1, collider })).reverse();
  for (let i = 0; i < 600; i++) step(world, 1 / 60);
  const velocities = ids.map((id) => velocityOf(world, id));
  destroyWorld(world);
  return velocities;
}

export default defineExample({
  id: 'ch11-2d-multi',
  title: 'All meet in the middle',
  chapter: 11,
  tags: ['collision', 'momentum', 'energy'],
  about:
    'Nine balls start at random places, each with the velocity that would bring it to the middle after five seconds. They arrive all at once, and hit each other in one great tangle. However complicated that is, the sum of the momenta and the sum of the energies come out of it unchanged.',
  duration: 12,
  parameters: {
    count: { label: 'Balls', initial: 9, min: 2, max: MAX_COUNT, integer: true },
    radius: { label: 'Radius', unit: 'px', initial: 15, min: 4, max: 20 },
    restitution: { label: 'Restitution e', initial: 1, min: 0, max: 1 },
  },
  presets: [{ label: 'Sticky balls', values: { restitution: 0 } }],
  build({ count, radius, restitution }, { seed, ...options }) {
    const world = createPhysicsWorld({ preset: particleContacts, capacity: MAX_COUNT + 8, ...options });
    const random = createRandom(seed);
    const throws = Array.from({ length: count }, () => {
      const position = { x: random.uniform(0, 800), y: random.uniform(0, 600) };
      return { position, velocity: { x: 0.2 * (CENTRE.x - position.x), y: 0.2 * (CENTRE.y - position.y) } };
    });
    const [collider, appearance] = [{ radius, restitution }, rgba(0.4, 0.65, 1)];
    const ids = throws.map((each) => spawn(world, { ...each, mass: 1, collider, appearance }));
    /** Largest difference to the same balls in another order, by the mean speed. */
    const disorder = () => {
      const others = velocitiesReversed(throws, collider);
      const mean = ids.reduce((sum, id) => sum + speedOf(world, id), 0) / ids.length;
      return Math.max(...ids.map((id, i) => distanceBetween(velocityOf(world, id), others[i]))) / mean;
    };
    const before = { momentum: momentum(world), energy: energy(world).kinetic };
    const drift = () => {
      const { x, y } = momentum(world);
      return lengthOf({ x: x - before.momentum.x, y: y - before.momentum.y });
    };
    return { world, dt: 1 / 60, ids, disorder, drift, share: () => energy(world).kinetic / before.energy };
  },
  picture({ ids }) {
    return {
      yDown: true,
      view: { minX: -20, maxX: 820, minY: -20, maxY: 620 },
      dots: [{ at: CENTRE, radius: 3 }],
      trails: ids.map((body) => ({ body, length: 400 })),
    };
  },
  plots: (plot) => [
    plot('Share of the energy', 'of the start', { label: 'all balls', value: ({ share }) => share() }),
    plot(
      'Momentum of all',
      'p, kg px/s',
      { label: 'along x', value: ({ world }) => momentum(world).x },
      { label: 'along y', value: ({ world }) => momentum(world).y },
    ),
  ],
  checks: ({ at, largest }) => [
    largest(10, 'Largest change of the momentum', { exact: 0, unit: 'kg px/s', absolute: 1e-10 }, ({ drift }) =>
      drift(),
    ),
    at(10, 'Energy at the end, as a fraction of that at the start', { exact: 1, relative: 1e-10 }, ({ share }) =>
      share(),
    ),
    at(
      10,
      'Largest difference of a velocity if the balls are counted from the last to the first, by the mean speed',
      { exact: 0, absolute: 0.01 },
      ({ disorder }) => disorder(),
    ),
    at(
      10,
      'Change of the momentum of sticky balls',
      { exact: 0, unit: 'kg px/s', absolute: 1e-10, preset: 'Sticky balls' },
      ({ drift }) => drift(),
    ),
  ],
  tryThis: [
    'Choose “Sticky balls”: most of the energy is lost in the middle, and of the momentum nothing.',
    'Take sixty small balls: the outer ones are met by those that come back.',
  ],
});
