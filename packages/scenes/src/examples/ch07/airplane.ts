import {
  createPhysicsWorld,
  lift,
  log,
  type PhysicsWorld,
  planeSupport,
  quadraticDrag,
  spawn,
  thrust,
  uniformGravity,
} from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS, type Point } from '../picture.ts';
import { forceArrow, velocityArrow } from '../support/arrows.ts';
import { atanh, tanh } from '../support/hyperbolic.ts';
import { positionOf, speedOf, velocityOf } from '../support/read.ts';

const DRAG = 0.01;
const GRAVITY = 10;

type Values = ValuesOf<'push' | 'wing'>;

const terminal = ({ push }: Values) => Math.sqrt(push / DRAG);
const takeOffSpeed = ({ wing }: Values) => Math.sqrt(GRAVITY / wing);
/** On the runway v = v_T tanh(k v_T t), so that the speed of take-off is reached at this time. */
const takeOffTime = (values: Values) => atanh(takeOffSpeed(values) / terminal(values)) / (DRAG * terminal(values));

/** Fuselage, wing and tail about the middle of the plane, px. */
const OUTLINE: readonly (readonly [from: Point, to: Point, width: number])[] = [
  [{ x: -25, y: 5 }, { x: 22, y: 5 }, 9],
  [{ x: 22, y: 4 }, { x: 30, y: 3 }, 5],
  [{ x: -24, y: 6 }, { x: -31, y: 18 }, 5],
  [{ x: 4, y: 3 }, { x: -12, y: -1 }, 4],
];

/** The first step after which it climbs. */
const TAKE_OFF = {
  event: ({ world, plane }: { readonly world: PhysicsWorld; readonly plane: number }) =>
    velocityOf(world, plane).y - 1e-9,
};

export default defineExample({
  id: 'ch07-airplane',
  title: 'An aeroplane takes off',
  chapter: 7,
  tags: ['lift', 'drag', 'thrust', 'normal force'],
  about:
    'The engine pushes the plane along the runway. Its wings lift it with the square of its speed, so that the runway carries less and less. When the lift equals the weight, the plane leaves the ground.',
  duration: 14,
  ends: true,
  parameters: {
    push: { label: 'Thrust', unit: 'N', initial: 5, min: 4.5, max: 10 },
    wing: { label: 'Lift coefficient k', unit: 'kg/px', initial: 0.025, min: 0.024, max: 0.06 },
  },
  presets: [{ label: 'A stronger engine', values: { push: 8 } }],
  build({ push, wing }: Values, options: BuildOptions) {
    const forces = [uniformGravity({ y: -GRAVITY }), thrust(), quadraticDrag(), lift(), planeSupport()];
    const world = createPhysicsWorld({ capacity: 4, forces, ...options });
    const position = { x: 50 };
    const plane = spawn(world, { position, mass: 1, thrust: { x: push }, quadraticDrag: DRAG, lift: wing });
    return { world, dt: 1 / 240, plane };
  },
  picture({ world, plane }, { push, wing }) {
    const at = (offset: Point) => () => {
      const { x, y } = positionOf(world, plane);
      return { x: x + offset.x, y: y + offset.y };
    };
    const wings = (): Point => {
      const [{ x, y }, speed] = [velocityOf(world, plane), speedOf(world, plane)];
      return { x: -wing * speed * y, y: wing * speed * x };
    };
    return {
      view: { minX: 0, maxX: 360, minY: -40, maxY: 160 },
      fills: [
        { shape: { minX: -1000, maxX: 2000, minY: -1, maxY: 2000 }, color: 0x274a7a },
        { shape: { minX: -1000, maxX: 2000, minY: -1000, maxY: -1 }, color: COLORS.ground },
      ],
      lines: OUTLINE.map(([from, to, width]) => ({ from: at(from), to: at(to), width, color: COLORS.white })),
      trails: [{ body: plane, length: 900, interval: 4 }],
      arrows: [
        forceArrow(world, plane, 'weight', () => ({ x: 0, y: -GRAVITY }), 3),
        { ...forceArrow(world, plane, 'lift', wings, 3), color: COLORS.violet },
        { ...forceArrow(world, plane, 'thrust', () => ({ x: push, y: 0 }), 3), color: COLORS.orange },
        velocityArrow(world, plane, 1.5),
      ],
    };
  },
  plots: (plot) => [
    plot('Speed along the ground', 'v, px/s', {
      label: 'stepped',
      value: ({ world, plane }) => velocityOf(world, plane).x,
      exact: (t, values) => terminal(values) * tanh(DRAG * terminal(values) * Math.min(t, takeOffTime(values))),
    }),
    plot('Height', 'h, px', { label: 'plane', value: ({ world, plane }) => positionOf(world, plane).y }),
  ],
  checks: ({ at }) => [
    at(
      5,
      'Speed after 5 s on the runway',
      {
        exact: (values) => terminal(values) * tanh(5 * DRAG * terminal(values)),
        holds: (values) => takeOffTime(values) > 5,
        unit: 'px/s',
        relative: 0.01,
      },
      ({ world, plane }) => velocityOf(world, plane).x,
    ),
    {
      label: 'Time of take-off',
      unit: 's',
      exact: takeOffTime,
      tolerance: { relative: 0.01 },
      at: TAKE_OFF,
    },
    {
      label: 'Length of runway used',
      unit: 'px',
      // x = ln cosh(k v_T t)/k, with cosh = 1/√(1 − tanh²).
      exact: (values) => -log(1 - (GRAVITY * DRAG) / (values.wing * values.push)) / (2 * DRAG),
      tolerance: { relative: 0.01 },
      at: TAKE_OFF,
      measure: ({ world, plane }) => positionOf(world, plane).x - 50,
    },
    {
      label: 'Speed at take-off, √(mg/k)',
      unit: 'px/s',
      exact: takeOffSpeed,
      tolerance: { relative: 0.01 },
      at: TAKE_OFF,
      measure: ({ world, plane }) => velocityOf(world, plane).x,
    },
  ],
  tryThis: [
    'Choose “A stronger engine”: the plane lifts off at the same speed, but much earlier.',
    'Larger wings, that is a larger k, lift the plane at a lower speed.',
  ],
});
