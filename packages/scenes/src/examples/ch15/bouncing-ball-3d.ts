import { boxWalls, createPhysicsWorld, spawn, uniformGravity, velocityVerlet } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { type BallRun, positionOf, velocityOf } from '../support/read.ts';

const RADIUS = 20;
const WALL = -100;
const REST = WALL + RADIUS;
const START = 100;
const DT = 1 / 60;

export default defineExample({
  id: 'ch15-bouncing-ball-3d',
  title: 'A ball in a corner of space',
  chapter: 15,
  tags: ['3D', 'bounce', 'gravity'],
  about:
    'The corner has a floor and two walls. Each of them only turns round the part of the velocity that points into it, and leaves 90 % of it; the two other parts go on unchanged. So the motion in space is three motions in one: up and down with gravity, and two even ones.',
  dimensions: 3,
  duration: 15,
  parameters: {
    gravity: { label: 'Gravity', unit: 'px/s²', initial: 20, min: 0, max: 60 },
    restitution: { label: 'Speed kept in a bounce', initial: 0.9, min: 0.2, max: 1 },
    speed: { label: 'Speed to both walls', unit: 'px/s', initial: 20, min: 0, max: 60 },
  },
  presets: [{ label: 'No gravity', values: { gravity: 0 } }],
  build(
    { gravity, restitution, speed }: ValuesOf<'gravity' | 'restitution' | 'speed'>,
    { integrator = velocityVerlet }: BuildOptions,
  ) {
    const walls = [boxWalls({ min: { x: WALL, y: WALL, z: WALL } })];
    const forces = [uniformGravity({ y: -gravity })];
    const world = createPhysicsWorld({ dimensions: 3, capacity: 4, forces, walls, integrator });
    const collider = { radius: RADIUS, restitution };
    const velocity = { x: -speed, z: -speed };
    const ball = spawn(world, { position: { x: START }, velocity, mass: 1, collider });
    return { world, dt: DT, ball };
  },
  picture: ({ world, ball }) => {
    const view = { minX: WALL, maxX: 120, minY: WALL, maxY: 60, minZ: WALL, maxZ: 100 };
    return {
      view,
      fills: [
        { shape: { ...view, maxY: WALL }, color: COLORS.ground, opacity: 0.9 },
        { shape: { ...view, maxX: WALL }, color: COLORS.blue, opacity: 0.3 },
        { shape: { ...view, maxZ: WALL }, color: COLORS.violet, opacity: 0.3 },
      ],
      trails: [{ body: ball, length: 900 }],
      lines: [
        {
          from: () => positionOf(world, ball),
          to: () => ({ ...positionOf(world, ball), y: WALL }),
          color: COLORS.yellow,
        },
      ],
      arrows: [velocityArrow(world, ball, 1)],
    };
  },
  plots: (plot) => [
    plot(
      'Distances from the floor and from the walls',
      'distance, px',
      { label: 'floor', value: ({ world, ball }) => positionOf(world, ball).y - REST },
      { label: 'blue wall', value: ({ world, ball }) => positionOf(world, ball).x - REST },
      { label: 'violet wall', value: ({ world, ball }) => positionOf(world, ball).z - REST },
    ),
  ],
  checks: ({ at }) => [
    ...[
      { axis: 'y' as const, label: 'It hits the floor, √(2 h/g)', exact: Math.sqrt(8) },
      { axis: 'z' as const, label: 'It hits the violet wall', exact: 4 },
      { axis: 'x' as const, label: 'It hits the blue wall', exact: 9 },
    ].map(({ axis, label, exact }) => ({
      label,
      unit: 's',
      exact,
      tolerance: { absolute: DT },
      at: { event: ({ world, ball }: BallRun) => velocityOf(world, ball)[axis] },
    })),
    ...[64.8, 52.488].map((exact, i) => ({
      label: `Height of apex ${i + 1}, 80 · 0.81${['', '²'][i]}`,
      unit: 'px',
      exact,
      tolerance: { relative: 1e-3 },
      at: { event: ({ world, ball }: BallRun) => -velocityOf(world, ball).y, count: i + 1 },
      measure: ({ world, ball }: BallRun) => positionOf(world, ball).y - REST,
    })),
    at(
      8.5,
      'Speed along the floor after two bounces on it',
      {
        exact: ({ speed }) => speed,
        // It has not met the blue wall.
        holds: ({ speed }) => 8.5 * speed < START - REST,
        unit: 'px/s',
        absolute: 0,
      },
      ({ world, ball }) => -velocityOf(world, ball).x,
    ),
  ],
  tryThis: [
    'Take gravity away: the ball moves on a straight line until it meets a wall, and never comes down.',
    'Drag the view to look from above: there the path consists of straight lines.',
  ],
});
