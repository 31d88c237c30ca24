import {
  createPhysicsWorld,
  energy,
  momentum,
  particleContacts,
  rgba,
  spawn,
  velocityVerlet,
} from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { positionOf, velocityOf } from '../support/read.ts';

const RADIUS = 15;
type Values = ValuesOf<'left' | 'middle' | 'right' | 'restitution'>;

export default defineExample({
  id: 'ch05-elastic-1d',
  title: 'Three balls hand on their velocities',
  chapter: 5,
  tags: ['collisions', 'momentum', 'energy'],
  about:
    'When two equal balls meet head-on and nothing is lost, they exchange their velocities, as if each ran through the other. Look at the plot: the lines go straight on through each crossing, only the colours change. In the end the velocities are sorted, and nobody can meet any more.',
  duration: 13,
  parameters: {
    left: { label: 'Velocity of the left ball', unit: 'px/s', initial: 30, min: 0, max: 60 },
    middle: { label: 'Velocity of the middle ball', unit: 'px/s', initial: 10, min: -30, max: 30 },
    right: { label: 'Velocity of the right ball', unit: 'px/s', initial: -20, min: -60, max: 0 },
    restitution: { label: 'Speed kept in a collision', initial: 1, min: 0, max: 1 },
  },
  presets: [
    { label: 'Newton’s cradle', values: { left: 40, middle: 0, right: 0 } },
    { label: 'Lumps of clay', values: { restitution: 0 } },
  ],
  build({ left, middle, right, restitution }: Values, { integrator = velocityVerlet }: BuildOptions) {
    const world = createPhysicsWorld({ preset: particleContacts, capacity: 8, integrator });
    const colors = [rgba(0.42, 0.72, 1), rgba(0.37, 0.84, 0.64), rgba(1, 0.48, 0.45)];
    const balls = [
      { x: 50, speed: left },
      { x: 300, speed: middle },
      { x: 500, speed: right },
    ].map(({ x, speed }, i) =>
      spawn(world, {
        position: { x, y: 200 },
        velocity: { x: speed },
        mass: 1,
        collider: { radius: RADIUS, restitution },
        appearance: colors[i],
      }),
    );
    const speed = (i: number) => velocityOf(world, balls[i]).x;
    const start = { momentum: momentum(world).x, energy: energy(world).kinetic };
    return { world, dt: 1 / 60, balls, speed, start };
  },
  picture: ({ world, balls }) => ({
    yDown: true,
    view: { minX: 0, maxX: 650, minY: 40, maxY: 360 },
    lines: [{ from: { x: -50, y: 216 }, to: { x: 700, y: 216 } }],
    arrows: balls.map((id) => ({
      label: 'v',
      from: () => ({ x: positionOf(world, id).x, y: 170 }),
      vector: () => velocityOf(world, id),
      scale: 2,
    })),
  }),
  plots: (plot) => [
    plot(
      'Where the balls are',
      'x, px',
      ...['left', 'middle', 'right'].map((label, i) => ({
        label,
        value: ({ world, balls }: { world: Parameters<typeof positionOf>[0]; balls: readonly number[] }) =>
          positionOf(world, balls[i]).x,
      })),
    ),
  ],
  checks: ({ at, largest }) => [
    {
      label: 'First contact: the middle and the right ball, 170/30 s',
      unit: 's',
      exact: 17 / 3,
      tolerance: { absolute: 1 / 60 },
      at: { event: ({ speed }) => speed(2) },
    },
    {
      label: 'Second contact: the left and the middle ball',
      unit: 's',
      exact: 7.8,
      tolerance: { absolute: 1 / 60 },
      at: { event: ({ speed }) => -speed(0) },
    },
    {
      label: 'Third contact: the middle and the right ball again',
      unit: 's',
      exact: 11,
      tolerance: { absolute: 1 / 60 },
      at: { event: ({ speed }) => speed(2) - 20 },
    },
    ...[-20, 10, 30].map((exact, i) =>
      at(
        13,
        `Velocity of the ${['left', 'middle', 'right'][i]} ball in the end`,
        { exact, unit: 'px/s', absolute: 1e-12 },
        ({ speed }: { speed(i: number): number }) => speed(i),
      ),
    ),
    largest(
      13,
      'Largest change of the momentum, 20 kg px/s',
      { exact: 0, unit: 'kg px/s', absolute: 1e-12 },
      ({ world, start }) => Math.abs(momentum(world).x - start.momentum),
    ),
    largest(
      13,
      'Largest change of the energy, 700 kg px²/s²',
      { exact: 0, unit: 'kg px²/s²', absolute: 1e-10 },
      ({ world, start }) => Math.abs(energy(world).kinetic - start.energy),
    ),
  ],
  tryThis: [
    'Choose Newton’s cradle: the left ball stops dead, and the right one flies off with its velocity.',
    'Let the balls be of clay: they stick together, the momentum stays, and most of the energy is gone.',
  ],
});
