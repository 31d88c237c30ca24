import {
  createPhysicsWorld,
  linearDrag,
  rgba,
  rungeKutta4,
  sin,
  spawn,
  springs,
  uniformGravity,
} from '@principia/physics';
import type { SceneRun } from '../../scene.ts';
import { choiceOf, defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { positionOf } from '../support/read.ts';

const SUPPORT = { x: 350, y: 50 };
const [GRAVITY, STIFFNESS, LINK] = [20, 10, 50];
/** Where the balls hang at rest, y downwards: each spring carries all balls below it. */
const RESTS = [112, 172, 230, 286, 340, 392];
const MODES = [1, 2, 3, 4, 5, 6];
/** Frequencies of the vertical normal modes, 2 √(k/m) sin((2j − 1)π/26). */
const frequency = (mode: number) => 2 * Math.sqrt(STIFFNESS) * sin(((2 * mode - 1) * Math.PI) / 26);

interface Run extends SceneRun {
  readonly support: number;
  readonly balls: readonly number[];
}

export default defineExample({
  id: 'ch08-coupled-chain',
  title: 'A chain of balls on springs',
  chapter: 8,
  tags: ['spring', 'oscillation', 'normal modes', 'waves'],
  about:
    'Six balls hang on one another by springs, and the support moves to and fro. A pull runs down the chain as a wave. Among all motions of a chain there are six simple ones along it, the normal modes, in which all balls swing with one frequency; every other is a mixture of them.',
  duration: 80,
  parameters: {
    swing: { label: 'Swing of the support', unit: 'px', initial: 100, min: 0, max: 150 },
    damping: { label: 'Damping c', unit: 'kg/s', initial: 0.5, min: 0, max: 2 },
    mode: choiceOf('Start', ['slanting', ...MODES.map((mode) => `mode ${mode}`)]),
  },
  presets: [
    { label: 'Support at rest', values: { swing: 0 } },
    ...MODES.map((mode) => ({ label: `Normal mode ${mode}`, values: { swing: 0, damping: 0, mode } })),
  ],
  build({ swing, damping, mode }, { integrator = rungeKutta4 }): Run {
    const forces = [uniformGravity({ y: GRAVITY }), linearDrag(), springs()];
    const world = createPhysicsWorld({ capacity: 20, forces, integrator });
    const dt = 1 / 60;
    const support = spawn(world, {
      position: SUPPORT,
      velocity: {},
      appearance: { size: 8, color: rgba(1, 0.9, 0.5) },
    });
    // The support is moved by a velocity that brings it to its place at the end of the step.
    world.phases.input.push(() => {
      const next = SUPPORT.x + swing * sin(world.time + dt);
      world.components.Velocity.x[support] = (next - positionOf(world, support).x) / dt;
    });
    let above = support;
    const balls = RESTS.map((rest, i) => {
      const start = { x: SUPPORT.x + 42 * (i + 1), y: SUPPORT.y + 42 * (i + 1) };
      const part = 14 * sin(((2 * mode - 1) * Math.PI * (i + 1)) / 13);
      const position = mode === 0 ? start : { x: SUPPORT.x, y: rest + part };
      const ball = spawn(world, { position, mass: 1, collider: 10, linearDrag: damping });
      spawn(world, { spring: { a: above, b: ball, stiffness: STIFFNESS, length: LINK } });
      above = ball;
      return ball;
    });
    return { world, dt, support, balls };
  },
  picture({ balls }) {
    return {
      yDown: true,
      view: { minX: 0, maxX: 700, minY: 10, maxY: 500 },
      springs: { coils: 8 },
      trails: [{ body: balls[5], length: 500 }],
      lines: RESTS.map((y) => ({ from: { x: 340, y }, to: { x: 360, y }, color: COLORS.grey, width: 1 })),
    };
  },
  plots: (plot) => [
    plot(
      'Heights, with the support at 0',
      'h, px',
      ...[0, 2, 5].map((i) => ({
        label: `ball ${i + 1}`,
        value: ({ world, balls }: Run) => SUPPORT.y - positionOf(world, balls[i]).y,
      })),
    ),
    plot(
      'Sideways',
      'x, px',
      { label: 'support', value: ({ world, support }: Run) => positionOf(world, support).x },
      { label: 'last ball', value: ({ world, balls }: Run) => positionOf(world, balls[5]).x },
    ),
  ],
  checks: ({ at }) => [
    at(
      10,
      'Support after 10 s, 350 + 100 sin t',
      { exact: ({ swing }) => SUPPORT.x + swing * sin(10), unit: 'px', absolute: 1e-9 },
      ({ world, support }: Run) => positionOf(world, support).x,
    ),
    ...RESTS.map((rest, i) =>
      at(
        80,
        `Depth of ball ${i + 1} at rest below the support`,
        { exact: rest - SUPPORT.y, unit: 'px', absolute: 0.01, preset: 'Support at rest' },
        ({ world, balls }: Run) => positionOf(world, balls[i]).y - SUPPORT.y,
      ),
    ),
    ...MODES.map((mode) => ({
      label: `Period of mode ${mode}`,
      unit: 's',
      exact: (2 * Math.PI) / frequency(mode),
      tolerance: { relative: 0.005 },
      at: { event: ({ world, balls }: Run) => positionOf(world, balls[5]).y - RESTS[5], from: 1, to: 2 },
      preset: `Normal mode ${mode}`,
    })),
  ],
  tryThis: [
    'Choose the normal modes one after the other: the higher the mode, the faster, and the more neighbours move against each other.',
    'Choose “Support at rest”: the chain comes to rest on the grey marks.',
  ],
});
