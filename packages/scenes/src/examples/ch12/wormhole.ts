import { attractors, createPhysicsWorld, createRandom, keepState, rgba, spawn } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { distanceBetween, positionOf, speedOf } from '../support/read.ts';

const [HOLE, EXIT] = [
  { x: 400, y: 400 },
  { x: 400, y: 100 },
];
const [RADIUS, GM] = [20, 1e5];
/** From rest at 300 px to the rim at 20 px, s and px/s. */
const [FALL_TIME, FALL_SPEED] = [18.115, 96.609];

export default defineExample({
  id: 'ch12-wormhole',
  title: 'A wormhole',
  chapter: 12,
  tags: ['gravity', 'particles', 'energy'],
  about:
    'Stars fall into the black hole below and come out of the white one above, larger, slow and as if nothing had happened. So they go round for ever, and none is lost. On the way down each keeps its energy: what it loses in height it gains in speed.',
  duration: 30,
  parameters: {
    count: { label: 'Stars', initial: 1000, min: 1, max: 3000, integer: true },
    mass: { label: 'Pull of the hole, GM', unit: 'px³/s²', initial: GM, min: 1e4, max: 1e6, scale: 'log' },
  },
  presets: [{ label: 'A heavy hole', values: { mass: 1e6 } }],
  build({ count, mass }, { seed, ...options }) {
    const world = createPhysicsWorld({ capacity: 3100, forces: [attractors()], ...options });
    spawn(world, { position: HOLE, attractor: mass, appearance: { size: RADIUS, color: rgba(0, 0, 0) } });
    const random = createRandom(seed);
    const start = () => ({ x: random.uniform(-25, 25), y: random.uniform(0, 10) });
    const stars = Array.from({ length: count }, () => {
      const position = { x: random.uniform(0, 800), y: random.uniform(0, 600) };
      const appearance = { size: 2, color: rgba(1, 0.95, 0.5) };
      return spawn(world, { position, velocity: start(), mass: 1, appearance });
    });
    // The first star is let go at rest at the exit, and measured until it is swallowed.
    const first = spawn(world, {
      position: EXIT,
      velocity: {},
      mass: 1,
      appearance: { size: 6, color: rgba(0.4, 0.9, 1) },
    });
    const { Position: p, Velocity: v, Appearance } = world.components;
    const state = { passed: 0, worst: 0 };
    const energies = new Float64Array(count);
    const energyOf = (id: number) => {
      const speed = speedOf(world, id);
      return (speed * speed) / 2 - mass / distanceBetween(positionOf(world, id), HOLE);
    };
    stars.forEach((id, i) => {
      energies[i] = energyOf(id);
    });
    keepState(world, random.state, state, energies);
    const distance = (id: number) => distanceBetween(positionOf(world, id), HOLE);
    const swallow = (id: number, i: number) => {
      const error = Math.abs(energyOf(id) - energies[i]) / (mass / RADIUS);
      state.worst = Math.max(state.worst, error);
      const velocity = start();
      [p.x[id], p.y[id], v.x[id], v.y[id]] = [EXIT.x, EXIT.y, velocity.x, velocity.y];
      Appearance.size[id] = Math.min(6, 1.5 * Appearance.size[id]);
      energies[i] = energyOf(id);
      state.passed++;
    };
    world.phases.input.push(() => {
      for (const [i, id] of stars.entries()) if (distance(id) < RADIUS) swallow(id, i);
      world.versions.pose++;
    });
    return { world, dt: 1 / 240, stars, first, state, distance };
  },
  picture() {
    return {
      yDown: true,
      view: { minX: 0, maxX: 800, minY: 0, maxY: 620 },
      fills: [
        { shape: { minX: -3000, maxX: 4000, minY: -3000, maxY: 4000 }, color: 0x05070f },
        { shape: { centre: HOLE, radius: 30 }, color: 0xb79cff, opacity: 0.5 },
        { shape: { centre: EXIT, radius: 12 }, color: 0xffffff, opacity: 0.8 },
      ],
    };
  },
  plots: (plot) => [
    plot('Stars that went through', 'number', { label: 'passed', value: ({ state }) => state.passed }),
    plot('Speed of the blue star', 'v, px/s', { label: 'star', value: ({ world, first }) => speedOf(world, first) }),
  ],
  checks: ({ at }) => [
    {
      label: 'Time of the fall from rest, 300 px to 20 px',
      unit: 's',
      exact: FALL_TIME,
      tolerance: { relative: 1e-3 },
      at: { event: ({ first, distance }) => RADIUS - distance(first) },
    },
    {
      label: 'Speed at the rim, √(2GM (1/20 − 1/300))',
      unit: 'px/s',
      exact: FALL_SPEED,
      tolerance: { relative: 1e-3 },
      at: { event: ({ first, distance }) => RADIUS - distance(first) },
      measure: ({ world, first }) => speedOf(world, first),
    },
    at(
      20,
      'Largest error of the energy of a flight, of GM/r at the rim',
      { exact: 0, absolute: 1e-3 },
      ({ state }) => state.worst,
    ),
    at(
      20,
      'Stars after 20 s',
      { exact: ({ count }) => count, absolute: 0 },
      ({ world, stars }) => stars.filter((id) => world.components.Mass.value[id] === 1).length,
    ),
  ],
  tryThis: [
    'Wait: in the end nearly all stars are on narrow loops from the exit to the hole.',
    'Choose “A heavy hole”: the stars fall about three times faster.',
  ],
});
