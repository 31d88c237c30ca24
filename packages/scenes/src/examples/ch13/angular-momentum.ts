import { angularMomentum, createPhysicsWorld, energy, rgba, spawn, springs } from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { distanceBetween, positionOf, velocityOf } from '../support/read.ts';

const [START, STIFFNESS] = [100, 1000];
/** The arms are pulled in between these times, s. */
const [FROM, TO] = [6, 9];

type Values = ValuesOf<'radius' | 'spin'>;

/** Angular velocity with the arms at a radius, where L = 2 m r² ω stays. */
const spinAt = (radius: number, { spin }: Values) => (spin * START * START) / (radius * radius);
/** Natural length of a spring that holds both weights of 1 kg on a circle of this radius. */
const lengthFor = (radius: number, omega: number) => 2 * radius - (omega * omega * radius) / STIFFNESS;

export default defineExample({
  id: 'ch13-angular-momentum',
  title: 'The skater pulls in the arms',
  chapter: 13,
  tags: ['rotation', 'angular momentum', 'energy', 'moment of inertia'],
  about:
    'Two weights go round, held by a spring as by the arms of a skater. When the arms are pulled in, the weights turn faster: the angular momentum I ω stays, and where I halves ω doubles. The energy grows, because pulling the arms in is work.',
  duration: 20,
  parameters: {
    radius: { label: 'Arms pulled in to', unit: 'px', initial: START * Math.SQRT1_2, min: 40, max: 130 },
    spin: { label: 'Angular velocity at first', unit: 'rad/s', initial: 1, min: 0.3, max: 2 },
  },
  presets: [
    { label: 'To half the length', values: { radius: START / 2 } },
    { label: 'Stretched out', values: { radius: 130 } },
  ],
  build(values, options) {
    const { radius, spin } = values;
    const world = createPhysicsWorld({ capacity: 5, forces: [springs()], ...options });
    const weight = (side: 1 | -1) =>
      spawn(world, {
        position: { x: side * START },
        velocity: { y: side * spin * START },
        mass: 1,
        collider: 9,
        appearance: rgba(1, 0.7, 0.35),
      });
    const [left, right] = [weight(-1), weight(1)];
    const [long, short] = [lengthFor(START, spin), lengthFor(radius, spinAt(radius, values))];
    const spring = { a: left, b: right, stiffness: STIFFNESS, damping: 20, length: long };
    const arms = spawn(world, { spring });
    world.phases.input.push(() => {
      const share = Math.min(1, Math.max(0, (world.time - FROM) / (TO - FROM)));
      world.components.Spring.length[arms] = long + share * (short - long);
    });
    const omega = () => {
      const [p, v] = [positionOf(world, right), velocityOf(world, right)];
      return (p.x * v.y - p.y * v.x) / (p.x * p.x + p.y * p.y);
    };
    const inertia = () => {
      const gap = distanceBetween(positionOf(world, left), positionOf(world, right));
      return (gap * gap) / 2;
    };
    return { world, dt: 1 / 480, left, right, omega, inertia };
  },
  picture({ world, left, right }) {
    return {
      view: { minX: -190, maxX: 190, minY: -145, maxY: 145 },
      lines: [
        { from: () => positionOf(world, left), to: () => positionOf(world, right), width: 5, color: COLORS.grey },
      ],
      dots: [{ at: { x: 0, y: 0 }, radius: 12, color: COLORS.blue }],
      trails: [{ body: right, length: 500, interval: 4 }],
      arrows: [velocityArrow(world, left, 0.4), velocityArrow(world, right, 0.4)],
    };
  },
  plots: (plot) => [
    plot('Angular velocity', 'ω, rad/s', { label: 'weights', value: ({ omega }) => omega() }),
    plot('Energy of motion', 'E, kg px²/s²', { label: 'weights', value: ({ world }) => energy(world).kinetic }),
  ],
  checks: ({ at }) => [
    at(
      20,
      'Angular momentum after 20 s, 2 m r² ω',
      { exact: ({ spin }) => 2 * START * START * spin, unit: 'kg px²/s', relative: 1e-12 },
      ({ world }) => angularMomentum(world).z,
    ),
    at(
      20,
      'Angular velocity after 20 s: doubled, as I is halved',
      { exact: (values) => spinAt(values.radius, values), unit: 'rad/s', relative: 1e-3 },
      ({ omega }) => omega(),
    ),
    at(
      20,
      'Moment of inertia after 20 s',
      { exact: ({ radius }) => 2 * radius * radius, unit: 'kg px²', relative: 1e-3 },
      ({ inertia }) => inertia(),
    ),
  ],
  tryThis: [
    'Choose “To half the length”: the weights turn four times as fast, and have four times the energy.',
    'Choose “Stretched out”: the skater slows down, as at the end of a pirouette.',
  ],
});
