import { cos, createPhysicsWorld, particleContacts, rgba, sin, spawn } from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { lengthOf, velocityOf } from '../support/read.ts';

const [A, B] = [
  { x: 100, y: 200 },
  { x: 250, y: 400 },
];
const WAY = { x: B.x - A.x, y: B.y - A.y };
const LENGTH = lengthOf(WAY);
/** Unit vector at a right angle to the wall. */
const NORMAL = { x: WAY.y / LENGTH, y: -WAY.x / LENGTH };
const MIDDLE = { x: (A.x + B.x) / 2, y: (A.y + B.y) / 2 };
const [SPEED, RADIUS] = [150, 12];

export default defineExample({
  id: 'ch11-wall-object',
  title: 'A wall has a direction and a normal',
  chapter: 11,
  tags: ['wall', 'vectors', 'collision'],
  about:
    'Two points make a wall. Two unit vectors say the rest: one along it, and one at a right angle to it, the normal. The part of a velocity along the normal turns round at the wall, and the part along the wall stays. That is the whole law of reflection, however the wall stands.',
  duration: 4,
  ends: true,
  parameters: { angle: { label: 'Direction from which it comes', unit: '°', initial: 20, min: -60, max: 60 } },
  build({ angle }: ValuesOf<'angle'>, options) {
    const world = createPhysicsWorld({ preset: particleContacts, capacity: 4, ...options });
    spawn(world, { segmentWall: { ax: A.x, ay: A.y, bx: B.x, by: B.y, restitution: 1, friction: 0 } });
    const turn = (angle * Math.PI) / 180;
    const [c, s] = [cos(turn), sin(turn)];
    const towards = { x: -(c * NORMAL.x - s * NORMAL.y), y: -(s * NORMAL.x + c * NORMAL.y) };
    const ball = spawn(world, {
      position: { x: MIDDLE.x - 220 * towards.x, y: MIDDLE.y - 220 * towards.y },
      velocity: { x: SPEED * towards.x, y: SPEED * towards.y },
      mass: 1,
      collider: { radius: RADIUS, restitution: 1, friction: 0 },
      appearance: rgba(1, 0.7, 0.3),
    });
    const part = (axis: { x: number; y: number }) => {
      const v = velocityOf(world, ball);
      return v.x * axis.x + v.y * axis.y;
    };
    const along = { x: WAY.x / LENGTH, y: WAY.y / LENGTH };
    return { world, dt: 1 / 60, ball, along: () => part(along), against: () => part(NORMAL) };
  },
  picture: ({ world, ball }) => ({
    view: { minX: 0, maxX: 520, minY: 80, maxY: 440 },
    lines: [{ from: A, to: B, color: COLORS.white, width: 4 }],
    trails: [{ body: ball, length: 400 }],
    arrows: [
      { label: 'normal', from: MIDDLE, vector: () => NORMAL, scale: 60, color: COLORS.green },
      {
        label: 'along',
        from: A,
        vector: () => ({ x: WAY.x / LENGTH, y: WAY.y / LENGTH }),
        scale: 60,
        color: COLORS.violet,
      },
      velocityArrow(world, ball, 0.4),
    ],
  }),
  plots: (plot) => [
    plot(
      'The two parts of the velocity',
      'v, px/s',
      { label: 'along the wall', value: ({ along }) => along() },
      { label: 'along the normal', value: ({ against }) => against() },
    ),
  ],
  checks: ({ at }) => [
    at(0, 'Normal of the wall, x', { exact: 0.8, absolute: 1e-15 }, () => NORMAL.x),
    at(0, 'Normal of the wall, y', { exact: -0.6, absolute: 1e-15 }, () => NORMAL.y),
    at(0, 'Normal times direction', { exact: 0, absolute: 1e-13 }, () => NORMAL.x * WAY.x + NORMAL.y * WAY.y),
    at(
      3,
      'Velocity along the wall after the bounce, v sin α',
      { exact: ({ angle }) => -SPEED * sin((angle * Math.PI) / 180), unit: 'px/s', absolute: 1e-9 },
      ({ along }) => along(),
    ),
    at(
      3,
      'Velocity along the normal after the bounce, v cos α',
      { exact: ({ angle }) => SPEED * cos((angle * Math.PI) / 180), unit: 'px/s', absolute: 1e-9 },
      ({ against }) => against(),
    ),
  ],
  tryThis: ['Let it come along the normal, at 0°: it goes back the way it came.'],
});
