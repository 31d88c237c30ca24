import { boxWalls, createPhysicsWorld, energy, spawn } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { positionOf, speedOf, velocityOf } from '../support/read.ts';

const ROOM = { minX: 0, maxX: 400, minY: 40, maxY: 360 };
const RADIUS = 15;
/** The velocity at the start, px/s. */
const [VX, VY] = [200, 50];

export default defineExample({
  id: 'ch11-wall-elastic',
  title: 'A ball bounces off a wall',
  chapter: 11,
  tags: ['collision', 'wall', 'restitution', 'energy'],
  about:
    'The wall turns round the part of the velocity that points into it, and leaves the part along it alone. So the ball leaves at the angle at which it came. A wall that is not quite elastic gives back only a part e of the speed, and a part e² of that energy.',
  duration: 6,
  parameters: {
    restitution: { label: 'Restitution e', initial: 1, min: 0, max: 1 },
  },
  presets: [{ label: 'Inelastic wall', values: { restitution: 0.8 } }],
  build({ restitution }, options) {
    const walls = [boxWalls({ min: { x: ROOM.minX, y: ROOM.minY }, max: { x: ROOM.maxX, y: ROOM.maxY }, restitution })];
    const world = createPhysicsWorld({ capacity: 4, walls, ...options });
    const ball = spawn(world, { position: { x: 100, y: 100 }, velocity: { x: VX, y: VY }, mass: 1, collider: RADIUS });
    /** Time since the ball left the wall, from its distance. */
    const since = () => (ROOM.maxX - RADIUS - positionOf(world, ball).x) / -velocityOf(world, ball).x;
    return { world, dt: 1 / 60, ball, since };
  },
  picture({ world, ball }) {
    return {
      yDown: true,
      view: { minX: -30, maxX: 430, minY: 10, maxY: 390 },
      fills: [
        { shape: { minX: -30, maxX: 430, minY: 10, maxY: 390 }, color: COLORS.ground },
        { shape: ROOM, color: 0x0d1226 },
      ],
      trails: [{ body: ball, length: 600 }],
      arrows: [velocityArrow(world, ball, 0.3)],
    };
  },
  plots: (plot) => [
    plot(
      'Velocity',
      'v, px/s',
      { label: 'along x', value: ({ world, ball }) => velocityOf(world, ball).x },
      { label: 'along y', value: ({ world, ball }) => velocityOf(world, ball).y },
    ),
    plot('Energy of motion', 'E, kg px²/s²', { label: 'ball', value: ({ world }) => energy(world).kinetic }),
  ],
  checks: ({ at }) => [
    at(
      2,
      'Time of the bounce',
      { exact: 1.425, unit: 's', absolute: 1e-9 },
      ({ world, since }) => world.time - since(),
    ),
    at(
      2,
      'Height of the bounce',
      { exact: 171.25, unit: 'px', absolute: 1e-9 },
      ({ world, ball, since }) => positionOf(world, ball).y - VY * since(),
    ),
    at(
      2,
      'Speed after the bounce: the same to the last bit',
      { exact: Math.sqrt(VX * VX + VY * VY), unit: 'px/s', absolute: 0 },
      ({ world, ball }) => speedOf(world, ball),
    ),
    at(
      2,
      'Energy lost to an inelastic wall, (1 − e²) ½ m v²',
      { exact: 7200, unit: 'kg px²/s²', relative: 1e-9, preset: 'Inelastic wall' },
      ({ world }) => (VX * VX + VY * VY) / 2 - energy(world).kinetic,
    ),
    at(
      2,
      'Speed along an inelastic wall: unchanged',
      { exact: VY, unit: 'px/s', absolute: 0, preset: 'Inelastic wall' },
      ({ world, ball }) => velocityOf(world, ball).y,
    ),
  ],
  tryThis: [
    'Choose “Inelastic wall”: after each bounce the ball leaves at a flatter angle to the wall.',
    'Set e to 0: the ball slides along the wall.',
  ],
});
