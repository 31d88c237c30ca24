import { createPhysicsWorld, energy, spawn, uniformGravity, velocityVerlet } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { positionOf, speedOf, velocityOf } from '../support/read.ts';

const MASS = 2;

export default defineExample({
  id: 'ch04-work-energy-power',
  title: 'Work becomes energy',
  chapter: 4,
  tags: ['energy', 'work', 'power'],
  about:
    'A steady force pushes a sledge over the ice. Force times distance is the work, and all of it becomes energy of motion ½ m v²: the two bars grow together. The power is force times velocity, so the same force delivers more and more energy per second, the faster the sledge goes.',
  duration: 3,
  ends: true,
  parameters: {
    fx: { label: 'Force to the right', unit: 'N', initial: 6, min: 0, max: 12 },
    fy: { label: 'Force upwards', unit: 'N', initial: 8, min: 0, max: 12 },
  },
  presets: [{ label: 'Only to the right', values: { fx: 10, fy: 0 } }],
  build({ fx, fy }: ValuesOf<'fx' | 'fy'>, { integrator = velocityVerlet }: BuildOptions) {
    const world = createPhysicsWorld({
      capacity: 4,
      forces: [uniformGravity({ x: fx / MASS, y: fy / MASS })],
      integrator,
    });
    const ball = spawn(world, { position: {}, velocity: { x: 1, y: 2 }, mass: MASS, collider: 0.8 });
    const start = energy(world).kinetic;
    const gained = () => energy(world).kinetic - start;
    const work = () => fx * positionOf(world, ball).x + fy * positionOf(world, ball).y;
    const power = () => fx * velocityOf(world, ball).x + fy * velocityOf(world, ball).y;
    return { world, dt: 1 / 60, ball, gained, work, power };
  },
  picture({ world, ball, gained, work }, { fx, fy }) {
    const bar = (x: number, height: () => number, color: number) => ({
      from: { x, y: 0 },
      to: () => ({ x, y: height() / 20 }),
      color,
      width: 18,
    });
    return {
      view: { minX: -9, maxX: 26, minY: -2, maxY: 26 },
      trails: [{ body: ball, length: 300 }],
      lines: [bar(-6, work, COLORS.orange), bar(-3.5, gained, COLORS.blue)],
      arrows: [
        {
          label: 'F',
          from: () => positionOf(world, ball),
          vector: () => ({ x: fx, y: fy }),
          scale: 0.4,
          color: COLORS.orange,
        },
        velocityArrow(world, ball, 0.4),
      ],
      labels: [
        { at: { x: -7, y: -1.6 }, text: 'work', color: COLORS.orange },
        { at: { x: -4.2, y: -1.6 }, text: 'energy', color: COLORS.blue },
      ],
    };
  },
  plots: (plot) => [
    plot(
      'Work and energy of motion',
      'E, J',
      { label: 'work', value: ({ work }) => work() },
      { label: 'energy gained', value: ({ gained }) => gained() },
    ),
    {
      title: 'Power',
      x: { label: 'speed, m/s', value: ({ world, ball }) => speedOf(world, ball) },
      y: { label: 'P, W' },
      series: [{ label: 'power', value: ({ power }) => power() }],
    },
  ],
  checks: ({ at }) => [
    at(
      3,
      'Energy gained less work done, after 3 s',
      { exact: 0, unit: 'J', absolute: 1e-9 },
      ({ gained, work }) => gained() - work(),
    ),
    at(
      3,
      'Work after 3 s, F·(u t + ½ a t²)',
      { exact: ({ fx, fy }) => fx * (3 + (9 * fx) / 4) + fy * (6 + (9 * fy) / 4), unit: 'J', absolute: 1e-9 },
      ({ work }) => work(),
    ),
    at(
      3,
      'Power after 3 s, F·v',
      { exact: ({ fx, fy }) => fx * (1 + (3 * fx) / 2) + fy * (2 + (3 * fy) / 2), unit: 'W', absolute: 1e-9 },
      ({ power }) => power(),
    ),
  ],
  tryThis: [
    'Watch the two bars: they never differ, whatever the force.',
    'Set both forces to 0: the sledge glides on, and no work is done, however far it goes.',
  ],
});
