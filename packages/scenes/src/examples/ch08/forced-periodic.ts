import {
  cos,
  createPhysicsWorld,
  linearDrag,
  periodicDrive,
  rungeKutta4,
  sin,
  spawn,
  springs,
} from '@principia/physics';
import type { SceneRun } from '../../scene.ts';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { forceArrow } from '../support/arrows.ts';
import { positionOf, velocityOf } from '../support/read.ts';

const CENTRE = { x: 350, y: 100 };
const STIFFNESS = 10;
/** Frequency of the damped swing, rad/s. */
const OWN = 3.15238;

/** Amplitude when the start is forgotten: F/√((k − Ω²)² + c² Ω²) for 1 kg. */
function steady({ omega, push, damping }: ValuesOf<'omega' | 'push' | 'damping'>): number {
  const [detuning, loss] = [STIFFNESS - omega * omega, damping * omega];
  return (Math.SQRT2 * push) / Math.sqrt(detuning * detuning + loss * loss);
}

const OMEGAS = [
  ['At half the natural frequency', OWN / 2, 37.429],
  ['At the natural frequency', OWN, 179.306],
  ['At the resonance', 3.14245, 179.447],
] as const;

interface Run extends SceneRun {
  readonly ball: number;
  readonly amplitude: () => number;
}

export default defineExample({
  id: 'ch08-forced-periodic',
  title: 'Resonance',
  chapter: 8,
  tags: ['spring', 'oscillation', 'resonance'],
  about:
    'A force pushes to and fro with a frequency Ω of its own. At first the ball’s own swing is mixed in; drag lets that die, and the ball follows the push. If the push comes at the frequency at which the ball would swing by itself, the amplitude grows to many times what the same force does at other frequencies: resonance.',
  duration: 60,
  parameters: {
    omega: { label: 'Frequency Ω of the push', unit: 'rad/s', initial: 2 * OWN, min: 0.5, max: 10 },
    push: { label: 'Strength of the push', unit: 'N', initial: 200, min: 0, max: 400 },
    damping: { label: 'Damping c', unit: 'kg/s', initial: 0.5, min: 0.3, max: 5 },
  },
  presets: OMEGAS.map(([label, omega]) => ({ label, values: { omega } })),
  build({ omega, push, damping }, { integrator = rungeKutta4 }): Run {
    const drive = periodicDrive({ cosine: { x: push }, sine: { x: push }, angularFrequency: omega });
    const world = createPhysicsWorld({ capacity: 8, forces: [linearDrag(), springs(), drive], integrator });
    const wall = spawn(world, { position: CENTRE });
    const ball = spawn(world, { position: CENTRE, mass: 1, collider: 16, linearDrag: damping });
    spawn(world, { spring: { a: wall, b: ball, stiffness: STIFFNESS } });
    const amplitude = () => {
      const [x, v] = [positionOf(world, ball).x - CENTRE.x, velocityOf(world, ball).x / omega];
      return Math.sqrt(x * x + v * v);
    };
    return { world, dt: 1 / 60, ball, amplitude };
  },
  picture({ world, ball }, values) {
    const [{ omega, push }, edge] = [values, Math.min(300, steady(values))];
    const force = () => ({ x: push * (cos(omega * world.time) + sin(omega * world.time)), y: 0 });
    return {
      view: { minX: 20, maxX: 680, minY: 0, maxY: 200 },
      lines: [-edge, edge].map((x) => ({
        from: { x: CENTRE.x + x, y: 60 },
        to: { x: CENTRE.x + x, y: 140 },
        color: COLORS.grey,
      })),
      springs: { coils: 16 },
      arrows: [forceArrow(world, ball, 'push', force, 0.3)],
    };
  },
  plots: (plot) => [
    plot('Displacement', 'x, px', { label: 'ball', value: ({ world, ball }) => positionOf(world, ball).x - CENTRE.x }),
    plot('Amplitude', 'amplitude, px', {
      label: 'now',
      value: ({ amplitude }) => amplitude(),
      exact: (_, values) => steady(values),
    }),
  ],
  checks: ({ at }) => [
    at(
      60,
      'Amplitude after 60 s at twice the natural frequency',
      { exact: 9.454, unit: 'px', relative: 1e-3 },
      ({ amplitude }) => amplitude(),
    ),
    ...OMEGAS.map(([preset, , exact]) =>
      at(60, `${preset}: amplitude after 60 s`, { exact, unit: 'px', relative: 1e-3, preset }, ({ amplitude }) =>
        amplitude(),
      ),
    ),
  ],
  tryThis: [
    'Move the frequency slowly from 1 to 6: near 3.1 the swing becomes huge.',
    'At the resonance, make the damping five times as large: the swing becomes five times smaller.',
  ],
});
