import { createPhysicsWorld, createRandom, log, powerLaw, rgba, rungeKutta4, spawn } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { distanceBetween, positionOf, speedOf } from '../support/read.ts';

/** Laws k rⁿ of three attractors, which act outside a radius of 20 px. */
const LAWS = [
  { at: { x: 200, y: 500 }, exponent: -1, strength: -1000, color: rgba(1, 0.4, 0.4), name: '1/r' },
  { at: { x: 500, y: 100 }, exponent: -2, strength: -1e5, color: rgba(0.4, 0.9, 0.5), name: '1/r²' },
  { at: { x: 600, y: 300 }, exponent: -3, strength: -1e7, color: rgba(0.4, 0.6, 1), name: '1/r³' },
] as const;
const RADIUS = 20;
const MAX_COUNT = 200;

export default defineExample({
  id: 'ch10-mixed-force-laws',
  title: 'Three attractors with three laws',
  chapter: 10,
  tags: ['central force', 'energy', 'random'],
  about:
    'The red centre pulls as 1/r, the green one as 1/r², the blue one as 1/r³. The steeper the law, the shorter its reach, and the more violent its grip nearby. While the red centre moves it does work on the bodies, so that their energy is not kept; with all at rest it is.',
  duration: 30,
  parameters: {
    moving: { label: 'Speed of the red centre', unit: '×', initial: 1, min: 0, max: 3 },
    count: { label: 'Bodies', initial: 50, min: 0, max: MAX_COUNT, integer: true },
  },
  presets: [{ label: 'All centres at rest', values: { moving: 0 } }],
  build({ moving, count }, { seed, integrator = rungeKutta4 }) {
    const velocity = { x: 10 * moving, y: -10 * moving };
    const forces = LAWS.map(({ at, exponent, strength }, i) =>
      powerLaw({
        strength,
        exponent,
        innerRadius: RADIUS,
        centre: at,
        ...(i === 0 && moving > 0 ? { centreVelocity: velocity } : {}),
      }),
    );
    const world = createPhysicsWorld({ capacity: MAX_COUNT + 8, forces, integrator });
    const centres = LAWS.map(({ at, color }, i) =>
      spawn(world, { position: at, velocity: i === 0 ? velocity : {}, appearance: { size: RADIUS, color } }),
    );
    const random = createRandom(seed);
    for (let i = 0; i < count; i++) {
      const position = { x: random.uniform(0, 800), y: random.uniform(0, 600) };
      const start = { x: random.uniform(-50, 50), y: random.uniform(-50, 50) };
      spawn(world, { position, velocity: start, mass: 1, appearance: { size: 4, color: rgba(0.85, 0.88, 1) } });
    }
    const appearance = { size: 7, color: rgba(1, 0.8, 0.35) };
    const probe = spawn(world, { position: { x: 300, y: 300 }, velocity: { x: 10, y: 20 }, mass: 1, appearance });
    /** ½v² + 1000 ln r₁ − 10⁵/r₂ − 5·10⁶/r₃² of the probe. */
    const value = () => {
      const [speed, r] = [speedOf(world, probe), LAWS.map(({ at }) => distanceBetween(positionOf(world, probe), at))];
      return (speed * speed) / 2 + 1000 * log(r[0]) - 1e5 / r[1] - 5e6 / (r[2] * r[2]);
    };
    return { world, dt: 1 / 240, centres, probe, value };
  },
  picture({ world, centres, probe }) {
    return {
      yDown: true,
      view: { minX: 0, maxX: 800, minY: 0, maxY: 600 },
      trails: [{ body: probe, length: 1500, interval: 4 }],
      labels: centres.map((id, i) => ({
        at: () => ({ x: positionOf(world, id).x - 12, y: positionOf(world, id).y - 30 }),
        text: LAWS[i].name,
      })),
    };
  },
  plots: (plot) => [
    plot('Energy of the yellow body, as if all centres were at rest', 'energy, kg px²/s²', {
      label: 'energy',
      value: ({ value }) => value(),
    }),
  ],
  checks: ({ at }) => [
    at(
      10,
      'Red centre after 10 s, x',
      { exact: ({ moving }) => 200 + 100 * moving, unit: 'px', absolute: 1e-9 },
      ({ world, centres }) => positionOf(world, centres[0]).x,
    ),
    at(
      4,
      'Energy of the yellow body after 4 s, the centres at rest',
      {
        exact: 250 + 1000 * log(Math.sqrt(50_000)) - 1e5 / Math.sqrt(80_000) - 5e6 / 90_000,
        unit: 'kg px²/s²',
        relative: 1e-6,
        preset: 'All centres at rest',
      },
      ({ value }) => value(),
    ),
  ],
  tryThis: [
    'Choose “All centres at rest”: the plot is a straight line as long as the body stays outside the discs.',
    'Follow a body near the blue centre: it is caught in a spiral or thrown out, hardly ever kept on an orbit.',
  ],
});
