import { attractors, createPhysicsWorld, rgba, rungeKutta4, spawn } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { lengthOf, positionOf, speedOf } from '../support/read.ts';

const GM = 1e6;
const START = 167.705;
const ESCAPE = Math.sqrt((2 * GM) / START);
/** Highest distance of a body that starts with a fraction of the escape velocity. */
const apex = (fraction: number) => START / (1 - fraction * fraction);

export default defineExample({
  id: 'ch06-escape-velocity',
  title: 'Away for ever, or back again?',
  chapter: 6,
  tags: ['gravity', 'escape velocity', 'energy'],
  about:
    'Two rockets are shot straight away from a sun. At the escape velocity the energy of motion just pays for the whole journey out. The one with a little more never comes back, and keeps a rest of its speed for ever; the one with a little less stops very far out, and falls back.',
  duration: 900,
  parameters: {
    fast: { label: 'Orange: share of escape velocity', initial: 1.01, min: 1, max: 1.3 },
    slow: { label: 'Blue: share of escape velocity', initial: 0.9, min: 0.3, max: 0.99 },
  },
  presets: [{ label: 'One per cent less', values: { slow: 0.99 } }],
  build({ fast, slow }, { integrator = rungeKutta4 }) {
    const world = createPhysicsWorld({ capacity: 4, forces: [attractors()], integrator });
    spawn(world, { position: {}, attractor: GM, appearance: { size: 70, color: rgba(1, 0.8, 0.3) } });
    const body = { mass: 1, collider: 16 };
    const blue = spawn(world, { ...body, position: { y: START }, velocity: { y: slow * ESCAPE } });
    const velocity = { x: fast * ESCAPE };
    const orange = spawn(world, { ...body, position: { x: START }, velocity, appearance: rgba(1, 0.7, 0.28) });
    // Speed that is left at an infinite distance.
    const leftOver = () => {
      const v = speedOf(world, orange);
      return Math.sqrt(Math.max(0, v * v - (2 * GM) / lengthOf(positionOf(world, orange))));
    };
    return { world, dt: 1 / 20, blue, orange, leftOver };
  },
  picture: ({ world, blue, orange }, { slow }) => ({
    view: { minX: -200, maxX: 2200, minY: -250, maxY: 1150 },
    lines: [{ from: { x: -150, y: apex(slow) }, to: { x: 150, y: apex(slow) }, color: COLORS.grey, width: 1 }],
    labels: [{ at: { x: 160, y: apex(slow) - 20 }, text: 'turns back here', color: COLORS.grey }],
    trails: [blue, orange].map((body) => ({ body, length: 1500 })),
    arrows: [blue, orange].map((id) => velocityArrow(world, id, 3)),
  }),
  plots: (plot) => [
    plot(
      'Speed',
      'v, px/s',
      { label: 'blue', value: ({ world, blue }) => speedOf(world, blue) },
      { label: 'orange', value: ({ world, orange }) => speedOf(world, orange) },
    ),
  ],
  checks: ({ at, largest }) => [
    at(
      0,
      'Escape velocity √(2 GM/r), from the speed of the orange rocket',
      { exact: Math.sqrt((2 * GM) / START), unit: 'px/s', relative: 1e-12 },
      ({ world, orange }) => speedOf(world, orange) / 1.01,
    ),
    at(
      900,
      'Speed that is left of the orange one, √(v² − v_esc²)',
      { exact: ({ fast }) => ESCAPE * Math.sqrt(fast * fast - 1), unit: 'px/s', relative: 1e-3 },
      ({ leftOver }) => leftOver(),
    ),
    largest(
      30,
      'Largest distance of the blue one, r/(1 − share²)',
      { exact: apex(0.9), unit: 'px', relative: 1e-3 },
      ({ world, blue }) => positionOf(world, blue).y,
    ),
    largest(
      900,
      'Largest distance with one per cent less',
      { exact: apex(0.99), unit: 'px', relative: 1e-3, preset: 'One per cent less' },
      ({ world, blue }) => positionOf(world, blue).y,
    ),
  ],
  tryThis: [
    'Give the blue rocket 0.95 instead of 0.9: it gets nearly twice as far, ten times as far out as it started.',
    'Give the orange one exactly 1: it becomes slower and slower, and yet never turns round.',
  ],
});
