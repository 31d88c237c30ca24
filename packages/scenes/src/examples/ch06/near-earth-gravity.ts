import { attractors, createPhysicsWorld, spawn, velocityVerlet } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { positionOf, velocityOf } from '../support/read.ts';

/** Gravitational parameter, m³/s², and mean radius, m, of the Earth. */
const EARTH = { GM: 3.986e14, radius: 6.371e6 };
const gravityAt = (height: number) => EARTH.GM / ((EARTH.radius + height) * (EARTH.radius + height));

export default defineExample({
  id: 'ch06-near-earth-gravity',
  title: 'Is gravity the same up there?',
  chapter: 6,
  tags: ['gravity', 'earth', 'units'],
  about:
    'A stone is dropped from a tower of ten kilometres, once with the true gravity GM/r², which is weaker up there, and once with the same 9.82 m/s² everywhere. After more than forty seconds and ten kilometres the two are not even thirty metres apart. That is why everyday physics may call gravity a constant.',
  duration: 46,
  ends: true,
  parameters: { height: { label: 'Height of the tower', unit: 'km', initial: 10, min: 1, max: 12 } },
  build({ height }: ValuesOf<'height'>, { integrator = velocityVerlet }: BuildOptions) {
    // The y axis begins at the centre of the Earth for the one, and is shown from the ground upwards for both.
    const top = 1000 * height;
    const world = createPhysicsWorld({ capacity: 4, forces: [attractors()], integrator });
    spawn(world, { position: { y: -EARTH.radius }, attractor: EARTH.GM });
    const ball = spawn(world, { position: { y: top }, velocity: {}, mass: 1, collider: 180 });
    const constant = (t: number) => ({ x: 1500, y: top - (gravityAt(0) / 2) * t * t });
    return { world, dt: 1 / 60, ball, constant, top };
  },
  picture: ({ world, ball, constant, top }) => ({
    view: { minX: -6000, maxX: 9000, minY: -600, maxY: 12500 },
    fills: [{ shape: { minX: -90000, maxX: 90000, minY: -30000, maxY: 0 }, color: COLORS.ground }],
    lines: [{ from: { x: -400, y: top }, to: { x: -400, y: 0 }, color: COLORS.grey, width: 4 }],
    trails: [{ body: ball, length: 300 }],
    curves: [{ points: [], now: constant, markRadius: 180, label: 'with constant gravity', color: COLORS.orange }],
    arrows: [velocityArrow(world, ball, 4)],
    labels: [
      {
        at: { x: -5800, y: 11600 },
        text: () => `${(positionOf(world, ball).y - constant(world.time).y).toFixed(1)} m apart`,
      },
    ],
  }),
  plots: (plot) => [
    plot('How far the two are apart', 'distance, m', {
      label: 'difference',
      value: ({ world, ball, constant }) => positionOf(world, ball).y - constant(world.time).y,
    }),
  ],
  checks: ({ at }) => [
    at(0, 'Gravity at the ground, GM/R²', { exact: 9.82, unit: 'm/s²', absolute: 5e-4 }, () => gravityAt(0)),
    at(
      0,
      'Change over a kilometre',
      { exact: -0.0314, unit: '%', absolute: 5e-5 },
      () => (gravityAt(1000) / gravityAt(0) - 1) * 100,
    ),
    at(
      1,
      'Acceleration of the stone in the first second',
      { exact: ({ height }) => gravityAt(1000 * height), unit: 'm/s²', relative: 1e-5 },
      ({ world, ball }) => -velocityOf(world, ball).y,
    ),
  ],
  tryThis: [
    'Read the plot: after ten seconds the difference is not even two metres.',
    'Take a tower of one kilometre: when the stone arrives, it is 26 cm behind the ring.',
  ],
});
