import { createPhysicsWorld, planeSupport, rgba, spawn, uniformGravity } from '@principia/physics';
import type { SceneRun } from '../../scene.ts';
import { choiceOf, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { forceArrow, velocityArrow } from '../support/arrows.ts';
import { marks, star } from '../support/outline.ts';
import { distanceBetween, positionOf, speedOf } from '../support/read.ts';

const [RADIUS, GRAVITY, STILL, MOVING] = [20, 10, 0.25, 0.2];
const POINT = { x: 50, y: 150 };
const LENGTH = 100 * Math.sqrt(17);
/** Moment of inertia in units of m r². */
const BODIES = [
  { name: 'solid ball', share: 0.4 },
  { name: 'disc', share: 0.5 },
  { name: 'hoop', share: 1 },
] as const;

interface Run extends SceneRun {
  readonly ball: number;
  readonly way: () => number;
  readonly slip: () => number;
}

type Values = ValuesOf<'slope' | 'body'>;

/** Acceleration of a body that rolls, g sin θ/(1 + I/m r²), or that slides because friction cannot turn it. */
function acceleration({ slope, body }: Values): number {
  const [root, { share }] = [Math.sqrt(1 + slope * slope), BODIES[body]];
  const isRolling = (slope * share) / (1 + share) <= STILL;
  return (GRAVITY / root) * (isRolling ? slope / (1 + share) : slope - MOVING);
}

export default defineExample({
  id: 'ch13-rolling',
  title: 'What rolls down fastest?',
  chapter: 13,
  tags: ['rolling', 'friction', 'moment of inertia', 'rotation'],
  about:
    'Friction makes a round body roll: it holds the lowest point, and so turns the body. A part of the energy goes into turning, so rolling is slower than sliding without friction: for a hoop, whose mass is all at the rim, by half. On a steep slope friction is too weak, and the body slips.',
  duration: 22,
  parameters: {
    slope: { label: 'Slope, tan θ', initial: 0.25, min: 0.05, max: 1.5 },
    body: choiceOf(
      'Body',
      BODIES.map(({ name }) => name),
    ),
  },
  presets: [
    { label: 'Disc', values: { body: 1 } },
    { label: 'Hoop', values: { body: 2 } },
    { label: 'Too steep', values: { slope: 1 } },
  ],
  build({ slope, body }, options): Run {
    const normal = { x: slope, y: -1 };
    const support = planeSupport({ point: POINT, normal, staticFriction: STILL, kineticFriction: MOVING });
    const world = createPhysicsWorld({ capacity: 4, forces: [uniformGravity({ y: GRAVITY }), support], ...options });
    const root = Math.sqrt(1 + slope * slope);
    const start = { x: POINT.x + (RADIUS * slope) / root, y: POINT.y - RADIUS / root };
    const ball = spawn(world, {
      position: start,
      velocity: {},
      mass: 1,
      inertia: BODIES[body].share * RADIUS * RADIUS,
      rotation: 0,
      angularVelocity: 0,
      collider: RADIUS,
      appearance: body === 2 ? { shape: 1, color: rgba(1, 0.7, 0.35) } : rgba(1, 0.7, 0.35),
    });
    const way = () => distanceBetween(positionOf(world, ball), start);
    const slip = () => speedOf(world, ball) - RADIUS * Math.abs(world.components.AngularVelocity.z[ball]);
    return { world, dt: 1 / 60, ball, way, slip };
  },
  picture({ world, ball }, values) {
    const { slope } = values;
    const cosine = 1 / Math.sqrt(1 + slope * slope);
    const ground = (x: number) => ({ x, y: POINT.y + slope * (x - POINT.x) });
    const friction = GRAVITY * slope * cosine - acceleration(values);
    const end = POINT.x + LENGTH * cosine;
    return {
      yDown: true,
      view: { minX: 0, maxX: end + 40, minY: 80, maxY: Math.max(300, ground(end).y + 30) },
      fills: [
        { shape: [ground(-500), ground(2000), { x: 2000, y: 6000 }, { x: -500, y: 6000 }], color: COLORS.ground },
      ],
      dots: [
        ...marks(world, ball, star(5, 0.7 * RADIUS), COLORS.blue),
        { at: { x: end + 20 * slope * cosine, y: ground(end).y - 20 * cosine }, color: COLORS.green },
      ],
      arrows: [
        forceArrow(world, ball, 'weight', () => ({ x: 0, y: GRAVITY }), 5),
        {
          ...forceArrow(world, ball, 'friction', () => ({ x: -friction * cosine, y: -friction * slope * cosine }), 25),
          color: COLORS.yellow,
        },
        velocityArrow(world, ball, 1.5),
      ],
    };
  },
  plots: (plot) => [
    plot(
      'Speed, and that of the rim',
      'v, px/s',
      {
        label: 'body',
        value: ({ world, ball }) => speedOf(world, ball),
        exact: (t, values) => acceleration(values) * t,
      },
      { label: 'rim', value: ({ world, ball, slip }) => speedOf(world, ball) - slip() },
    ),
  ],
  checks: ({ at }) => [
    at(
      4,
      'Acceleration, g sin θ/(1 + I/m r²)',
      { exact: acceleration, unit: 'px/s²', relative: 1e-6 },
      ({ world, ball }) => speedOf(world, ball) / world.time,
    ),
    {
      label: 'Time for 412.31 px',
      unit: 's',
      exact: (values) => Math.sqrt((2 * LENGTH) / acceleration(values)),
      tolerance: { relative: 1e-6 },
      at: { event: ({ way }) => way() - LENGTH },
    },
    {
      label: 'Speed then',
      unit: 'px/s',
      exact: 100 / Math.sqrt(7),
      tolerance: { relative: 1e-4 },
      at: { event: ({ way }) => way() - LENGTH },
      measure: ({ world, ball }) => speedOf(world, ball),
    },
    at(20, 'Slip after 20 s, v − ω r', { exact: 0, unit: 'px/s', absolute: 1e-9 }, ({ slip }) => slip()),
    ...(
      [
        ['Disc', 2 / 3],
        ['Hoop', 1 / 2],
      ] as const
    ).map(([preset, share]) =>
      at(
        4,
        `${preset}: acceleration, by g sin θ`,
        { exact: share, relative: 1e-6, preset },
        ({ world, ball }) => speedOf(world, ball) / (world.time * (GRAVITY / Math.sqrt(17))),
      ),
    ),
    at(
      4,
      'Acceleration where it slips, g (sin θ − μ cos θ)',
      { exact: acceleration, unit: 'px/s²', relative: 1e-6, preset: 'Too steep' },
      ({ world, ball }) => speedOf(world, ball) / world.time,
    ),
  ],
  tryThis: [
    'Let the solid ball, the disc and the hoop roll one after the other: the hoop is last, whatever its size.',
    'Make the slope steeper than 0.875: the solid ball begins to slip.',
  ],
});
