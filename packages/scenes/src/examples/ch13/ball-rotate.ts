import { cos, createPhysicsWorld, rgba, sin, spawn } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { marks, placeOn } from '../support/outline.ts';
import { distanceBetween, positionOf } from '../support/read.ts';

const RADIUS = 50;
const MARK = { x: RADIUS, y: 0 };

/** How far a mark is from its place after so many small rotations, each of which multiplies by a rounded sine and cosine. */
function strayAfter(rotations: number, step: number): number {
  const [c, s] = [cos(step), sin(step)];
  let [x, y] = [RADIUS, 0];
  for (let i = 0; i < rotations; i++) [x, y] = [c * x - s * y, s * x + c * y];
  const angle = rotations * step;
  return distanceBetween({ x, y }, { x: RADIUS * cos(angle), y: RADIUS * sin(angle) });
}

export default defineExample({
  id: 'ch13-ball-rotate',
  title: 'Turn a ball a million times',
  chapter: 13,
  tags: ['rotation', 'rolling', 'accuracy'],
  about:
    'The marks on the ball turn with it. A program can turn each mark a little further in every step, or keep one angle and compute the marks from it. The first way rounds a little each time; after a million steps the marks are still where they should be, to nine digits, but only because the rounding goes both ways.',
  duration: 60,
  parameters: {
    omega: { label: 'Angular velocity ω', unit: 'rad/s', initial: 0.2, min: 0.05, max: 2 },
    angle: { label: 'Angle at the start', unit: 'rad', initial: 0.6, min: 0, max: 6 },
  },
  presets: [{ label: 'Fast', values: { omega: 2 } }],
  build({ omega, angle }, options) {
    const world = createPhysicsWorld({ capacity: 4, ...options });
    const ball = spawn(world, {
      position: { x: 100, y: RADIUS },
      velocity: { x: omega * RADIUS },
      rotation: angle,
      angularVelocity: -omega,
      mass: 1,
      collider: RADIUS,
      appearance: rgba(0.25, 0.45, 0.95),
    });
    return { world, dt: 0.03, ball, angle };
  },
  picture({ world, ball }) {
    const ends = [0.2, 0.4, 0.6, 0.8, -0.2, -0.4, -0.6, -0.8].flatMap((part) => [
      { x: part * RADIUS, y: 0 },
      { x: 0, y: part * RADIUS },
    ]);
    return {
      view: { minX: 0, maxX: 760, minY: -70, maxY: 230 },
      fills: [{ shape: { minX: -2000, maxX: 9000, minY: -2000, maxY: 0 }, color: COLORS.ground }],
      dots: [...marks(world, ball, ends, COLORS.white), { at: () => placeOn(world, ball, MARK), color: COLORS.red }],
    };
  },
  plots: (plot) => [
    plot('Height of the red mark', 'y, px', {
      label: 'mark',
      value: ({ world, ball }) => placeOn(world, ball, MARK).y,
    }),
  ],
  checks: ({ at }) => [
    // Each rounding of sine and cosine is at most 1.1e-16 of the step's rotation, and they add up a million times.
    at(0, 'How far a mark strays in a million small rotations', { exact: 0, unit: 'px', absolute: 1e-8 }, () =>
      strayAfter(1_000_000, 0.006),
    ),
    at(
      60,
      'Distance of the mark from the middle after 60 s',
      { exact: RADIUS, unit: 'px', relative: 1e-12 },
      ({ world, ball }) => distanceBetween(placeOn(world, ball, MARK), positionOf(world, ball)),
    ),
    at(
      60,
      'Angle turned in 60 s, ω t',
      { exact: ({ omega }) => 60 * omega, unit: 'rad', relative: 1e-9 },
      ({ world, ball, angle }) => angle - world.components.Rotation.angle[ball],
    ),
  ],
  tryThis: [
    'Change the angle at the start: the red mark begins elsewhere, and moves on the same curve.',
    'Choose “Fast”: it rolls ten times as fast and leaves the picture.',
  ],
});
