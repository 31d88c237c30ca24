import { angularMomentum, energy } from '@principia/physics';
import { type BuildOptions, choiceOf, defineExample, type ValuesOf } from '../define-example.ts';
import { distanceBetween, positionOf } from '../support/read.ts';
import {
  type PeriodicOrbit,
  STAR_COLORS,
  type ThreeBodyRun,
  threeBodies,
  threeBodyPicture,
} from '../support/three-bodies.ts';

type Values = ValuesOf<'orbit' | 'nudge'>;

const [X, Y, VX, VY] = [0.97000436, 0.24308753, 0.93240737, 0.86473146];
/** Chenciner and Montgomery, Annals of Mathematics 152, 881 (2000), with the numbers of Simó. */
const EIGHT: PeriodicOrbit = {
  places: [
    { x: X, y: -Y },
    { x: -X, y: Y },
    { x: 0, y: 0 },
  ],
  velocities: [
    { x: VX / 2, y: VY / 2 },
    { x: VX / 2, y: VY / 2 },
    { x: -VX, y: -VY },
  ],
  period: 6.32591398,
};

const [HALF, ROOT] = [1 / 2, Math.sqrt(3) / 2];
/** Lagrange (1772): a triangle with sides a = √3 turns with ω² = 3 G m/a³ = 1/√3. */
const SPIN = Math.sqrt(1 / Math.sqrt(3));
const TRIANGLE: PeriodicOrbit = {
  places: [
    { x: 1, y: 0 },
    { x: -HALF, y: ROOT },
    { x: -HALF, y: -ROOT },
  ],
  velocities: [
    { x: 0, y: SPIN },
    { x: -SPIN * ROOT, y: -SPIN * HALF },
    { x: SPIN * ROOT, y: -SPIN * HALF },
  ],
  period: (2 * Math.PI) / SPIN,
};
const ORBITS = [EIGHT, TRIANGLE];

export default defineExample({
  id: 'ch17-figure-eight',
  title: 'Three stars chase each other along an eight',
  chapter: 17,
  tags: ['gravity', 'orbit', 'three bodies', 'choreography', 'chaos'],
  about:
    'Three equal stars attract each other, and their motion should be chaos. Yet there are starts from which they follow each other for ever on one curve. Lagrange found the turning triangle in 1772; the eight was found only in 1993, and proven in 2000. The triangle falls apart at the least disturbance. The eight is stable: it only wobbles.',
  duration: 20,
  parameters: {
    orbit: choiceOf('Orbit', ['Eight', 'Triangle']),
    nudge: { label: 'Nudge of a star', unit: 'm', initial: 0, min: 0, max: 0.05 },
  },
  presets: [
    { label: 'A nudged eight', values: { nudge: 0.01 } },
    { label: 'Lagrange’s triangle', values: { orbit: 1 } },
    { label: 'A nudged triangle', values: { orbit: 1, nudge: 0.01 } },
  ],
  build: ({ orbit, nudge }: Values, { integrator }: BuildOptions) => threeBodies(ORBITS[orbit], nudge, integrator),
  picture(run, { orbit }) {
    const { world, stars } = run;
    const line = (a: number, b: number) => ({
      from: () => positionOf(world, stars[a]),
      to: () => positionOf(world, stars[b]),
      color: 0x39425e,
      width: 1,
    });
    return {
      ...threeBodyPicture(run, 2.6, orbit === 0 ? 1.2 : 2.4, ORBITS[orbit].period / 3),
      lines: [line(0, 1), line(1, 2), line(2, 0)],
    };
  },
  plots: (plot) => [
    plot(
      'Distances from the middle',
      'r, m',
      ...STAR_COLORS.map((_, i) => ({
        label: `star ${i + 1}`,
        value: ({ world, stars }: ThreeBodyRun) => distanceBetween(positionOf(world, stars[i]), { x: 0, y: 0 }),
      })),
    ),
  ],
  checks: ({ at, largest }) => [
    // The start is given to 8 digits.
    at(
      EIGHT.period,
      'All are back where they started after the period of 6.32591398 s, off by',
      { exact: 0, unit: 'm', absolute: 1e-6 },
      ({ offStart }) => offStart(),
    ),
    at(
      EIGHT.period / 3,
      'After a third of it each is where another one started, off by',
      { exact: 0, unit: 'm', absolute: 1e-6 },
      ({ stars, fromStart }) =>
        Math.max(...stars.map((_, i) => Math.min(fromStart(i, (i + 1) % 3), fromStart(i, (i + 2) % 3)))),
    ),
    largest(
      3 * EIGHT.period,
      'Angular momentum of the eight, largest',
      { exact: 0, unit: 'kg m²/s', absolute: 1e-8 },
      ({ world }) => Math.abs(angularMomentum(world).z),
    ),
    at(
      3 * EIGHT.period,
      'Change of the energy after three periods',
      { exact: 0, unit: 'J', absolute: 1e-12 },
      ({ world, startEnergy }) => energy(world).total - startEnergy,
    ),
    at(
      TRIANGLE.period,
      'Side of the triangle after one turn of 2π √(a³/3Gm)',
      { exact: Math.sqrt(3), unit: 'm', relative: 1e-9, preset: 'Lagrange’s triangle' },
      ({ world, stars }) => distanceBetween(positionOf(world, stars[0]), positionOf(world, stars[1])),
    ),
  ],
  tryThis: [
    'Choose “A nudged eight”: the eight turns slowly and wobbles, and goes on.',
    'Choose “A nudged triangle”: within two turns two stars pair up, and the third is thrown about.',
    'Leave Lagrange’s triangle alone for a minute: the rounding of the sixteenth digit is enough to end it.',
  ],
});
