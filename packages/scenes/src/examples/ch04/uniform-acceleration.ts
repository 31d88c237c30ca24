import { createPhysicsWorld, rgba, spawn, uniformGravity, velocityVerlet } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { positionOf, velocityOf } from '../support/read.ts';

export default defineExample({
  id: 'ch04-uniform-acceleration',
  title: 'Stepping on the gas',
  chapter: 4,
  tags: ['acceleration', 'velocity'],
  about:
    'The car in front accelerates evenly, by the same amount in each second; the other keeps its speed. Four equations say all about such a motion: v = u + a t, s = u t + ½ a t², v² − u² = 2 a s, and s is the time multiplied by the mean of first and last velocity.',
  duration: 2,
  ends: true,
  parameters: {
    velocity: { label: 'Velocity at the start u', unit: 'm/s', initial: 20, min: 0, max: 30 },
    acceleration: { label: 'Acceleration a', unit: 'm/s²', initial: 10, min: -10, max: 20 },
  },
  presets: [
    { label: 'From rest', values: { velocity: 0 } },
    { label: 'Braking to a stop', values: { acceleration: -10 } },
  ],
  build({ velocity, acceleration }, { integrator = velocityVerlet }) {
    const world = createPhysicsWorld({ capacity: 4, forces: [uniformGravity({ x: acceleration })], integrator });
    const ball = spawn(world, { position: {}, velocity: { x: velocity }, mass: 1, collider: 1.5 });
    // A body without mass keeps its velocity.
    const other = spawn(world, {
      position: { y: -6 },
      velocity: { x: velocity },
      collider: 1.5,
      appearance: rgba(1, 0.7, 0.28),
    });
    return { world, dt: 1 / 120, ball, other };
  },
  picture: ({ world, ball, other }) => ({
    view: { minX: -4, maxX: 66, minY: -20, maxY: 14 },
    fills: [
      { shape: { minX: -200, maxX: 300, minY: -7.7, maxY: -7.5 }, color: COLORS.ground },
      { shape: { minX: -200, maxX: 300, minY: -1.7, maxY: -1.5 }, color: COLORS.ground },
    ],
    arrows: [ball, other].map((id) => velocityArrow(world, id, 0.3)),
  }),
  plots: (plot) => [
    plot('Velocity', 'v, m/s', {
      label: 'v',
      value: ({ world, ball }) => velocityOf(world, ball).x,
      exact: (t, { velocity, acceleration }) => velocity + acceleration * t,
    }),
    plot('Distance', 's, m', {
      label: 's',
      value: ({ world, ball }) => positionOf(world, ball).x,
      exact: (t, { velocity, acceleration }) => velocity * t + (acceleration / 2) * t * t,
    }),
  ],
  checks: ({ at }) => [
    at(
      2,
      'Velocity after 2 s, u + a t',
      { exact: ({ velocity, acceleration }) => velocity + 2 * acceleration, unit: 'm/s', absolute: 1e-11 },
      ({ world, ball }) => velocityOf(world, ball).x,
    ),
    at(
      2,
      'Distance after 2 s, u t + ½ a t²',
      { exact: ({ velocity, acceleration }) => 2 * velocity + 2 * acceleration, unit: 'm', absolute: 1e-11 },
      ({ world, ball }) => positionOf(world, ball).x,
    ),
    at(2, '(v² − u²)/(2 a s)', { exact: 1, absolute: 1e-12 }, ({ world, ball }) => {
      const { x: v } = velocityOf(world, ball);
      return (v * v - 400) / (20 * positionOf(world, ball).x);
    }),
    at(
      2,
      '½ (u + v) t/s',
      { exact: 1, absolute: 1e-12 },
      ({ world, ball }) => (20 + velocityOf(world, ball).x) / positionOf(world, ball).x,
    ),
  ],
  tryThis: [
    'Brake: with −10 m/s² the car stops exactly at the end, after half the distance of the other car.',
    'Start at rest: the distance grows with the square of the time, 5 m after one second and 20 m after two.',
  ],
});
