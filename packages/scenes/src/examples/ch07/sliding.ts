import { createPhysicsWorld, planeSupport, spawn, uniformGravity } from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { forceArrow, velocityArrow } from '../support/arrows.ts';
import { distanceBetween, positionOf, speedOf } from '../support/read.ts';

const FOOT = { x: 60, y: 170 };
const SIZE = 16;
const GRAVITY = 10;
/** From (50, 150) to (450, 250). */
const LENGTH = 100 * Math.sqrt(17);

type Values = ValuesOf<'slope' | 'still' | 'moving'>;

/** Acceleration of a block that slides, px/s². */
const slidingAcceleration = ({ slope, moving }: Values) => (GRAVITY * (slope - moving)) / Math.sqrt(1 + slope * slope);

export default defineExample({
  id: 'ch07-sliding',
  title: 'Will the block slide?',
  chapter: 7,
  tags: ['friction', 'slope', 'normal force'],
  about:
    'A block lies on a slope. Friction can hold it as long as the slope, tan θ, is at most the coefficient of static friction. Here both are 0.25: the block stays, exactly at the limit. Once it slides, the smaller kinetic friction acts, and it goes faster and faster with a = g (sin θ − μ cos θ).',
  duration: 45,
  parameters: {
    slope: { label: 'Slope, tan θ', initial: 0.25, min: 0.05, max: 0.6 },
    still: { label: 'Static friction', initial: 0.25, min: 0, max: 0.6 },
    moving: { label: 'Kinetic friction', initial: 0.2, min: 0, max: 0.6 },
  },
  presets: [
    { label: 'A little too smooth', values: { still: 0.24 } },
    { label: 'Ice', values: { still: 0, moving: 0 } },
  ],
  build({ slope, still, moving }, options) {
    const normal = { x: slope, y: -1 };
    const support = planeSupport({ point: FOOT, normal, staticFriction: still, kineticFriction: moving });
    const world = createPhysicsWorld({ capacity: 4, forces: [uniformGravity({ y: GRAVITY }), support], ...options });
    // The place of the block is the middle of its lower side.
    const block = spawn(world, { position: FOOT, mass: 1 });
    return { world, dt: 1 / 60, block, distance: () => distanceBetween(positionOf(world, block), FOOT) };
  },
  picture({ world, block }, { slope, still, moving }) {
    const cosine = 1 / Math.sqrt(1 + slope * slope);
    const load = GRAVITY * cosine;
    const along = (force: number) => ({ x: -force * cosine, y: -force * slope * cosine });
    const friction = () => along(speedOf(world, block) > 1e-9 ? moving * load : Math.min(still * load, load * slope));
    const corner = (x: number, y: number) => () => {
      const at = positionOf(world, block);
      return { x: at.x + cosine * (x + slope * y), y: at.y + cosine * (slope * x - y) };
    };
    const corners = [corner(-SIZE, 0), corner(SIZE, 0), corner(SIZE, 2 * SIZE), corner(-SIZE, 2 * SIZE)];
    const ground = (x: number) => ({ x, y: FOOT.y + slope * (x - FOOT.x) });
    return {
      yDown: true,
      view: { minX: 0, maxX: 520, minY: 60, maxY: 300 },
      fills: [
        { shape: [ground(-500), ground(1500), { x: 1500, y: 2000 }, { x: -500, y: 2000 }], color: COLORS.ground },
      ],
      lines: corners.map((from, i) => ({ from, to: corners[(i + 1) % 4], width: 4, color: COLORS.orange })),
      arrows: [
        forceArrow(world, block, 'weight', () => ({ x: 0, y: GRAVITY }), 6),
        forceArrow(world, block, 'N', () => ({ x: load * slope * cosine, y: -load * cosine }), 6),
        { ...forceArrow(world, block, 'friction', friction, 12), color: COLORS.yellow },
        velocityArrow(world, block, 3),
      ],
    };
  },
  plots: (plot) => [
    plot('Speed', 'v, px/s', { label: 'block', value: ({ world, block }) => speedOf(world, block) }),
    plot('Distance', 's, px', { label: 'block', value: ({ distance }) => distance() }),
  ],
  checks: ({ at }) => [
    at(30, 'Speed after 30 s at the limit', { exact: 0, unit: 'px/s', absolute: 1e-12 }, ({ world, block }) =>
      speedOf(world, block),
    ),
    at(
      4,
      'Acceleration, g (sin θ − μ cos θ)',
      { exact: slidingAcceleration, unit: 'px/s²', relative: 1e-6, preset: 'A little too smooth' },
      ({ world, block }) => speedOf(world, block) / world.time,
    ),
    {
      label: 'Time for 412.31 px',
      unit: 's',
      exact: (values) => Math.sqrt((2 * LENGTH) / slidingAcceleration(values)),
      tolerance: { relative: 1e-6 },
      at: { event: ({ distance }) => distance() - LENGTH },
      preset: 'A little too smooth',
    },
    at(
      4,
      'Acceleration without friction, g sin θ',
      { exact: 2.42536, unit: 'px/s²', absolute: 5e-6, preset: 'Ice' },
      ({ world, block }) => speedOf(world, block) / world.time,
    ),
  ],
  tryThis: [
    'Make the slope a little steeper than the static friction: the block starts, and does not stop again.',
    'Choose “Ice”: without friction it takes less than half the time.',
  ],
});
