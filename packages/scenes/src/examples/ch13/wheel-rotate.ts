import { createPhysicsWorld, spawn } from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { placeOn, spokes, star } from '../support/outline.ts';
import { positionOf } from '../support/read.ts';

const RIM = 36;
const START = 100;
const DURATION = 12;

const turnsOnce = ({ omega }: ValuesOf<'radius' | 'omega'>) => omega * DURATION > 2 * Math.PI;

export default defineExample({
  id: 'ch13-wheel-rotate',
  title: 'A wheel knows its own angle',
  chapter: 13,
  tags: ['rotation', 'rolling'],
  about:
    'A body that is more than a point has an angle besides its place, and an angular velocity besides its velocity. Both grow evenly here. If they fit together, v = ω R, the wheel rolls: it moves on by its circumference in every turn.',
  duration: DURATION,
  ends: true,
  parameters: {
    radius: { label: 'Radius R', unit: 'px', initial: 50, min: 20, max: 80 },
    omega: { label: 'Angular velocity ω', unit: 'rad/s', initial: 1, min: 0.2, max: 3 },
  },
  presets: [{ label: 'A small wheel', values: { radius: 25 } }],
  build({ radius, omega }, options) {
    const world = createPhysicsWorld({ capacity: 4, ...options });
    const body = { velocity: { x: omega * radius }, rotation: 0, angularVelocity: -omega, mass: 1 };
    const wheel = spawn(world, { position: { x: START, y: radius }, ...body });
    return { world, dt: 0.03, wheel, turned: () => -world.components.Rotation.angle[wheel] };
  },
  picture({ world, wheel }, { radius }) {
    const rim = star(RIM, radius - 4);
    const on = (i: number) => () => placeOn(world, wheel, rim[i % RIM]);
    const turn = 2 * Math.PI * radius;
    return {
      view: { minX: 0, maxX: 760, minY: -70, maxY: 230 },
      fills: [{ shape: { minX: -2000, maxX: 3000, minY: -2000, maxY: 0 }, color: COLORS.ground }],
      lines: [
        ...rim.map((_, i) => ({ from: on(i), to: on(i + 1), width: 8, color: COLORS.blue })),
        ...spokes(world, wheel, star(10, radius - 4), { color: COLORS.grey }),
        { from: { x: START, y: -15 }, to: { x: START + turn, y: -15 }, color: COLORS.yellow },
      ],
      dots: [{ at: () => placeOn(world, wheel, { x: 0, y: -radius }), color: COLORS.red }],
      labels: [{ at: { x: START + turn / 2 - 40, y: -38 }, text: 'one turn: 2πR', color: COLORS.yellow }],
    };
  },
  plots: (plot) => [
    plot('Angle', 'angle, rad', { label: 'wheel', value: ({ turned }) => turned() }),
    plot('Distance', 'x, px', { label: 'wheel', value: ({ world, wheel }) => positionOf(world, wheel).x - START }),
  ],
  checks: [
    {
      label: 'Distance in one turn, 2πR',
      unit: 'px',
      exact: ({ radius }) => 2 * Math.PI * radius,
      holds: turnsOnce,
      tolerance: { absolute: 1e-6 },
      at: { event: ({ turned }) => turned() - 2 * Math.PI },
      measure: ({ world, wheel }) => positionOf(world, wheel).x - START,
    },
    {
      label: 'Time of one turn, 2π/ω',
      unit: 's',
      exact: ({ omega }) => (2 * Math.PI) / omega,
      holds: turnsOnce,
      tolerance: { absolute: 1e-6 },
      at: { event: ({ turned }) => turned() - 2 * Math.PI },
    },
  ],
  tryThis: [
    'Choose “A small wheel”: it has to turn twice for the same distance.',
    'Double ω: angle and distance grow twice as fast.',
  ],
});
