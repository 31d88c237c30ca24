import { cos, createPhysicsWorld, rgba, rungeKutta4, sin, spawn, stringTension } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS, pointsOf } from '../picture.ts';
import { forceArrow, velocityArrow } from '../support/arrows.ts';
import { positionOf, speedOf } from '../support/read.ts';

export default defineExample({
  id: 'ch09-angular-kinematics',
  title: 'Round and round on a string',
  chapter: 9,
  tags: ['circular motion', 'rotation', 'centripetal force'],
  about:
    'A ball on a string goes round evenly. Its speed is ω r: twice as far out, twice as fast. Its velocity turns all the time, and that takes an acceleration ω² r towards the middle, which the string gives. In a time 2π/ω it is round once.',
  duration: 15,
  parameters: {
    omega: { label: 'Angular velocity ω', unit: 'rad/s', initial: 2, min: 0.2, max: 5 },
    radius: { label: 'Radius r', unit: 'px', initial: 50, min: 20, max: 90 },
  },
  presets: [{ label: 'Twice as fast', values: { omega: 4 } }],
  build({ omega, radius }, { integrator = rungeKutta4 }) {
    const world = createPhysicsWorld({ capacity: 4, forces: [stringTension({ length: radius })], integrator });
    const velocity = { y: omega * radius };
    const ball = spawn(world, {
      position: { x: radius },
      velocity,
      mass: 1,
      collider: 6,
      appearance: rgba(1, 0.7, 0.35),
    });
    return { world, dt: 1 / 240, ball };
  },
  picture({ world, ball }, { omega, radius }) {
    const circle = (a: number) => ({ x: radius * cos(a), y: radius * sin(a) });
    const pull = () => {
      const { x, y } = positionOf(world, ball);
      return { x: -omega * omega * x, y: -omega * omega * y };
    };
    return {
      view: { minX: -130, maxX: 130, minY: -110, maxY: 110 },
      lines: [{ from: { x: 0, y: 0 }, to: () => positionOf(world, ball) }],
      curves: [{ points: pointsOf(circle, 0, 2 * Math.PI), color: COLORS.ground }],
      dots: [{ at: { x: 0, y: 0 }, radius: 4, color: COLORS.grey }],
      arrows: [velocityArrow(world, ball, 0.4), forceArrow(world, ball, 'a', pull, 0.12)],
    };
  },
  plots: (plot) => [
    plot(
      'Place',
      'place, px',
      {
        label: 'x',
        value: ({ world, ball }) => positionOf(world, ball).x,
        exact: (t, { omega, radius }) => radius * cos(omega * t),
      },
      {
        label: 'y',
        value: ({ world, ball }) => positionOf(world, ball).y,
        exact: (t, { omega, radius }) => radius * sin(omega * t),
      },
    ),
  ],
  checks: ({ at }) => [
    {
      label: 'Period, 2π/ω',
      unit: 's',
      exact: ({ omega }) => (2 * Math.PI) / omega,
      tolerance: { relative: 1e-4 },
      at: { event: ({ world, ball }) => positionOf(world, ball).y, from: 1, to: 2 },
    },
    at(
      10,
      'Speed after 10 s, ω r',
      { exact: ({ omega, radius }) => omega * radius, unit: 'px/s', relative: 1e-6 },
      ({ world, ball }) => speedOf(world, ball),
    ),
    {
      label: 'Acceleration ω² r, from the time of a quarter turn: (π/2) v/t',
      unit: 'px/s²',
      exact: 200,
      tolerance: { relative: 1e-3 },
      // An acceleration of constant size turns the velocity by a/v radians a second.
      at: { event: ({ world, ball }) => -positionOf(world, ball).x },
      measure: ({ world, ball }) => (speedOf(world, ball) * (Math.PI / 2)) / world.time,
    },
  ],
  tryThis: [
    'Choose “Twice as fast”: the acceleration becomes four times as large.',
    'Double the radius instead: speed and acceleration double, and the period stays.',
  ],
});
