import { createPhysicsWorld, polygon, rgba, spawn } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { areaOf, cornersOf } from '../support/outline.ts';
import { distanceBetween, positionOf } from '../support/read.ts';

/** A house on its side: a square of 200 px with a gable. */
const HOUSE = polygon([
  { x: -100, y: -100 },
  { x: 100, y: -100 },
  { x: 150, y: 0 },
  { x: 100, y: 100 },
  { x: -100, y: 100 },
]);

export default defineExample({
  id: 'ch13-polygon-rotate',
  title: 'A polygon moves and turns',
  chapter: 13,
  tags: ['rotation', 'shapes', 'centre of mass'],
  about:
    'A rigid body moves as its centre of mass does, and turns about it. The corners run on loops, but their distances stay, and so does the area: that is what rigid means. The trail is that of the centre.',
  duration: 30,
  parameters: {
    speed: { label: 'Velocity', unit: 'px/s', initial: 10, min: 0, max: 40 },
    omega: { label: 'Angular velocity ω', unit: 'rad/s', initial: 1, min: -3, max: 3 },
  },
  presets: [{ label: 'Only turning', values: { speed: 0 } }],
  build({ speed, omega }, options) {
    const world = createPhysicsWorld({ capacity: 4, ...options });
    const body = spawn(world, {
      position: { x: 200, y: 250 },
      velocity: { x: speed },
      rotation: 0,
      angularVelocity: omega,
      mass: 1,
      collider: { shape: HOUSE },
      appearance: rgba(0.25, 0.45, 0.95),
    });
    return { world, dt: 1 / 60, body, corners: () => cornersOf(world, body) };
  },
  picture({ world, body, corners }) {
    return {
      view: { minX: 0, maxX: 700, minY: 50, maxY: 450 },
      dots: [0, 1, 2, 3, 4].map((i) => ({ at: () => corners()[i], radius: 4 })),
      trails: [{ body, length: 2000, color: COLORS.white }],
      arrows: [velocityArrow(world, body, 3)],
    };
  },
  plots: [
    {
      title: 'A corner',
      x: { label: 'x, px', value: ({ corners }) => corners()[2].x },
      y: { label: 'y, px' },
      series: [{ label: 'path', value: ({ corners }) => corners()[2].y }],
    },
  ],
  checks: ({ at }) => [
    at(30, 'Area after 30 s', { exact: 45_000, unit: 'px²', relative: 1e-12 }, ({ corners }) => areaOf(corners())),
    at(
      30,
      'Angle after 30 s, ω t',
      { exact: ({ omega }) => 30 * omega, unit: 'rad', absolute: 1e-9 },
      ({ world, body }) => world.components.Rotation.angle[body],
    ),
    // The gable of 5000 px² at 350/3 px and the square of 40000 px² at 0 balance at 350/27 px.
    at(
      30,
      'Distance of the farthest corner from the centre of mass',
      { exact: Math.sqrt((100 + 350 / 27) * (100 + 350 / 27) + 10_000), unit: 'px', relative: 1e-12 },
      ({ world, body, corners }) =>
        corners().reduce((most, corner) => Math.max(most, distanceBetween(corner, positionOf(world, body))), 0),
    ),
  ],
  tryThis: [
    'Turn it faster: the path of a corner, in the plot, gets loops.',
    'Choose “Only turning”: the corners move on circles.',
  ],
});
