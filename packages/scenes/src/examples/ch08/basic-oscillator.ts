import { createPhysicsWorld, rgba, spawn, springs } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { velocityArrow } from '../support/arrows.ts';
import { distanceBetween, positionOf, speedOf } from '../support/read.ts';

const CENTRE = { x: 350, y: 250 };

export default defineExample({
  id: 'ch08-basic-oscillator',
  title: 'A ball on a spring',
  chapter: 8,
  tags: ['spring', 'oscillation', 'period'],
  about:
    'The spring pulls with k times its length. So a ball that starts twice as far away is pulled twice as hard, and both reach the middle at the same time: the period 2π √(m/k) does not depend on how far it swings. Pushed sideways, it moves on an ellipse about the middle.',
  duration: 20,
  parameters: {
    stiffness: { label: 'Stiffness k', unit: 'N/m', initial: 1, min: 0.2, max: 10 },
    mass: { label: 'Mass m', unit: 'kg', initial: 1, min: 0.2, max: 5 },
    push: { label: 'Velocity to the right', unit: 'px/s', initial: 0, min: 0, max: 300 },
  },
  presets: [{ label: 'Pushed sideways', values: { push: 200 } }],
  build({ stiffness, mass, push }, options) {
    const world = createPhysicsWorld({ capacity: 10, forces: [springs()], ...options });
    const centre = spawn(world, { position: CENTRE, appearance: { size: 6, color: rgba(1, 0.9, 0.5) } });
    const add = (x: number, y: number, color: number) => {
      const body = { position: { x, y }, velocity: { x: push }, mass, collider: 14, appearance: color };
      const ball = spawn(world, body);
      spawn(world, { spring: { a: centre, b: ball, stiffness } });
      return ball;
    };
    const far = add(100, 50, rgba(0.35, 0.7, 1));
    const near = add(430, 310, rgba(1, 0.7, 0.3));
    return { world, dt: 1 / 60, far, near };
  },
  picture({ world, far, near }) {
    return {
      yDown: true,
      view: { minX: 20, maxX: 680, minY: 20, maxY: 480 },
      springs: { coils: 18 },
      trails: [
        { body: far, length: 380 },
        { body: near, length: 380 },
      ],
      arrows: [velocityArrow(world, far, 0.3), velocityArrow(world, near, 0.3)],
    };
  },
  plots: (plot) => [
    plot(
      'Position',
      'x, px',
      { label: 'far', value: ({ world, far }) => positionOf(world, far).x },
      { label: 'near', value: ({ world, near }) => positionOf(world, near).x },
    ),
    plot(
      'Speed',
      'v, px/s',
      { label: 'far', value: ({ world, far }) => speedOf(world, far) },
      { label: 'near', value: ({ world, near }) => speedOf(world, near) },
    ),
  ],
  checks: ({ largest }) => [
    {
      label: 'Period of the far ball, 2π √(m/k)',
      unit: 's',
      exact: ({ stiffness, mass }) => 2 * Math.PI * Math.sqrt(mass / stiffness),
      tolerance: { relative: 1e-3 },
      at: { event: ({ world, far }) => positionOf(world, far).x - CENTRE.x, from: 1, to: 2 },
    },
    {
      label: 'Period of the near ball',
      unit: 's',
      exact: ({ stiffness, mass }) => 2 * Math.PI * Math.sqrt(mass / stiffness),
      tolerance: { relative: 1e-3 },
      at: { event: ({ world, near }) => positionOf(world, near).x - CENTRE.x, from: 1, to: 2 },
    },
    // Distance of the straight line from the start to the ball from the middle, which is the tip of both.
    largest(
      18,
      'How far the ball passes from the middle',
      { exact: 0, unit: 'px', absolute: 1e-9 },
      ({ world, far }) => {
        const { x, y } = positionOf(world, far);
        return Math.abs((x - CENTRE.x) * -200 - (y - CENTRE.y) * -250) / distanceBetween(CENTRE, { x: 100, y: 50 });
      },
    ),
    {
      label: 'Period on the ellipse',
      unit: 's',
      exact: 2 * Math.PI,
      tolerance: { relative: 1e-3 },
      at: { event: ({ world, far }) => positionOf(world, far).y - CENTRE.y, from: 1, to: 2 },
      preset: 'Pushed sideways',
    },
  ],
  tryThis: [
    'Make the ball four times as heavy: it takes twice as long.',
    'Choose “Pushed sideways”: the balls go round on ellipses, and still in the same time.',
  ],
});
