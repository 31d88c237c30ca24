import { attractors, createPhysicsWorld, createRandom, rgba, spawn } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { createFlights, drawDiscs } from '../support/flights.ts';

const STAGE = { minX: 0, maxX: 700, minY: 0, maxY: 500 };

export default defineExample({
  id: 'ch10-gravity-field',
  title: 'Flights among dark suns',
  chapter: 10,
  tags: ['gravity', 'energy', 'escape speed', 'random'],
  about:
    'Ten dark suns are scattered at random. Three comets fly among them, and a new one starts wherever one falls in or leaves. Each sun is so heavy that a comet needs 300 px/s to escape from its rim: the larger the sun, the more mass. Far from the rims a flight keeps its energy to a thousandth.',
  duration: 60,
  parameters: {
    count: { label: 'Suns', initial: 10, min: 1, max: 20, integer: true },
    rim: { label: 'Escape speed at the rims', unit: 'px/s', initial: 300, min: 50, max: 400 },
    speed: { label: 'Largest speed at the start', unit: 'px/s', initial: 50, min: 0, max: 200 },
  },
  presets: [{ label: 'One sun', values: { count: 1 } }],
  build({ count, rim, speed }, { seed, ...options }) {
    const world = createPhysicsWorld({ capacity: 30, forces: [attractors()], ...options });
    const discs = drawDiscs(createRandom(seed), count, STAGE, [10, 30], (radius) => (-rim * rim * radius) / 2);
    const suns = discs.map(({ x, y, radius, strength }) =>
      spawn(world, { position: { x, y }, attractor: -strength, collider: radius, appearance: rgba(0.03, 0.03, 0.08) }),
    );
    const bodies = [rgba(1, 0.5, 0.4), rgba(0.5, 0.9, 0.6), rgba(0.45, 0.75, 1)].map((appearance) => ({
      collider: 5,
      appearance,
    }));
    const flights = createFlights(world, { seed, stage: STAGE, discs, speed, bodies, clearance: 3 });
    const { Attractor, Collider } = world.components;
    const escapes = () => suns.map((id) => Math.sqrt((2 * Attractor.mu[id]) / Collider.radius[id]));
    return { world, dt: 1 / 240, discs, flights, escapes };
  },
  picture({ discs, flights }) {
    return {
      yDown: true,
      view: STAGE,
      fills: discs.map(({ x, y, radius }) => ({
        shape: { centre: { x, y }, radius: 3 * radius },
        color: 0xb79cff,
        opacity: 0.12,
      })),
      trails: flights.ids.map((body) => ({ body, length: 1500, interval: 4 })),
    };
  },
  plots: (plot) => [
    plot('Launches', 'number', { label: 'launches', value: ({ flights }) => flights.launches() }),
    plot('Largest error of the energy of a flight', 'fraction', {
      label: 'error',
      value: ({ flights }) => flights.worst(),
    }),
  ],
  checks: ({ at }) => [
    at(
      0,
      'Largest escape speed at a rim, √(2GM/r)',
      { exact: ({ rim }) => rim, unit: 'px/s', relative: 1e-12 },
      ({ escapes }) => escapes().reduce((a, b) => Math.max(a, b)),
    ),
    at(0, 'Smallest escape speed at a rim', { exact: ({ rim }) => rim, unit: 'px/s', relative: 1e-12 }, ({ escapes }) =>
      escapes().reduce((a, b) => Math.min(a, b)),
    ),
    at(
      60,
      'Largest error of the energy of a flight, outside three radii',
      { exact: 0, absolute: 1e-3 },
      ({ flights }) => flights.worst(),
    ),
  ],
  tryThis: [
    'Choose “One sun”: most flights are long ellipses that end in it, or hyperbolas out of the picture.',
    'Set the speed at the start to zero: most comets soon end in a sun.',
  ],
});
