import { cos, createPhysicsWorld, sin, spawn } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS, pointsOf } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { positionOf, velocityOf } from '../support/read.ts';

const RADIUS = 50;
const START = 100;
const SPOKES = 12;
const DURATION = 14;

export default defineExample({
  id: 'ch09-rolling-wheel',
  title: 'Does the wheel roll or skid?',
  chapter: 9,
  tags: ['rotation', 'rolling', 'cycloid'],
  about:
    'A wheel that rolls moves forward by ω R, exactly as fast as its rim turns. Then its lowest point stands still on the road for a moment: that is why tyres grip. If it moves slower or faster than it turns, the lowest point slides, and the wheel skids.',
  duration: DURATION,
  ends: true,
  parameters: {
    factor: { label: 'Speed, in units of ω R', initial: 1, min: 0, max: 2.5 },
    omega: { label: 'Angular speed ω', unit: 'rad/s', initial: 1, min: 0.2, max: 3 },
  },
  presets: [
    { label: 'Spinning on ice', values: { factor: 0.5 } },
    { label: 'Braking on ice', values: { factor: 2 } },
  ],
  build({ factor, omega }, options) {
    const world = createPhysicsWorld({ capacity: 4, ...options });
    const wheel = spawn(world, {
      position: { x: START, y: RADIUS },
      velocity: { x: factor * omega * RADIUS },
      mass: 1,
      rotation: 0,
      angularVelocity: -omega,
    });
    const { Rotation, AngularVelocity } = world.components;
    const angle = () => Rotation.angle[wheel];
    const slip = () => velocityOf(world, wheel).x + RADIUS * AngularVelocity.z[wheel];
    return { world, dt: 0.03, wheel, angle, slip };
  },
  picture({ world, wheel, angle, slip }, { factor }) {
    const rim = (turn: number, radius: number) => () => {
      const { x, y } = positionOf(world, wheel);
      const a = angle() + turn * 2 * Math.PI - Math.PI / 2;
      return { x: x + radius * cos(a), y: y + radius * sin(a) };
    };
    const hub = () => positionOf(world, wheel);
    const path = (a: number) => ({ x: START + RADIUS * (factor * a - sin(a)), y: RADIUS * (1 - cos(a)) });
    const parts = Array.from({ length: 3 * SPOKES }, (_, i) => i / (3 * SPOKES));
    return {
      view: { minX: 0, maxX: 800, minY: -60, maxY: 240 },
      fills: [{ shape: { minX: -3000, maxX: 4000, minY: -2000, maxY: 0 }, color: COLORS.ground }],
      curves: [{ points: pointsOf(path, 0, 14), label: 'path of the red dot', color: COLORS.grey, dashed: true }],
      lines: [
        ...parts.map((turn) => ({
          from: rim(turn, 47),
          to: rim(turn + 1 / (3 * SPOKES), 47),
          width: 7,
          color: COLORS.blue,
        })),
        ...parts.filter((_, i) => i % 3 === 0).map((turn) => ({ from: hub, to: rim(turn, 44), color: COLORS.grey })),
      ],
      dots: [
        { at: rim(0, RADIUS), color: COLORS.red },
        { at: hub, color: COLORS.white },
      ],
      arrows: [
        velocityArrow(world, wheel, 1.5),
        {
          label: 'slip',
          from: () => ({ x: hub().x, y: 0 }),
          vector: () => ({ x: slip(), y: 0 }),
          scale: 1.5,
          color: COLORS.red,
        },
      ],
    };
  },
  plots: (plot) => [
    plot(
      'Speed of the hub and of the lowest point',
      'v, px/s',
      { label: 'hub', value: ({ world, wheel }) => velocityOf(world, wheel).x },
      { label: 'lowest point', value: ({ slip }) => slip() },
    ),
  ],
  checks: ({ at }) => [
    {
      label: 'Distance in one turn, 2πR',
      unit: 'px',
      exact: ({ factor }) => factor * 2 * Math.PI * RADIUS,
      holds: ({ omega }) => omega * DURATION > 2 * Math.PI,
      tolerance: { absolute: 1e-6 },
      at: { event: ({ angle }) => -angle() - 2 * Math.PI },
      measure: ({ world, wheel }) => positionOf(world, wheel).x - START,
    },
    at(
      3,
      'Speed of the lowest point',
      { exact: ({ factor, omega }) => (factor - 1) * omega * RADIUS, unit: 'px/s', absolute: 1e-12 },
      ({ slip }) => slip(),
    ),
    at(
      3,
      'Slip of a wheel that spins on ice',
      { exact: -25, unit: 'px/s', absolute: 1e-12, preset: 'Spinning on ice' },
      ({ slip }) => slip(),
    ),
    at(
      3,
      'Slip of a wheel that brakes on ice',
      { exact: 50, unit: 'px/s', absolute: 1e-12, preset: 'Braking on ice' },
      ({ slip }) => slip(),
    ),
  ],
  tryThis: [
    'Follow the red dot: a point of a rolling wheel stands still where it touches the road.',
    'Choose “Spinning on ice”: the red dot moves backwards at the bottom, on a path with loops.',
  ],
});
