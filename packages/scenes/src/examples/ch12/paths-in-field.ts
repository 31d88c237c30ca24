import { createPhysicsWorld, createRandom, powerLaw, rgba } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { createFlights, drawDiscs } from '../support/flights.ts';

const STAGE = { minX: 0, maxX: 800, minY: 0, maxY: 600 };
const RADIUS = 20;

export default defineExample({
  id: 'ch12-paths-in-field',
  title: 'Paths that draw a field',
  chapter: 12,
  tags: ['gravity', 'particles', 'field'],
  about:
    'Twenty slow bodies move in the field of five attractors, and leave their paths behind. Inside an attractor no force acts, so that a path is straight there. Together the paths show the field: they bend towards every attractor, and hardest near it.',
  duration: 40,
  parameters: {
    count: { label: 'Bodies', initial: 20, min: 1, max: 60, integer: true },
    pull: { label: 'Pull of an attractor, GM', unit: 'px³/s²', initial: 1e5, min: 0, max: 5e5 },
    speed: { label: 'Largest speed at the start', unit: 'px/s', initial: 25, min: 0, max: 100 },
  },
  presets: [{ label: 'No field', values: { pull: 0 } }],
  build({ count, pull, speed }, { seed, ...options }) {
    const stage = { minX: 100, maxX: 700, minY: 80, maxY: 520 };
    const discs = drawDiscs(createRandom(seed), 5, stage, [RADIUS, RADIUS], () => -pull);
    const forces = discs.map(({ x, y }) =>
      powerLaw({ strength: -pull, exponent: -2, innerRadius: RADIUS, centre: { x, y } }),
    );
    const world = createPhysicsWorld({ capacity: 80, forces, ...options });
    const bodies = Array.from({ length: count }, () => ({ collider: 4, appearance: rgba(0.9, 0.92, 1) }));
    const flights = createFlights(world, { seed, stage: STAGE, discs, speed, bodies, passes: true });
    return { world, dt: 1 / 120, discs, flights };
  },
  picture({ discs, flights }) {
    return {
      yDown: true,
      view: STAGE,
      fills: discs.map(({ x, y, radius }) => ({ shape: { centre: { x, y }, radius }, color: 0x4a5fb0 })),
      trails: flights.ids.map((body) => ({ body, length: 1500, interval: 3, color: 0xb8c2e8 })),
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
      40,
      'Largest error of the energy of a flight, before it enters an attractor',
      { exact: 0, absolute: 1e-3 },
      ({ flights }) => flights.worst(),
    ),
  ],
  tryThis: [
    'Choose “No field”: all paths are straight lines.',
    'Double the pull: the paths curl more tightly around the attractors.',
  ],
});
