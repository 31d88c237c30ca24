import {
  attractors,
  createPhysicsWorld,
  energy,
  explicitEuler,
  heun,
  positionFirstEuler,
  rgba,
  rungeKutta4,
  spawn,
  velocityVerlet,
} from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { velocityArrow } from '../support/arrows.ts';
import { distanceBetween, positionOf, velocityOf } from '../support/read.ts';

const SUN = { x: 400, y: 300 };
const GM = 1e6;

const LARGEST = { until: 200, take: 'largest' } as const;

/** Errors of the energy, as fractions of it, to half a unit of the last digit or a hundredth. */
const ENERGY_ERRORS = [
  { integrator: explicitEuler, exact: 0.287, tolerance: { absolute: 5e-4 }, at: LARGEST },
  { integrator: positionFirstEuler, exact: 6.7e-4, tolerance: { relative: 0.01 }, at: LARGEST },
  { integrator: velocityVerlet, exact: 3.2e-6, tolerance: { absolute: 5e-8 }, at: LARGEST },
  { integrator: heun, exact: 1.3e-5, tolerance: { absolute: 5e-7 }, at: LARGEST },
  // What only grows is taken at the end.
  { integrator: rungeKutta4, exact: 1.1e-11, tolerance: { absolute: 5e-13 }, at: { time: 200 } },
];

export default defineExample({
  id: 'ch14-orbits',
  title: 'Which scheme stays in orbit?',
  chapter: 14,
  tags: ['integrators', 'orbit', 'energy'],
  about:
    'A planet circles a sun, and every scheme makes small mistakes. Explicit Euler always errs to the same side, and spirals outwards. The symplectic schemes err to and fro, and stay near the true orbit for ever. Runge-Kutta 4 makes the smallest mistakes, but they do add up: it loses a little energy in each turn.',
  duration: 200,
  parameters: {
    speed: { label: 'Speed at the start', unit: 'px/s', initial: 75, min: 60, max: 90 },
    rate: { label: 'Steps per second', unit: '1/s', initial: 60, min: 6, max: 120, integer: true, scale: 'log' },
  },
  presets: [{ label: 'Six steps a second', values: { rate: 6 } }],
  build({ speed, rate }: ValuesOf<'speed' | 'rate'>, { integrator = positionFirstEuler }: BuildOptions) {
    const world = createPhysicsWorld({ capacity: 4, forces: [attractors()], integrator });
    spawn(world, { position: SUN, attractor: GM, appearance: { size: 70, color: rgba(1, 0.8, 0.3) } });
    const ball = spawn(world, { position: { x: 400, y: 100 }, velocity: { x: speed }, mass: 1, collider: 10 });
    const start = energy(world).total;
    const r = () => distanceBetween(positionOf(world, ball), SUN);
    const radialSpeed = () => {
      const [p, v] = [positionOf(world, ball), velocityOf(world, ball)];
      return (p.x - SUN.x) * v.x + (p.y - SUN.y) * v.y;
    };
    return { world, dt: 1 / rate, ball, r, radialSpeed, error: () => energy(world).total / start - 1 };
  },
  picture: ({ world, ball }) => ({
    yDown: true,
    view: { minX: 60, maxX: 740, minY: 60, maxY: 590 },
    trails: [{ body: ball, length: 2000, interval: 2 }],
    arrows: [velocityArrow(world, ball, 0.8)],
  }),
  plots: (plot) => [
    // Energy of a bound orbit is negative: its fraction grows when energy is lost.
    plot('Error of the energy', 'error, %', { label: 'energy', value: ({ error }) => -100 * error() }),
    plot('Distance from the sun', 'r, px', { label: 'distance', value: ({ r }) => r() }),
  ],
  checks: ({ largest }) => [
    ...ENERGY_ERRORS.map((figure) => ({
      label: 'Error of the energy in 200 s',
      ...figure,
      measure: ({ error }: { error(): number }) => Math.abs(error()),
    })),
    {
      label: 'Period',
      unit: 's',
      exact: 21.7126,
      tolerance: { relative: 1e-3 },
      at: { event: ({ radialSpeed }) => radialSpeed(), from: 1, to: 2 },
    },
    largest(25, 'Largest distance', { exact: 257.143, unit: 'px', relative: 1e-3 }, ({ r }) => r()),
  ],
  tryThis: [
    'Choose explicit Euler and watch the trail: turn by turn the planet comes a little further out.',
    'Take six steps a second: the ellipse turns slowly around the sun, but the planet stays.',
  ],
});
