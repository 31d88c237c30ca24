import {
  cos,
  createJoint,
  createPhysicsWorld,
  distance,
  energy,
  momentum,
  rgba,
  rigidBodies,
  sin,
  spawn,
  uniformGravity,
} from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS, type Point } from '../picture.ts';
import { positionOf, velocityOf } from '../support/read.ts';

type Values = ValuesOf<'pulled' | 'degrees' | 'restitution'>;

const [COUNT, RADIUS, LENGTH, GRAVITY] = [5, 0.05, 0.5, 9.81];
/** Between balls at rest, m: so small that they meet one after the other, as real ones do. */
const GAP = 1e-4;
const PIVOTS = Array.from({ length: COUNT }, (_, i) => ({ x: (i - (COUNT - 1) / 2) * (2 * RADIUS + GAP), y: 0 }));

/** Speed at the lowest point, √(2 g L (1 − cos φ)). */
const lowest = (degrees: number) => Math.sqrt(2 * GRAVITY * LENGTH * (1 - cos((degrees * Math.PI) / 180)));

export default defineExample({
  id: 'ch17-newtons-cradle',
  title: 'Newton’s cradle',
  chapter: 17,
  tags: ['collision', 'momentum', 'energy', 'pendulum'],
  about:
    'Pull one ball aside and let it go: on the other side one flies off, just as fast. Two go in, and two come out. Momentum alone would allow one to come out with twice the speed, but then the energy would be twice as large. Mersenne’s and Huygens’ balls never read either law: each hands its velocity to the next.',
  duration: 12,
  parameters: {
    pulled: { label: 'Balls pulled aside', initial: 1, min: 1, max: 4, integer: true },
    degrees: { label: 'Pulled aside by', unit: '°', initial: 40, min: 5, max: 60 },
    restitution: { label: 'Restitution e', initial: 1, min: 0, max: 1 },
  },
  presets: [
    { label: 'Two balls', values: { pulled: 2 } },
    { label: 'Three balls', values: { pulled: 3 } },
    { label: 'Balls of clay', values: { restitution: 0 } },
  ],
  build({ pulled, degrees, restitution }: Values) {
    const world = createPhysicsWorld({
      preset: rigidBodies,
      capacity: 16,
      forces: [uniformGravity({ y: -GRAVITY })],
    });
    const angle = (-degrees * Math.PI) / 180;
    const balls = PIVOTS.map((pivot, i) => {
      const aside = i < pulled ? angle : 0;
      const position = { x: pivot.x + LENGTH * sin(aside), y: -LENGTH * cos(aside) };
      const collider = { radius: RADIUS, restitution, friction: 0 };
      const ball = spawn(world, { position, velocity: {}, mass: 1, collider, appearance: rgba(0.75, 0.8, 0.9) });
      createJoint(world, distance({ b: ball, anchorA: pivot, length: LENGTH }));
      return ball;
    });
    const speed = (i: number) => velocityOf(world, balls[i]).x;
    return { world, dt: 1 / 240, balls, speed, start: energy(world).total };
  },
  picture({ world, balls }) {
    const strings = PIVOTS.flatMap((pivot, i) => ({
      from: pivot as Point,
      to: () => positionOf(world, balls[i]),
      width: 1,
    }));
    const beam = { from: { x: -0.4, y: 0 }, to: { x: 0.4, y: 0 }, color: COLORS.grey, width: 6 };
    return { view: { minX: -0.75, maxX: 0.75, minY: -0.65, maxY: 0.1 }, lines: [...strings, beam] };
  },
  plots: (plot) => [
    plot(
      'Velocity',
      'v, m/s',
      { label: 'first', value: ({ speed }) => speed(0) },
      { label: 'middle', value: ({ speed }) => speed(2) },
      { label: 'last', value: ({ speed }) => speed(4) },
    ),
    plot('Total energy', 'E, J', { label: 'total', value: ({ world }) => energy(world).total }),
  ],
  checks: ({ at, largest }) => [
    largest(
      0.5,
      'Fastest of the first ball, √(2gL(1 − cos φ))',
      { exact: ({ degrees }) => lowest(degrees), unit: 'm/s', relative: 1e-3 },
      ({ speed }) => speed(0),
    ),
    largest(
      0.6,
      'Fastest of the last ball: the same',
      { exact: lowest(40), unit: 'm/s', relative: 1e-3 },
      ({ speed }) => speed(4),
    ),
    at(0.6, 'Speed of the other four meanwhile', { exact: 0, unit: 'm/s', absolute: 0.01 }, ({ speed }) =>
      Math.max(...[0, 1, 2, 3].map((i) => Math.abs(speed(i)))),
    ),
    at(
      0.6,
      'Two out for two in: slower of the last two by the faster one',
      { exact: 1, relative: 0.01, preset: 'Two balls' },
      ({ speed }) => Math.min(speed(3), speed(4)) / Math.max(speed(3), speed(4)),
    ),
    // The jerks of the strings take some.
    at(
      10,
      'Change of the energy in 10 s, as a fraction of the energy at the start',
      { exact: 0, absolute: 1e-3 },
      ({ world, start }) => (energy(world).total - start) / (start + COUNT * GRAVITY * LENGTH),
    ),
    {
      label: 'Speed of all balls of clay after the first blow, a fifth',
      unit: 'm/s',
      exact: lowest(40) / 5,
      tolerance: { relative: 0.02 },
      at: { event: ({ speed }) => speed(4) - 1e-3, count: 1 },
      measure: ({ world }) => momentum(world).x / COUNT,
      preset: 'Balls of clay',
    },
  ],
  tryThis: [
    'Choose “Three balls”: the ball in the middle never rests, it comes with two and goes with two.',
    'Choose “Balls of clay”: they stick, and four fifths of the energy are gone at the first blow.',
    'Set the restitution to 0.95: after some blows all swing together.',
  ],
});
