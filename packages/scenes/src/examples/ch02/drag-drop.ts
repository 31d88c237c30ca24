import { spawn, velocityVerlet } from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { positionOf, velocityOf } from '../support/read.ts';
import { GROUND, RADIUS, STAGE_VIEW, stageWorld } from '../support/stage.ts';

const FLOOR = 480;
type Values = ValuesOf<'height' | 'gravity' | 'restitution'>;
const fallTime = ({ height, gravity }: Values) => Math.sqrt((2 * height) / gravity);

export default defineExample({
  id: 'ch02-drag-drop',
  title: 'Pick it up and drop it',
  chapter: 2,
  tags: ['bounce', 'control', 'energy'],
  about:
    'The ball is let go at rest, and bounces up to 64 % of its height: it keeps 80 % of its speed, and the height goes with the square of the speed. Drag it with the mouse or a finger to wherever you like, and let it go or throw it.',
  duration: 10,
  parameters: {
    height: { label: 'Height of the drop', unit: 'px', initial: 400, min: 50, max: 450 },
    gravity: { label: 'Gravity', unit: 'px/s²', initial: 360, min: 60, max: 900 },
    restitution: { label: 'Speed kept in a bounce', initial: 0.8, min: 0.1, max: 0.95 },
  },
  presets: [{ label: 'On the Moon', values: { gravity: 60 } }],
  build({ height, gravity, restitution }, { integrator = velocityVerlet }) {
    const world = stageWorld(gravity, { integrator });
    const collider = { radius: RADIUS, restitution };
    const ball = spawn(world, { position: { x: 350, y: FLOOR - height }, velocity: {}, mass: 1, collider });
    return { world, dt: 1 / 120, ball };
  },
  picture: ({ world, ball }, { height, restitution }) => ({
    yDown: true,
    view: STAGE_VIEW,
    fills: [GROUND],
    lines: [height, height * restitution * restitution].map((h) => ({
      from: { x: 200, y: FLOOR - h },
      to: { x: 500, y: FLOOR - h },
      color: COLORS.grey,
      width: 1,
    })),
    labels: [
      { at: { x: 505, y: FLOOR - height + 8 }, text: 'let go here' },
      { at: { x: 505, y: FLOOR - height * restitution * restitution + 8 }, text: 'comes back to here' },
    ],
    trails: [{ body: ball, length: 200 }],
    arrows: [velocityArrow(world, ball, 0.2)],
  }),
  plots: (plot) => [
    plot('Height', 'height, px', { label: 'height', value: ({ world, ball }) => FLOOR - positionOf(world, ball).y }),
  ],
  checks: [
    {
      label: 'Height of the first apex and that of the drop, e²',
      exact: 0.64,
      tolerance: { relative: 1e-3 },
      at: { event: ({ world, ball }) => velocityOf(world, ball).y },
      measure: ({ world, ball }) => (FLOOR - positionOf(world, ball).y) / 400,
    },
    {
      label: 'Time of the first apex, t₁ (1 + e)',
      unit: 's',
      exact: (values) => fallTime(values) * (1 + values.restitution),
      tolerance: { relative: 1e-3 },
      at: { event: ({ world, ball }) => velocityOf(world, ball).y },
    },
  ],
  tryThis: [
    'Throw the ball upwards with the mouse: it takes the speed of your hand with it.',
    'Set the gravity to that of the Moon, a sixth: the ball needs √6 = 2.4 times as long, but comes back as high.',
  ],
});
