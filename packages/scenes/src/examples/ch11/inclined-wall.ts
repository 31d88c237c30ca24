import { spawn, wallContacts } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { velocityArrow } from '../support/arrows.ts';
import { positionOf, speedOf, velocityOf } from '../support/read.ts';
import { linesOf, worldWithWalls } from '../support/walls.ts';

const WALL = [50, 200, 700, 500] as const;
const GRAVITY = 100;
/** When the ball of the book touches the wall for the first time, s. */
const CONTACT = 1.7695;
/** Direction of the wall. */
const ALONG = { x: 650 / Math.sqrt(512_500), y: 300 / Math.sqrt(512_500) };

export default defineExample({
  id: 'ch11-inclined-wall',
  title: 'Down a slope in bounces',
  chapter: 11,
  tags: ['collision', 'wall', 'restitution', 'gravity'],
  about:
    'A ball falls on an inclined wall. The wall turns round the part of the velocity across it and keeps the part along it, so the ball is thrown to the side. With a restitution below one the bounces become lower, until the ball slides.',
  duration: 8,
  parameters: {
    restitution: { label: 'Restitution e', initial: 0.8, min: 0, max: 1 },
    radius: { label: 'Radius of the ball', unit: 'px', initial: 15, min: 3, max: 40 },
    x: { label: 'Dropped at x', unit: 'px', initial: 100, min: 60, max: 600 },
  },
  presets: [{ label: 'Elastic', values: { restitution: 1 } }],
  build({ restitution, radius, x }, options) {
    const world = worldWithWalls([WALL], { gravity: GRAVITY, capacity: 8, ...options });
    const ball = spawn(world, { position: { x, y: 50 }, velocity: {}, mass: 1, collider: { radius, restitution } });
    /** Velocity just after the first bounce. */
    const rebound = () => {
      const v = velocityOf(world, ball);
      return { x: v.x, y: v.y - GRAVITY * (world.time - CONTACT) };
    };
    return { world, dt: 1 / 60, ball, rebound };
  },
  picture({ world, ball }) {
    return {
      yDown: true,
      view: { minX: 20, maxX: 780, minY: 20, maxY: 540 },
      lines: linesOf([WALL]),
      trails: [{ body: ball, length: 600 }],
      arrows: [velocityArrow(world, ball, 0.4)],
    };
  },
  plots: (plot) => [
    plot('Speed', 'v, px/s', { label: 'ball', value: ({ world, ball }) => speedOf(world, ball) }),
    plot('Height', 'y, px', { label: 'ball', value: ({ world, ball }) => -positionOf(world, ball).y }),
  ],
  checks: ({ at, largest }) => [
    // The ball dropped straight down, and has since gone to the right at the same speed.
    at(
      1.8,
      'Time of the first contact, √(2h/g) of a fall of 156.556 px',
      { exact: CONTACT, unit: 's', relative: 1e-3 },
      ({ world, ball }) => world.time - (positionOf(world, ball).x - 100) / velocityOf(world, ball).x,
    ),
    largest(
      1.8,
      'Speed across the wall at the contact',
      { exact: 160.663, unit: 'px/s', relative: 1e-3 },
      ({ world }) => (wallContacts(world).count === 0 ? 0 : wallContacts(world).speed[0]),
    ),
    at(
      1.8,
      'Velocity to the right after the first bounce',
      { exact: 121.189, unit: 'px/s', relative: 1e-3 },
      ({ rebound }) => rebound().x,
    ),
    at(
      1.8,
      'Velocity downwards after it',
      { exact: -85.626, unit: 'px/s', relative: 1e-3 },
      ({ rebound }) => rebound().y,
    ),
    at(
      1.8,
      'The part along the wall, as before the bounce',
      { exact: 74.152, unit: 'px/s', relative: 1e-3 },
      ({ rebound }) => rebound().x * ALONG.x + rebound().y * ALONG.y,
    ),
    at(
      1.8,
      'The part across it, e times that before',
      { exact: 128.531, unit: 'px/s', relative: 1e-3 },
      ({ rebound }) => rebound().x * ALONG.y - rebound().y * ALONG.x,
    ),
  ],
  tryThis: [
    'Choose “Elastic”: the bounces do not become lower, but longer and longer.',
    'Set e to 0: the ball slides down the wall at once.',
  ],
});
