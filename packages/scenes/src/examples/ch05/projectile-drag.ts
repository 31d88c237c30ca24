import {
  createPhysicsWorld,
  exp,
  linearDrag,
  log,
  positionFirstEuler,
  spawn,
  uniformGravity,
  velocityVerlet,
} from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS, pointsOf } from '../picture.ts';
import { positionOf, velocityOf } from '../support/read.ts';

type Values = ValuesOf<'gravity' | 'drag' | 'speed'>;
const START = { x: 50, y: 400 };

/** Exact place of a body of 1 kg that is thrown at 45°. */
function exactPlace(t: number, { gravity: g, drag: k, speed: v }: Values) {
  if (k === 0) return { x: START.x + v * t, y: START.y - v * t + (g / 2) * t * t };
  const fade = (1 - exp(-k * t)) / k;
  return { x: START.x + v * fade, y: START.y + (g / k) * t - (v + g / k) * fade };
}

export default defineExample({
  id: 'ch05-projectile-drag',
  title: 'A throw through thick air',
  chapter: 5,
  tags: ['projectile', 'gravity', 'drag'],
  about:
    'Weight pulls the ball down, and the drag of the air pulls it back against its velocity. The grey parabola is the same throw without air: the real path is shorter, lower, and steeper on its way down than on its way up. The ring moves on the exact solution.',
  duration: 10,
  ends: true,
  parameters: {
    gravity: { label: 'Gravity', unit: 'px/s²', initial: 10, min: 0, max: 20 },
    drag: { label: 'Drag coefficient', unit: 'kg/s', initial: 0.1, min: 0, max: 0.5 },
    speed: { label: 'Velocity in both directions', unit: 'px/s', initial: 60, min: 10, max: 80 },
  },
  presets: [
    { label: 'Gravity only', values: { drag: 0 } },
    { label: 'Drag only', values: { gravity: 0 } },
  ],
  build({ gravity, drag, speed }, { integrator = velocityVerlet }) {
    const forces = [uniformGravity({ y: gravity }), linearDrag()];
    const world = createPhysicsWorld({ capacity: 4, forces, integrator });
    const velocity = { x: speed, y: -speed };
    const ball = spawn(world, { position: START, velocity, mass: 1, collider: 15, linearDrag: drag });
    return { world, dt: 1 / 60, ball };
  },
  picture({ world, ball }, values) {
    const at = () => positionOf(world, ball);
    return {
      yDown: true,
      view: { minX: 0, maxX: 700, minY: 60, maxY: 470 },
      lines: [{ from: { x: 0, y: 415 }, to: { x: 700, y: 415 }, color: COLORS.ground }],
      curves: [
        { points: pointsOf((t) => exactPlace(t, { ...values, drag: 0 }), 0, 12), color: COLORS.ground },
        { points: [], now: (t) => exactPlace(t, values), markRadius: 18, label: 'exact', color: COLORS.grey },
      ],
      trails: [{ body: ball, length: 600 }],
      arrows: [
        { label: 'weight', from: at, vector: () => ({ x: 0, y: values.gravity }), scale: 6, color: COLORS.orange },
        {
          label: 'drag',
          from: at,
          vector: () => ({ x: -values.drag * velocityOf(world, ball).x, y: -values.drag * velocityOf(world, ball).y }),
          scale: 6,
          color: COLORS.red,
        },
      ],
    };
  },
  plots: (plot) => [
    plot('Height', 'height, px', {
      label: 'stepped',
      value: ({ world, ball }) => START.y - positionOf(world, ball).y,
      exact: (t, values) => START.y - exactPlace(t, values).y,
    }),
  ],
  checks: ({ at }) => [
    at(
      10,
      'x after 10 s',
      { exact: (values) => exactPlace(10, values).x, unit: 'px', absolute: 0.01 },
      ({ world, ball }) => positionOf(world, ball).x,
    ),
    at(
      10,
      'y after 10 s',
      { exact: (values) => exactPlace(10, values).y, unit: 'px', absolute: 0.01 },
      ({ world, ball }) => positionOf(world, ball).y,
    ),
    {
      label: 'Time of the apex, ln(1 + k v/g)/k',
      unit: 's',
      exact: 10 * log(1.6),
      tolerance: { absolute: 1e-3 },
      at: { event: ({ world, ball }) => velocityOf(world, ball).y },
    },
    {
      label: 'y of the apex',
      unit: 'px',
      exact: 270,
      tolerance: { absolute: 0.01 },
      at: { event: ({ world, ball }) => velocityOf(world, ball).y },
      measure: ({ world, ball }) => positionOf(world, ball).y,
    },
    at(
      10,
      'y after 10 s by the simplest scheme',
      { exact: 388.61, unit: 'px', absolute: 0.5, integrator: positionFirstEuler },
      ({ world, ball }) => positionOf(world, ball).y,
    ),
    at(
      10,
      'y after 10 s, v t − ½ g t² above the start',
      { exact: 300, unit: 'px', absolute: 1e-9, preset: 'Gravity only' },
      ({ world, ball }) => positionOf(world, ball).y,
    ),
    at(
      10,
      'Distance to the right less distance upwards after 10 s',
      { exact: 0, unit: 'px', absolute: 1e-9, preset: 'Drag only' },
      ({ world, ball }) => positionOf(world, ball).x + positionOf(world, ball).y - START.x - START.y,
    ),
  ],
  tryThis: [
    'Take the drag away: the ball follows the grey parabola.',
    'Take gravity away: the ball flies straight, ever more slowly, and never quite gets 600 px to the right.',
  ],
});
