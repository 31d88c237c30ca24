import {
  cos,
  createPhysicsWorld,
  energy,
  positionFirstEuler,
  rungeKutta4,
  sin,
  spawn,
  springs,
  velocityVerlet,
} from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { positionOf, velocityOf } from '../support/read.ts';

const CENTRE = { x: 350, y: 100 };
const AMPLITUDE = 250;
const DT = 1 / 60;

export default defineExample({
  id: 'ch08-free-oscillations',
  title: 'Free oscillation, and what a step costs',
  chapter: 8,
  tags: ['spring', 'oscillation', 'energy', 'integrators'],
  about:
    'Left to itself, a ball on a spring moves as a cosine, and its energy goes to and fro between motion and spring. A program that moves it in steps gets the energy a little wrong. Good schemes keep that error small for ever: it goes up and down, and does not grow.',
  duration: 20,
  parameters: {
    stiffness: { label: 'Stiffness', unit: 'N/m', initial: 1, min: 0.2, max: 10 },
    amplitude: { label: 'Amplitude', unit: 'px', initial: AMPLITUDE, min: 20, max: 300 },
  },
  build({ stiffness, amplitude }, { integrator = positionFirstEuler }) {
    const world = createPhysicsWorld({ capacity: 8, forces: [springs()], integrator });
    const wall = spawn(world, { position: CENTRE });
    const ball = spawn(world, { position: { x: CENTRE.x - amplitude, y: CENTRE.y }, mass: 1, collider: 18 });
    spawn(world, { spring: { a: wall, b: ball, stiffness } });
    const start = energy(world).total;
    return { world, dt: DT, ball, energyError: () => energy(world).total / start - 1 };
  },
  picture({ world, ball }, { stiffness, amplitude }) {
    const exact = (t: number) => ({ x: CENTRE.x - amplitude * cos(Math.sqrt(stiffness) * t), y: CENTRE.y });
    return {
      view: { minX: 20, maxX: 680, minY: 0, maxY: 200 },
      lines: [{ from: { x: CENTRE.x, y: 60 }, to: { x: CENTRE.x, y: 140 }, color: COLORS.grey }],
      springs: { coils: 16 },
      curves: [{ points: [], now: exact, markRadius: 18, label: 'exact' }],
      arrows: [velocityArrow(world, ball, 0.4)],
    };
  },
  plots: (plot) => [
    plot('Displacement', 'x, px', {
      label: 'stepped',
      value: ({ world, ball }) => positionOf(world, ball).x - CENTRE.x,
      exact: (t, { stiffness, amplitude }) => -amplitude * cos(Math.sqrt(stiffness) * t),
    }),
    plot('Error of the energy', 'fraction', { label: 'error', value: ({ energyError }) => energyError() }),
    plot('Velocity', 'v, px/s', {
      label: 'stepped',
      value: ({ world, ball }) => velocityOf(world, ball).x,
      exact: (t, { stiffness, amplitude }) => amplitude * Math.sqrt(stiffness) * sin(Math.sqrt(stiffness) * t),
    }),
  ],
  checks: ({ at, largest }) => [
    {
      label: 'Period of this scheme, π dt/arcsin(ω dt/2)',
      unit: 's',
      exact: 6.2831126,
      tolerance: { absolute: 1e-5 },
      at: { event: ({ world, ball }) => positionOf(world, ball).x - CENTRE.x, from: 1, to: 3 },
      measure: ({ world }) => world.time / 2,
    },
    largest(20, 'Largest error of the energy, ½ ω dt', { exact: DT / 2, relative: 0.02 }, ({ energyError }) =>
      Math.abs(energyError()),
    ),
    largest(
      20,
      'Largest error of the energy, ω² dt²/4',
      { exact: (DT * DT) / 4, relative: 0.02, integrator: velocityVerlet },
      ({ energyError }) => Math.abs(energyError()),
    ),
    at(
      20,
      'Energy lost in 20 s, ω⁶ dt⁵ t/72',
      { exact: (20 * DT * DT * DT * DT * DT) / 72, relative: 0.02, integrator: rungeKutta4 },
      ({ energyError }) => -energyError(),
    ),
  ],
  tryThis: [
    'Change the integrator to explicit Euler: the ball swings further and further.',
    'Change it to velocity Verlet: the error of the energy becomes more than a hundred times smaller.',
  ],
});
