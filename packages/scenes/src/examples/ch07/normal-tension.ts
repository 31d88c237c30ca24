import {
  cos,
  createPhysicsWorld,
  planeSupport,
  restrictForce,
  rgba,
  sin,
  spawn,
  stringTension,
  uniformGravity,
} from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS, type Point } from '../picture.ts';
import { forceArrow } from '../support/arrows.ts';
import { lengthOf, positionOf, velocityOf } from '../support/read.ts';

const GRAVITY = 10;
const [FOOT, PIVOT, LENGTH] = [{ x: 60, y: 200 }, { x: 480, y: 60 }, 120];

export default defineExample({
  id: 'ch07-normal-tension',
  title: 'What a slope and a string carry',
  chapter: 7,
  tags: ['normal force', 'tension', 'slope', 'equilibrium'],
  about:
    'A block slides on smooth ice, and a ball hangs on a string. The slope pushes at right angles to itself, with m g cos θ: less than the weight, so the block is driven down the slope. The string pulls with the whole weight, so the ball stays. Both forces are only as large as they must be.',
  duration: 12,
  ends: true,
  parameters: {
    degrees: { label: 'Slope θ', unit: '°', initial: 20, min: 0, max: 60 },
    mass: { label: 'Mass', unit: 'kg', initial: 3, min: 0.5, max: 5 },
  },
  presets: [{ label: 'Level', values: { degrees: 0 } }],
  build({ degrees, mass }, options) {
    const angle = (degrees * Math.PI) / 180;
    const slope = planeSupport({ point: FOOT, normal: { x: sin(angle), y: -cos(angle) } });
    const string = stringTension({ pivot: PIVOT, length: LENGTH });
    const right = { region: { min: { x: 440 }, max: { x: 520, y: 300 } } };
    const left = { region: { min: { x: -1000 }, max: { x: 440, y: 1000 } } };
    const forces = [uniformGravity({ y: GRAVITY }), restrictForce(slope, left), restrictForce(string, right)];
    const world = createPhysicsWorld({ capacity: 4, forces, ...options });
    const block = spawn(world, { position: FOOT, mass });
    const position = { x: PIVOT.x, y: PIVOT.y + LENGTH };
    const ball = spawn(world, { position, mass, collider: 16, appearance: rgba(1, 0.7, 0.35) });
    /** What acts besides gravity, from the acceleration: m (a − g). */
    const reaction = (id: number): Point => {
      const { x, y } = velocityOf(world, id);
      const t = Math.max(world.time, 1e-9);
      return { x: (mass * x) / t, y: mass * (y / t - (world.time > 0 ? GRAVITY : 0)) };
    };
    return { world, dt: 1 / 60, block, ball, angle, reaction };
  },
  picture({ world, block, ball, angle }, { mass }) {
    const [c, s] = [cos(angle), sin(angle)];
    const ground = (way: number) => ({ x: FOOT.x + way * c, y: FOOT.y + way * s });
    const corner = (x: number, y: number) => () => {
      const at = positionOf(world, block);
      return { x: at.x + c * x + s * y, y: at.y + s * x - c * y };
    };
    const corners = [corner(-16, 0), corner(16, 0), corner(16, 28), corner(-16, 28)];
    const weight = () => ({ x: 0, y: mass * GRAVITY });
    const normal = mass * GRAVITY * c;
    return {
      yDown: true,
      view: { minX: 0, maxX: 580, minY: 30, maxY: 330 },
      lines: [
        { from: ground(-60), to: ground(370), color: COLORS.ground, width: 5 },
        ...corners.map((from, i) => ({ from, to: corners[(i + 1) % 4], width: 4, color: COLORS.orange })),
        { from: { x: 440, y: PIVOT.y }, to: { x: 520, y: PIVOT.y }, color: COLORS.grey, width: 4 },
        { from: PIVOT, to: () => positionOf(world, ball) },
      ],
      arrows: [
        forceArrow(world, block, 'm g', weight, 2),
        {
          ...forceArrow(world, block, 'm g cos θ', () => ({ x: normal * s, y: -normal * c }), 2),
          color: COLORS.yellow,
        },
        forceArrow(world, ball, 'm g', weight, 2),
        { ...forceArrow(world, ball, 'tension', () => ({ x: 0, y: -mass * GRAVITY }), 2), color: COLORS.yellow },
      ],
    };
  },
  plots: (plot) => [
    plot(
      'What slope and string carry',
      'force, N',
      {
        label: 'slope',
        value: ({ block, reaction }) => lengthOf(reaction(block)),
        exact: (_, { degrees, mass }) => mass * GRAVITY * cos((degrees * Math.PI) / 180),
      },
      { label: 'string', value: ({ ball, reaction }) => lengthOf(reaction(ball)) },
    ),
  ],
  checks: ({ at }) => [
    at(
      5,
      'Force of the slope, m g cos θ',
      { exact: ({ degrees, mass }) => mass * GRAVITY * cos((degrees * Math.PI) / 180), unit: 'N', relative: 1e-9 },
      ({ block, reaction }) => lengthOf(reaction(block)),
    ),
    at(
      5,
      'Tension of the string, m g',
      { exact: ({ mass }) => mass * GRAVITY, unit: 'N', relative: 1e-9 },
      ({ ball, reaction }) => lengthOf(reaction(ball)),
    ),
  ],
  tryThis: ['Choose “Level”: slope and string carry the same.', 'At 60° the slope carries only half of the weight.'],
});
