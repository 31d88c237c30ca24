import {
  cos,
  createPhysicsWorld,
  energy,
  mutualCoulomb,
  powerLaw,
  rgba,
  sin,
  spawn,
  velocityVerlet,
} from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { positionOf } from '../support/read.ts';

type Values = ValuesOf<'count' | 'stretch' | 'shift'>;

/** Radius of the electrons at rest, m, and their angular frequency as a whole in the field of the ions, rad/s. */
const [RADIUS, WHOLE] = [5, Math.PI / 2];
const COUNT = 600;
/** The golden angle, by which places on a disc are spread evenly, rad. */
const GOLDEN = Math.PI * (3 - Math.sqrt(5));
/** Plasma frequency √2 times that of the whole: the ions' field in the plane is half of what Gauss's law gives a layer. */
const PLASMA = Math.SQRT2 * WHOLE;

export default defineExample({
  id: 'ch17-plasma',
  title: 'Electrons that breathe',
  chapter: 17,
  tags: ['electricity', 'oscillation', 'plasma', 'n-body'],
  about:
    'Electrons repel each other, and a background of ions draws them to the middle. Let go from too wide a disc they fall in, overshoot, and breathe at the plasma frequency, however many they are. Pushed aside as a whole they swing √2 times as slowly, and their own repulsion does not matter at all: action is reaction.',
  duration: 24,
  parameters: {
    count: { label: 'Electrons', initial: COUNT, min: 2, max: 1500, integer: true },
    stretch: { label: 'Radius at the start', unit: '×', initial: 1.1, min: 0.6, max: 1.6 },
    shift: { label: 'Pushed aside by', unit: 'm', initial: 0, min: 0, max: 3 },
  },
  presets: [
    { label: 'Pushed aside', values: { stretch: 1, shift: 2 } },
    { label: 'Both', values: { stretch: 1.3, shift: 2 } },
  ],
  build({ count, stretch, shift }: Values, { integrator = velocityVerlet }: BuildOptions) {
    // Charges in the plane are lines, with a field of 1/r. At the radius both forces on an electron of 1 kg are equal.
    const charge = (WHOLE * RADIUS) / Math.sqrt(count);
    const repulsion = mutualCoulomb({ k: 1, law: 'inverse-distance', method: 'direct' });
    const ions = powerLaw({ strength: -WHOLE * WHOLE, exponent: 1 });
    const world = createPhysicsWorld({ capacity: 1600, forces: [repulsion, ions], integrator });
    const electrons = Array.from({ length: count }, (_, i) => {
      const r = stretch * RADIUS * Math.sqrt((i + 0.5) / count);
      const position = { x: shift + r * cos(GOLDEN * i), y: r * sin(GOLDEN * i) };
      return spawn(world, {
        position,
        velocity: {},
        mass: 1,
        charge,
        appearance: { size: 0.07, color: rgba(0.43, 0.72, 1) },
      });
    });
    const middle = () => electrons.reduce((sum, id) => sum + positionOf(world, id).x, 0) / count;
    const off = middle() - shift;
    for (const id of electrons) world.components.Position.x[id] -= off;
    /** Radius of an even disc with the present spread about its middle. */
    const radius = () => {
      const at = middle();
      const square = electrons.reduce((sum, id) => {
        const { x, y } = positionOf(world, id);
        return sum + (x - at) * (x - at) + y * y;
      }, 0);
      return Math.sqrt((2 * square) / count);
    };
    return { world, dt: 1 / 60, middle, radius, start: energy(world).total };
  },
  picture() {
    return {
      view: { minX: -8.5, maxX: 8.5, minY: -7.5, maxY: 7.5 },
      fills: [{ shape: { centre: { x: 0, y: 0 }, radius: RADIUS }, color: COLORS.orange, opacity: 0.18 }],
    };
  },
  plots: (plot) => [
    plot('Radius', 'R, m', { label: 'electrons', value: ({ radius }) => radius() }),
    plot('Middle of the electrons', 'x, m', {
      label: 'stepped',
      value: ({ middle }) => middle(),
      exact: (t, { shift }: Values) => shift * cos(WHOLE * t),
    }),
  ],
  checks: ({ at }) => [
    {
      label: 'Period of the breathing, 2π/ω_p',
      unit: 's',
      exact: (2 * Math.PI) / PLASMA,
      // A breath of a tenth is shorter by about the square of a tenth over 12.
      tolerance: { relative: 2e-3 },
      at: { event: ({ radius }) => radius() - RADIUS, from: 1, to: 3 },
      measure: ({ world }) => world.time / 2,
    },
    {
      label: 'Period of the whole, √2 times as long',
      unit: 's',
      exact: (2 * Math.PI) / WHOLE,
      tolerance: { relative: 5e-4 },
      at: { event: ({ middle }) => middle(), from: 1, to: 3 },
      measure: ({ world }) => world.time / 2,
      preset: 'Pushed aside',
    },
    at(
      20,
      'Change of the energy in 20 s, as a fraction',
      { exact: 0, absolute: 1e-4 },
      ({ world, start }) => energy(world).total / start - 1,
    ),
  ],
  tryThis: [
    'Halve the electrons: each has more charge, and they breathe in the same time.',
    'Choose “Both”: the swing to and fro and the breathing go on, and neither disturbs the other.',
  ],
});
