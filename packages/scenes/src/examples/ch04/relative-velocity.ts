import { atan2, createPhysicsWorld, rgba, spawn, velocityVerlet } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { positionOf, speedOf, velocityOf } from '../support/read.ts';

const [BANK, DURATION] = [30, 8];

export default defineExample({
  id: 'ch04-relative-velocity',
  title: 'Rowing across a river',
  chapter: 4,
  tags: ['velocity', 'vectors'],
  about:
    'A boat is rowed straight across at 4 m/s, and the river carries it along at 3 m/s. Seen from the bank it moves at 5 m/s, at an angle. The current does not make the crossing any longer or shorter: the boat only arrives further down. The leaf floats with the water, and sees the boat go straight across.',
  duration: DURATION,
  ends: true,
  parameters: {
    river: { label: 'Speed of the river', unit: 'm/s', initial: 3, min: 0, max: 6 },
    boat: { label: 'Speed of the boat', unit: 'm/s', initial: 4, min: 1, max: 6 },
  },
  presets: [{ label: 'Still water', values: { river: 0 } }],
  build({ river, boat }, { integrator = velocityVerlet }) {
    const world = createPhysicsWorld({ capacity: 4, integrator });
    const body = { position: { x: 0, y: 0 }, mass: 1 };
    const ball = spawn(world, { ...body, velocity: { x: river, y: boat }, collider: 0.9 });
    const leaf = spawn(world, { ...body, velocity: { x: river }, collider: 0.5, appearance: rgba(0.37, 0.84, 0.64) });
    return { world, dt: 1 / 64, ball, leaf };
  },
  picture({ world, ball, leaf }, { river, boat }) {
    const at = () => positionOf(world, ball);
    return {
      view: { minX: -4, maxX: 36, minY: -4, maxY: 34 },
      fills: [
        { shape: { minX: -100, maxX: 200, minY: 0, maxY: BANK }, color: COLORS.water, opacity: 0.35 },
        { shape: { minX: -100, maxX: 200, minY: -100, maxY: 0 }, color: COLORS.ground },
        { shape: { minX: -100, maxX: 200, minY: BANK, maxY: 200 }, color: COLORS.ground },
      ],
      lines: [{ from: () => positionOf(world, leaf), to: at, color: COLORS.green, width: 1 }],
      trails: [
        { body: ball, length: 600 },
        { body: leaf, length: 600 },
      ],
      arrows: [
        { label: 'river', from: at, vector: () => ({ x: river, y: 0 }), color: COLORS.blue },
        { label: 'boat', from: at, vector: () => ({ x: 0, y: boat }), color: COLORS.orange },
        { label: 'both', from: at, vector: () => velocityOf(world, ball), color: COLORS.green },
      ],
    };
  },
  plots: (plot) => [
    plot(
      'Distance across and along',
      'distance, m',
      { label: 'across', value: ({ world, ball }) => positionOf(world, ball).y, exact: (t, { boat }) => boat * t },
      { label: 'along', value: ({ world, ball }) => positionOf(world, ball).x, exact: (t, { river }) => river * t },
    ),
  ],
  checks: ({ at }) => [
    at(4, 'Speed seen from the bank', { exact: 5, unit: 'm/s', absolute: 0 }, ({ world, ball }) =>
      speedOf(world, ball),
    ),
    at(
      4,
      'Its direction from the bank',
      { exact: (atan2(4, 3) * 180) / Math.PI, unit: '°', absolute: 1e-9 },
      ({ world, ball }) => (atan2(velocityOf(world, ball).y, velocityOf(world, ball).x) * 180) / Math.PI,
    ),
    {
      label: 'Time to the other bank, width over the speed of the boat',
      unit: 's',
      exact: ({ boat }) => BANK / boat,
      holds: ({ boat }) => boat * DURATION > BANK,
      tolerance: { relative: 1e-9 },
      at: { event: ({ world, ball }) => positionOf(world, ball).y - BANK },
    },
  ],
  tryThis: [
    'Let the river flow faster: the boat arrives further down, but not a moment later.',
    'Let the boat be slow and the river fast: seen from the bank, the boat hardly gets across at all.',
  ],
});
