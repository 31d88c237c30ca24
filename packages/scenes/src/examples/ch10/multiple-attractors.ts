import { attractors, createPhysicsWorld, gaussRadau, rgba, spawn } from '@principia/physics';
import type { SceneRun } from '../../scene.ts';
import { defineExample } from '../define-example.ts';
import { distanceBetween, positionOf, speedOf } from '../support/read.ts';

const SUNS = [
  { x: 300, y: 300 },
  { x: 500, y: 300 },
] as const;
const GM = 1e6;
/** Start, velocity and energy of the bodies, px, px/s and kg px²/s². */
const BODIES = [
  { name: 'first', at: { x: 400, y: 300 }, v: { x: 0, y: 60 }, energy: -18200, color: rgba(0.4, 0.7, 1) },
  { name: 'second', at: { x: 400, y: 400 }, v: { x: 10, y: 60 }, energy: -12292.14, color: rgba(1, 0.55, 0.4) },
  { name: 'third', at: { x: 300, y: 400 }, v: { x: 90, y: 0 }, energy: -10422.14, color: rgba(0.5, 0.9, 0.6) },
] as const;

interface Run extends SceneRun {
  readonly bodies: readonly number[];
}

/** Energy of a body of 1 kg. */
function energyOf({ world, bodies }: Run, i: number): number {
  const speed = speedOf(world, bodies[i]);
  return SUNS.reduce((sum, sun) => sum - GM / distanceBetween(positionOf(world, bodies[i]), sun), (speed * speed) / 2);
}

export default defineExample({
  id: 'ch10-multiple-attractors',
  title: 'Between two suns',
  chapter: 10,
  tags: ['gravity', 'orbit', 'energy', 'chaos'],
  about:
    'Two fixed suns pull at once; their forces add up. The first body starts exactly between them and only swings up and down. The others weave around both suns on paths that never repeat. Whatever they do, motion and height in the field of the suns share an energy that stays the same.',
  duration: 20,
  conservesEnergy: true,
  parameters: {
    push: { label: 'Speed of the first body', unit: 'px/s', initial: 60, min: 10, max: 130 },
    second: { label: 'Second sun', unit: '×', initial: 1, min: 0, max: 2 },
  },
  presets: [{ label: 'The second sun is a little heavier', values: { second: 1.05 } }],
  build({ push, second }, { integrator = gaussRadau() }): Run {
    const world = createPhysicsWorld({ capacity: 8, forces: [attractors()], integrator });
    for (const [i, position] of SUNS.entries()) {
      const appearance = { size: 14, color: rgba(1, 0.8, 0.3) };
      spawn(world, { position, attractor: i === 1 ? second * GM : GM, appearance });
    }
    const bodies = BODIES.map(({ at, v, color }, i) => {
      const velocity = i === 0 ? { y: push } : v;
      return spawn(world, { position: at, velocity, mass: 1, appearance: { size: 6, color } });
    });
    return { world, dt: 1 / 500, bodies };
  },
  picture({ bodies }) {
    return {
      yDown: true,
      view: { minX: 130, maxX: 670, minY: 120, maxY: 480 },
      trails: bodies.map((body) => ({ body, length: 700, interval: 5 })),
    };
  },
  plots: (plot) => [
    plot('Height of the first body above the suns', 'h, px', {
      label: 'first',
      value: ({ world, bodies }: Run) => 300 - positionOf(world, bodies[0]).y,
    }),
    plot(
      'Speeds',
      'v, px/s',
      ...BODIES.map(({ name }, i) => ({
        label: name,
        value: ({ world, bodies }: Run) => speedOf(world, bodies[i]),
      })),
    ),
  ],
  checks: ({ at, largest }) => [
    ...BODIES.map(
      (
        { name, energy },
        i, // The given energies have two digits after the point.
      ) =>
        at(
          10,
          `Energy of the ${name} body after 10 s`,
          { exact: energy, unit: 'kg px²/s²', absolute: 5e-3 },
          (run: Run) => energyOf(run, i),
        ),
    ),
    largest(
      10,
      'How far the first body swings, √(2e6²/18200² − 1e4)',
      { exact: Math.sqrt(4e12 / (18_200 * 18_200) - 1e4), unit: 'px', absolute: 5e-4 },
      ({ world, bodies }: Run) => positionOf(world, bodies[0]).y - 300,
    ),
    {
      label: 'Its period',
      unit: 's',
      exact: 4.9469,
      tolerance: { absolute: 1e-4 },
      at: { event: ({ world, bodies }: Run) => positionOf(world, bodies[0]).y - 300, from: 1, to: 2 },
    },
    largest(10, 'How far it strays from the middle', { exact: 0, unit: 'px', absolute: 0 }, ({ world, bodies }: Run) =>
      Math.abs(positionOf(world, bodies[0]).x - 400),
    ),
  ],
  tryThis: [
    'Choose “The second sun is a little heavier”: the first body is drawn aside, and its path becomes as tangled as the others.',
    'Remove the second sun, with 0: every path is an ellipse.',
  ],
});
