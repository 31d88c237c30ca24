import {
  createPhysicsWorld,
  createRandom,
  exp,
  linearDrag,
  randomDrive,
  rgba,
  semiImplicitEuler,
  spawn,
} from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';

type Values = ValuesOf<'count' | 'temperature' | 'drag'>;

/** Mass of a grain, kg. */
const MASS = 1;
const COUNT = 2000;

/** ⟨x²⟩ after a time: 2 D (t − τ (1 − e^(−t/τ))) with D = kT/γ and τ = m/γ (Ornstein and Fürth 1930). */
function spreadSquare(t: number, { temperature, drag }: Values): number {
  const relaxation = MASS / drag;
  return 2 * (temperature / drag) * (t - relaxation * (1 - exp(-t / relaxation)));
}

export default defineExample({
  id: 'ch17-diffusion',
  title: 'A drop of ink spreads',
  chapter: 17,
  tags: ['diffusion', 'random', 'temperature', 'drag', 'statistics'],
  about:
    'Two thousand grains of ink start at one point. Water brakes each, and kicks it at random, just so strongly that it keeps its temperature. No grain knows where to go, yet together they spread by a law: the mean of the square of the distance grows as the time, ⟨r²⟩ = 4 D t, with Einstein’s D = kT/γ of 1905.',
  duration: 40,
  parameters: {
    count: { label: 'Grains', initial: COUNT, min: 10, max: 20_000, integer: true },
    temperature: { label: 'Temperature kT', unit: 'J', initial: 1, min: 0.1, max: 4 },
    drag: { label: 'Drag γ', unit: 'kg/s', initial: 1, min: 0.5, max: 4 },
  },
  presets: [{ label: 'Hot water', values: { temperature: 4 } }],
  build({ count, temperature, drag }: Values, { seed, integrator = semiImplicitEuler }: BuildOptions) {
    const drive = randomDrive({ spectralDensity: 2 * drag * temperature, seed });
    const world = createPhysicsWorld({ capacity: 20_010, forces: [linearDrag(), drive], integrator });
    const random = createRandom(seed);
    const thermal = () => random.gaussian(0, Math.sqrt(temperature / MASS));
    const grains = Array.from({ length: count }, (_, i) =>
      spawn(world, {
        position: {},
        velocity: { x: thermal(), y: thermal() },
        mass: MASS,
        linearDrag: drag,
        appearance: { size: i === 0 ? 0.25 : 0.1, color: i === 0 ? rgba(1, 0.88, 0.54) : rgba(0.43, 0.72, 1, 0.7) },
      }),
    );
    const { x, y } = world.components.Position;
    const meanSquare = () => grains.reduce((sum, id) => sum + x[id] * x[id] + y[id] * y[id], 0) / count;
    return { world, dt: 1 / 60, grains, meanSquare };
  },
  picture({ grains }) {
    return {
      view: { minX: -22, maxX: 22, minY: -20, maxY: 20 },
      trails: [{ body: grains[0], length: 2400, color: COLORS.yellow }],
    };
  },
  plots: (plot) => [
    plot('Mean square of the distance', '⟨r²⟩, m²', {
      label: 'grains',
      value: ({ meanSquare }) => meanSquare(),
      exact: (t, values: Values) => 2 * spreadSquare(t, values),
    }),
  ],
  histograms: [
    {
      title: 'How far to the right',
      x: { label: 'x, m', min: -20, max: 20 },
      intervals: 40,
      samples: ({ world, grains }) => grains.map((id) => world.components.Position.x[id]),
      exact: (x, t, values: Values) => {
        const square = spreadSquare(Math.max(t, 0.1), values);
        return exp((-x * x) / (2 * square)) / Math.sqrt(2 * Math.PI * square);
      },
    },
  ],
  checks: ([10, 40] as const).map((time) => ({
    label: `Mean square of the distance after ${time} s`,
    unit: 'm²',
    exact: 2 * spreadSquare(time, { count: COUNT, temperature: 1, drag: 1 }),
    // r² of a normal distribution in the plane is exponential, so the mean of n has a relative error of 1/√n: three of them.
    tolerance: { relative: 3 / Math.sqrt(COUNT) },
    at: { time },
    measure: ({ meanSquare }: { meanSquare: () => number }) => meanSquare(),
  })),
  tryThis: [
    'Follow the yellow grain: after four times the time it is only twice as far away.',
    'Double the drag: the ink spreads half as fast. By this law Perrin counted the molecules of water in 1908.',
  ],
});
