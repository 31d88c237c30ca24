import {
  burst,
  createEmitter,
  createPhysicsWorld,
  createRandom,
  emitterCounts,
  keepState,
  rgba,
  setEmitter,
  spawn,
  uniformGravity,
} from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { positionOf } from '../support/read.ts';

const [TOP, LEVEL, HORIZON] = [100, 510, 500];
const [GRAVITY, SPEED, DROPLETS] = [20, 100, 20];

export default defineExample({
  id: 'ch12-splash',
  title: 'Drops on water',
  chapter: 12,
  tags: ['particles', 'gravity', 'energy', 'random'],
  about:
    'A drop falls on the water and throws up twenty droplets. A larger drop brings more energy: the droplets of one with twice the radius, and so eight times the mass, jump eight times as high. The droplets are used again for every splash.',
  duration: 45,
  parameters: {
    small: { label: 'Smallest drop', unit: 'px', initial: 4, min: 2, max: 8 },
    large: { label: 'Largest drop', unit: 'px', initial: 12, min: 8, max: 16 },
  },
  presets: [{ label: 'Heavy drops', values: { small: 8, large: 16 } }],
  build({ small, large }, { seed, ...options }) {
    const world = createPhysicsWorld({ capacity: 80, seed, forces: [uniformGravity({ y: GRAVITY })], ...options });
    const random = createRandom(seed);
    const appearance = { size: 8, color: rgba(0.65, 0.85, 1) };
    // Without mass it feels no gravity, and falls at a constant speed as rain does.
    const drop = spawn(world, { position: { x: 400, y: TOP }, velocity: { y: SPEED }, appearance });
    const emitter = createEmitter(world, {
      capacity: 3 * DROPLETS,
      lifetime: 3.9,
      speed: 0,
      mass: 1,
      size: 2,
      sizeFactor: [0.5, 1.5],
      color: rgba(0.8, 0.92, 1),
    });
    const splash = { count: 0, radius: 8, most: 0 };
    keepState(world, splash, random.state);
    const { Position, Appearance } = world.components;
    world.phases.input.push(() => {
      if (Position.y[drop] < LEVEL - 1e-9) return;
      const f = splashFactor(splash.radius);
      setEmitter(emitter, { velocitySpread: { x: 10 * f, y: 7.5 * f } });
      burst(emitter, DROPLETS, { position: { x: Position.x[drop], y: LEVEL }, velocity: { y: -15 * f } });
      // What this splash can reach at most, v²/2g of the fastest droplet.
      splash.most = (22.5 * f * (22.5 * f)) / (2 * GRAVITY);
      splash.count++;
      splash.radius = random.uniform(small, large);
      Position.x[drop] = random.uniform(100, 800);
      Position.y[drop] = TOP;
      Appearance.size[drop] = splash.radius;
      world.versions.pose++;
    });
    /** Height of the highest droplet, by what it can be. */
    const reach = () => {
      let top = LEVEL;
      for (let id = 1; id <= world.lastId; id++) {
        if (id !== drop && Appearance.size[id] > 0) top = Math.min(top, Position.y[id]);
      }
      return splash.most === 0 ? 0 : (LEVEL - top) / splash.most;
    };
    return { world, dt: 1 / 60, drop, emitter, splash, reach };
  },
  picture() {
    const sea = { minX: -3000, maxX: 4000, minY: HORIZON, maxY: 3000 };
    return {
      yDown: true,
      view: { minX: 0, maxX: 900, minY: 80, maxY: 600 },
      fills: [
        { shape: { ...sea, minY: -3000, maxY: HORIZON }, color: 0x1c3358 },
        { shape: sea, color: COLORS.water },
        { shape: { ...sea, minY: LEVEL + 3 }, color: COLORS.water, inFront: true },
      ],
    };
  },
  plots: (plot) => [
    plot('Height of the highest droplet', 'of what it can reach', { label: 'height', value: ({ reach }) => reach() }),
    plot('Splashes', 'number', { label: 'so far', value: ({ splash }) => splash.count }),
  ],
  checks: ({ at, largest }) => [
    {
      label: 'Time between two splashes, 410 px at 100 px/s',
      unit: 's',
      exact: 4.1,
      tolerance: { absolute: 1e-9 },
      at: { event: ({ world, drop }) => 300 - positionOf(world, drop).y, from: 1, to: 2 },
    },
    at(
      40,
      'Droplets of each splash',
      { exact: DROPLETS, absolute: 0 },
      ({ emitter, splash }) => emitterCounts(emitter).born / splash.count,
    ),
    // Of 200 speeds between 7.5 and 22.5 the largest is below 0.95 of 22.5 once in ten million times.
    largest(44, 'Highest droplet of ten splashes, by 12.66 (r/8)³ px', { exact: 1, absolute: 0.1 }, ({ reach }) =>
      reach(),
    ),
  ],
  tryThis: [
    'Compare a small drop and a large one: the splash of the small one hardly leaves the water.',
    'Choose “Heavy drops”: the droplets of the largest jump a hundred pixels high.',
  ],
});

/** Factor of the droplets’ velocities, (r/8)^1.5. */
function splashFactor(radius: number): number {
  return (radius / 8) * Math.sqrt(radius / 8);
}
