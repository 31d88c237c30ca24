import { cos, createPhysicsWorld, periodicDrive, sin, spawn, velocityVerlet } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS, type Point } from '../picture.ts';
import { lengthOf, positionOf, velocityOf } from '../support/read.ts';

export default defineExample({
  id: 'ch04-equilibrium',
  title: 'Three tugs that cancel',
  chapter: 4,
  tags: ['forces', 'equilibrium'],
  about:
    'Three ropes pull at a puck, equally strongly and 120° apart. Put their arrows tip to tail, as at the lower left: they close to a triangle, so nothing is left over, and the puck glides on as if nobody pulled. Equilibrium does not mean rest, but that the velocity stays as it is.',
  duration: 8,
  parameters: {
    third: { label: 'Strength of the third rope', unit: 'N', initial: 1, min: 0, max: 2 },
    speed: { label: 'Speed at the start', unit: 'm/s', initial: 0.5, min: 0, max: 1 },
  },
  presets: [{ label: 'One pulls harder', values: { third: 1.2 } }],
  build({ third, speed }: ValuesOf<'third' | 'speed'>, { integrator = velocityVerlet }: BuildOptions) {
    const pulls: Point[] = [1, 1, third].map((strength, i) => {
      const angle = (2 * Math.PI * i) / 3;
      return { x: strength * cos(angle), y: strength * sin(angle) };
    });
    const forces = pulls.map((cosine) => periodicDrive({ cosine, angularFrequency: 0 }));
    const world = createPhysicsWorld({ capacity: 4, forces, integrator });
    const ball = spawn(world, { position: { x: -2 }, velocity: { x: speed }, mass: 1, collider: 0.25 });
    const resultant = pulls.reduce((sum, { x, y }) => ({ x: sum.x + x, y: sum.y + y }), { x: 0, y: 0 });
    return { world, dt: 1 / 60, ball, pulls, resultant };
  },
  picture({ world, ball, pulls, resultant }) {
    const at = () => positionOf(world, ball);
    const colors = [COLORS.blue, COLORS.orange, COLORS.violet];
    const corner = { x: -3, y: -2 };
    const tail = (i: number) => pulls.slice(0, i).reduce(({ x, y }, p) => ({ x: x + p.x, y: y + p.y }), corner);
    return {
      view: { minX: -3.5, maxX: 4.5, minY: -2.5, maxY: 2.5 },
      trails: [{ body: ball, length: 480 }],
      arrows: [
        ...pulls.map((pull, i) => ({ label: '', from: at, vector: () => pull, color: colors[i] })),
        ...pulls.map((pull, i) => ({ label: '', from: tail(i), vector: () => pull, color: colors[i] })),
        { label: 'sum', from: at, vector: () => resultant, color: COLORS.red },
        { label: 'v', from: at, vector: () => velocityOf(world, ball), color: COLORS.green },
      ],
    };
  },
  plots: (plot) => [
    plot(
      'Velocity',
      'v, m/s',
      { label: 'to the right', value: ({ world, ball }) => velocityOf(world, ball).x },
      { label: 'upwards', value: ({ world, ball }) => velocityOf(world, ball).y },
    ),
  ],
  checks: ({ at }) => [
    // 480 steps of an acceleration below 1e-14.
    at(
      8,
      'Change of the velocity in 8 s, over the time',
      { exact: 0, unit: 'm/s²', absolute: 1e-14 },
      ({ world, ball }) => lengthOf({ x: velocityOf(world, ball).x - 0.5, y: velocityOf(world, ball).y }) / 8,
    ),
    at(
      0,
      'Resultant of the three forces',
      { exact: ({ third }) => Math.abs(third - 1), unit: 'N', absolute: 1e-14 },
      ({ resultant }) => lengthOf(resultant),
    ),
  ],
  tryThis: [
    'Let the third pull harder: the triangle does not close any more, and the puck curves away.',
    'Set the speed to 0: the puck stays at rest, and that is equilibrium, too.',
  ],
});
