import { createPhysicsWorld, rgba, spawn } from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { velocityArrow } from '../support/arrows.ts';
import { positionOf } from '../support/read.ts';

const START = { x: 2, y: 3 };

export default defineExample({
  id: 'ch04-particle',
  title: 'One particle, one step at a time',
  chapter: 4,
  tags: ['components', 'velocity', 'integrators'],
  about:
    'A particle is a place, a velocity and a mass. In each step of a tenth of a second its place grows by velocity times time: that is all that a simulation does, again and again. Pause it and step on by hand, with the numbers in view.',
  duration: 4,
  parameters: {
    vx: { label: 'Velocity, x', unit: 'm/s', initial: 2.5, min: -5, max: 5 },
    vy: { label: 'Velocity, y', unit: 'm/s', initial: 4.7, min: -5, max: 5 },
  },
  build({ vx, vy }: ValuesOf<'vx' | 'vy'>, options) {
    const world = createPhysicsWorld({ capacity: 2, ...options });
    const appearance = { size: 0.5, color: rgba(0.43, 0.72, 1) };
    const particle = spawn(world, { position: START, velocity: { x: vx, y: vy }, mass: 1, appearance });
    return { world, dt: 0.1, particle };
  },
  picture({ world, particle }) {
    const at = () => positionOf(world, particle);
    return {
      view: { minX: -1, maxX: 16, minY: -1, maxY: 12 },
      trails: [{ body: particle, length: 100 }],
      arrows: [velocityArrow(world, particle, 0.4)],
      labels: [{ at: { x: 9, y: 1 }, text: () => `(${at().x.toFixed(2)}, ${at().y.toFixed(2)})` }],
    };
  },
  plots: (plot) => [
    plot(
      'Place',
      'place, m',
      {
        label: 'x',
        value: ({ world, particle }) => positionOf(world, particle).x,
        exact: (t, { vx }) => START.x + vx * t,
      },
      {
        label: 'y',
        value: ({ world, particle }) => positionOf(world, particle).y,
        exact: (t, { vy }) => START.y + vy * t,
      },
    ),
  ],
  checks: ({ at }) => [
    at(
      0.1,
      'x after one step, 2 + 2.5 · 0.1',
      { exact: 2.25, unit: 'm', absolute: 1e-15 },
      ({ world, particle }) => positionOf(world, particle).x,
    ),
    at(
      0.1,
      'y after one step, 3 + 4.7 · 0.1',
      { exact: 3.47, unit: 'm', absolute: 1e-15 },
      ({ world, particle }) => positionOf(world, particle).y,
    ),
    at(
      0,
      'Default charge',
      { exact: 0, unit: 'C', absolute: 0 },
      ({ world, particle }) => world.components.Charge.value[particle],
    ),
  ],
  tryThis: ['Pause, and take single steps: where will the next one lead? Reckon it before you press.'],
});
