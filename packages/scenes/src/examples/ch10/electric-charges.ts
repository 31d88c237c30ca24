import { createPhysicsWorld, createRandom, fixedCharges, rgba, rungeKutta4, spawn } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { createFlights } from '../support/flights.ts';
import { distanceBetween, positionOf } from '../support/read.ts';

const STAGE = { minX: 0, maxX: 700, minY: 0, maxY: 500 };
const STRAIGHT = { at: { x: 20, y: 20 }, velocity: { x: 8, y: 5 } };

export default defineExample({
  id: 'ch10-electric-charges',
  title: 'Flights among charges',
  chapter: 10,
  tags: ['charges', 'Coulomb', 'energy', 'random'],
  about:
    'Blue charges push the three coloured bodies away, red ones pull them in. The force falls with the square of the distance, as gravity does, but it can do both. The white body has no charge: it feels nothing and flies straight on.',
  duration: 60,
  parameters: {
    count: { label: 'Charges', initial: 20, min: 1, max: 40, integer: true },
    charge: { label: 'Largest charge', unit: 'C', initial: 5e5, min: 0, max: 1e6 },
    speed: { label: 'Largest speed at the start', unit: 'px/s', initial: 50, min: 0, max: 200 },
  },
  presets: [
    { label: 'Two charges', values: { count: 2 } },
    { label: 'Fast', values: { speed: 200 } },
  ],
  build({ count, charge, speed }, { seed, integrator = rungeKutta4 }) {
    const world = createPhysicsWorld({ capacity: 60, forces: [fixedCharges(1)], integrator });
    const random = createRandom(seed);
    const discs = Array.from({ length: count }, () => {
      const radius = random.uniform(10, 30);
      const strength = random.uniform(-charge, charge);
      return { x: random.uniform(0, 700), y: random.uniform(0, 500), radius, strength };
    });
    for (const { x, y, radius, strength } of discs) {
      const appearance = strength < 0 ? rgba(0.95, 0.3, 0.3) : rgba(0.3, 0.45, 1);
      spawn(world, { position: { x, y }, charge: strength, collider: radius, appearance });
    }
    const colors = [rgba(1, 0.8, 0.35), rgba(0.5, 0.95, 0.6), rgba(0.9, 0.6, 1)];
    const bodies = colors.map((appearance) => ({ charge: 1, collider: 5, appearance }));
    const flights = createFlights(world, { seed, stage: STAGE, discs, speed, bodies });
    const body = { position: STRAIGHT.at, velocity: STRAIGHT.velocity, mass: 1, collider: 5 };
    const neutral = spawn(world, { ...body, appearance: rgba(1, 1, 1) });
    return { world, dt: 1 / 240, flights, neutral };
  },
  picture({ flights, neutral }) {
    return {
      yDown: true,
      view: STAGE,
      trails: [...flights.ids, neutral].map((body) => ({ body, length: 1500, interval: 4 })),
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
    at(60, 'Largest error of the energy of a flight', { exact: 0, absolute: 5e-3 }, ({ flights }) => flights.worst()),
    // Each of 14400 steps rounds a coordinate of up to 512 by half a unit of its last place, 5.7e-14.
    at(
      60,
      'How far the body without charge strays from its straight line',
      { exact: 0, unit: 'px', absolute: 1e-9 },
      ({ world, neutral }) => {
        const { at, velocity } = STRAIGHT;
        const line = { x: at.x + velocity.x * world.time, y: at.y + velocity.y * world.time };
        return distanceBetween(positionOf(world, neutral), line);
      },
    ),
  ],
  tryThis: [
    'Choose “Fast”: the paths become nearly straight, because a fast body is soon past a charge.',
    'Watch a flight near a red charge: it speeds up and is flung around, or falls in.',
  ],
});
