import { createPhysicsWorld, energy, spawn, uniformGravity, velocityVerlet } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { positionOf } from '../support/read.ts';

export default defineExample({
  id: 'ch05-projectile-energy',
  title: 'Energy changes its form',
  chapter: 5,
  tags: ['energy', 'projectile', 'gravity'],
  about:
    'On its way up the ball loses speed and gains height: energy of motion becomes energy of height, and on the way down the same back again. The two bars change all the time, and stand on top of each other to the same height: energy is never lost, it only changes its form.',
  duration: 10,
  ends: true,
  parameters: {
    gravity: { label: 'Gravity', unit: 'px/s²', initial: 10, min: 9, max: 25 },
    speed: { label: 'Speed upwards', unit: 'px/s', initial: 50, min: 10, max: 50 },
  },
  presets: [{ label: 'Twice the gravity', values: { gravity: 20 } }],
  build({ gravity, speed }: ValuesOf<'gravity' | 'speed'>, { integrator = velocityVerlet }: BuildOptions) {
    const world = createPhysicsWorld({ capacity: 4, forces: [uniformGravity({ y: -gravity })], integrator });
    const ball = spawn(world, { position: {}, velocity: { y: speed }, mass: 1, collider: 5 });
    return { world, dt: 1 / 60, ball };
  },
  picture({ world, ball }) {
    const bar = (from: () => number, to: () => number, color: number) => ({
      from: () => ({ x: -60, y: from() / 10 }),
      to: () => ({ x: -60, y: to() / 10 }),
      color,
      width: 34,
    });
    const kinetic = () => energy(world).kinetic;
    return {
      view: { minX: -120, maxX: 90, minY: -12, maxY: 136 },
      fills: [{ shape: { minX: -900, maxX: 900, minY: -300, maxY: -5 }, color: COLORS.ground }],
      lines: [
        bar(() => 0, kinetic, COLORS.blue),
        bar(kinetic, () => energy(world).total, COLORS.red),
        { from: { x: -10, y: 62.5 }, to: { x: 80, y: 62.5 }, color: COLORS.ground },
      ],
      trails: [{ body: ball, length: 300 }],
      arrows: [velocityArrow(world, ball, 0.6)],
      labels: [
        { at: () => ({ x: -110, y: kinetic() / 20 - 2 }), text: 'motion', color: COLORS.blue },
        { at: () => ({ x: -110, y: (kinetic() + energy(world).total) / 20 - 2 }), text: 'height', color: COLORS.red },
        { at: { x: 22, y: 63 }, text: 'half of each', color: COLORS.grey },
      ],
    };
  },
  plots: (plot) => [
    plot(
      'Energy of motion and height',
      'E, kg px²/s²',
      { label: 'motion', value: ({ world }) => energy(world).kinetic },
      { label: 'height', value: ({ world }) => energy(world).potential },
      { label: 'total', value: ({ world }) => energy(world).total },
    ),
  ],
  checks: ({ at, largest, smallest }) => [
    largest(
      10,
      'Largest total energy in 10 s, ½ m u²',
      { exact: ({ speed }) => (speed * speed) / 2, unit: 'kg px²/s²', absolute: 1e-9 },
      ({ world }) => energy(world).total,
    ),
    smallest(
      10,
      'Smallest total energy',
      { exact: ({ speed }) => (speed * speed) / 2, unit: 'kg px²/s²', absolute: 1e-9 },
      ({ world }) => energy(world).total,
    ),
    at(
      5,
      'Height at 5 s, the apex',
      { exact: 125, unit: 'px', absolute: 1e-9 },
      ({ world, ball }) => positionOf(world, ball).y,
    ),
    {
      // The difference of the two is linear in the height, so that interpolation between steps is exact.
      label: 'Height at which both forms are equal, u²/4g',
      unit: 'px',
      exact: ({ gravity, speed }) => (speed * speed) / (4 * gravity),
      tolerance: { absolute: 1e-9 },
      at: { event: ({ world }) => energy(world).potential - energy(world).kinetic },
      measure: ({ world, ball }) => positionOf(world, ball).y,
    },
  ],
  tryThis: [
    'Watch the ball pass the line at half the height: there both bars are equally long.',
    'Throw half as fast: the energy is a quarter, and so is the height.',
  ],
});
