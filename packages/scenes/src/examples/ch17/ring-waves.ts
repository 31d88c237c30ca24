import { attractors, createPhysicsWorld, defineLaw, rgba, rungeKutta4, scalar, spawn, vec3 } from '@principia/physics';
import { relaunchOutside } from '../../edges.ts';
import { teleport } from '../../teleport.ts';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { positionOf, velocityOf } from '../support/read.ts';

type Values = ValuesOf<'moon' | 'spin'>;

/** Half the length of the piece of ring that is shown, and the rows of particles from the moon's orbit outwards, m. */
const [HALF, FIRST, ROWS, APART, PER_ROW] = [30, 3, 20, 0.3, 70];
const rowAt = (i: number) => (i < ROWS ? 1 : -1) * (FIRST + APART * (i % ROWS));
/** Distance from the moon's orbit of the particle whose wave is measured, m. */
const PROBE = 6;

/**
 * Near a point that circles with Ω, along it (x) and outwards (y): the tide 3 Ω² y and the Coriolis force. Hill (1878);
 * Murray and Dermott, Solar System Dynamics, section 3.13.
 */
const hillFrame = defineLaw({
  name: 'Hill’s frame',
  formula: 'a = 3 Ω² y ŷ − 2 Ω × v',
  source: 'Murray and Dermott, Solar System Dynamics, section 3.13.',
  parameters: { spin: scalar('rad/s') },
  acceleration: ({ position, velocity }, { spin }) =>
    vec3(velocity.y.mul(-2), velocity.x.mul(2).add(position.y.mul(spin).mul(3)), 0).mul(spin),
  potential: ({ position, mass }, { spin }) => position.y.mul(spin).square().mul(mass).mul(-1.5),
});

/** Amplitude of the wave behind a moon: (8/9) (2 K₀(2/3) + K₁(2/3)) Gm/(Ω b)² (Julian and Toomre 1966). */
const amplitudeOf = (moon: number, spin: number) => (2.2396 * moon) / (spin * PROBE * (spin * PROBE));

export default defineExample({
  id: 'ch17-ring-waves',
  title: 'A small moon makes waves in a ring',
  chapter: 17,
  tags: ['gravity', 'orbit', 'rings', 'tides'],
  about:
    'We fly along with a moon in a gap of Saturn’s rings; the planet is far below. What is nearer to the planet overtakes the moon, what is farther falls behind. Each particle gets a small pull as it passes, and from then on swings in and out: behind the moon the edges of the gap are wavy. So Daphnis and Pan were found.',
  duration: 40,
  parameters: {
    moon: { label: 'Moon’s Gm', unit: 'm³/s²', initial: 2, min: 0.1, max: 4 },
    spin: { label: 'Ω of its orbit', unit: 'rad/s', initial: 1, min: 0.5, max: 2 },
  },
  presets: [{ label: 'A heavy moon', values: { moon: 4 } }],
  build({ moon, spin }: Values, { integrator = rungeKutta4 }: BuildOptions) {
    const world = createPhysicsWorld({ capacity: 4000, forces: [attractors(), hillFrame({ spin })], integrator });
    spawn(world, { position: {}, attractor: moon, appearance: { size: 0.9, color: rgba(1, 0.85, 0.6) } });
    const add = (x: number, y: number, color: number) =>
      spawn(world, {
        position: { x, y },
        velocity: { x: -1.5 * spin * y },
        mass: 1,
        appearance: { size: 0.1, color },
      });
    const grains = Array.from({ length: 2 * ROWS * PER_ROW }, (_, k) => {
      const i = k % (2 * ROWS);
      // Neighbouring rows are shifted, by multiples of the golden section.
      const x = ((((k - i) / (2 * ROWS) + 0.618 * i) % PER_ROW) / PER_ROW) * 2 * HALF - HALF;
      return add(x, rowAt(i), rgba(0.85, 0.8 - 0.012 * (i % ROWS), 0.7, 0.9));
    });
    // From so far away that the pull of the moon begins gently.
    const probe = add(4 * HALF, PROBE, rgba(0.43, 0.72, 1));
    // What leaves the piece is replaced by a fresh particle where its row comes in.
    const replace = relaunchOutside({ min: { x: -HALF }, max: { x: HALF } }, grains, (id, k) => {
      const row = rowAt(k % (2 * ROWS));
      teleport(world, id, { x: row > 0 ? HALF : -HALF, y: row }, { x: -1.5 * spin * row, y: 0 });
    });
    world.phases.input.push(replace);
    /** Amplitude of the radial swing: the middle of the swing is at y₀ = 4 y + 2 vₓ/Ω. */
    const amplitude = () => {
      const [{ y }, v] = [positionOf(world, probe), velocityOf(world, probe)];
      const middle = 4 * y + (2 * v.x) / spin;
      const [a, b] = [y - middle, v.y / spin];
      return Math.sqrt(a * a + b * b);
    };
    return { world, dt: 1 / 60, probe, amplitude };
  },
  picture({ probe }) {
    return {
      view: { minX: -HALF, maxX: HALF, minY: -11, maxY: 11 },
      fills: [{ shape: { minX: -900, maxX: 900, minY: -900, maxY: 900 }, color: 0x05070f }],
      trails: [{ body: probe, length: 1500, color: COLORS.blue }],
    };
  },
  plots: (plot) => [
    plot('The blue particle', 'y, m', {
      label: 'distance from the moon’s orbit',
      value: ({ world, probe }) => positionOf(world, probe).y,
    }),
  ],
  checks: ({ at }) => [
    // The next order is some Gm/(Ω² b³), 1 %: halving the moon halves the error.
    at(
      40,
      'Amplitude of the wave of the blue particle, 2.24 Gm/(Ω b)²',
      { exact: amplitudeOf(2, 1), unit: 'm', relative: 0.03 },
      ({ amplitude }) => amplitude(),
    ),
    {
      label: 'Length of its wave, 3π b',
      unit: 'm',
      exact: 3 * Math.PI * PROBE,
      tolerance: { relative: 0.02 },
      at: { event: ({ world, probe }) => velocityOf(world, probe).y, from: 2, to: 3 },
      measure: ({ world, probe }) => -positionOf(world, probe).x,
    },
  ],
  tryThis: [
    'Look at a row farther from the moon: its waves are longer and lower, so that rows draw together and part again.',
    'Choose “A heavy moon”: the waves are so high that the rows next to the gap cross.',
  ],
});
