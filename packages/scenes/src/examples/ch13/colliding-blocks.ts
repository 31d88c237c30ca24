import {
  angularDrag,
  asleepCount,
  box,
  createPhysicsWorld,
  energy,
  rgba,
  rigidBodies,
  softStep,
  spawn,
  uniformGravity,
} from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { areaOf, cornersOf } from '../support/outline.ts';

/** Twenty pixels of the book are a metre. Width, height, angle in degrees, and place of the blocks, px. */
const SCALE = 1 / 20;
const BLOCKS = [
  [6, 6, 45, 200, 90],
  [10, 10, 0, 240, 25],
  [20, 20, 30, 320, 40],
  [14, 6, 60, 380, 40],
  [10, 10, -70, 210, 40],
  [20, 20, -30, 150, 40],
  [20, 20, -130, 190, 70],
  [20, 20, -130, 230, 70],
  [40, 20, -130, 300, 70],
  [20, 20, -10, 200, 110],
] as const;
const AREA = BLOCKS.reduce((sum, [w, h]) => sum + w * h * SCALE * SCALE, 0);

export default defineExample({
  id: 'ch13-colliding-blocks',
  title: 'A heap of blocks',
  chapter: 13,
  tags: ['rigid bodies', 'collision', 'friction', 'energy'],
  about:
    'Ten blocks fall on the floor and on each other. Where they touch they push each other apart, equally hard, and turn each other. Each collision takes energy away and none gives any, so that the heap calms down; then the blocks sleep, and cost nothing.',
  duration: 40,
  parameters: {
    restitution: { label: 'Restitution e', initial: 0.4, min: 0, max: 0.8 },
    friction: { label: 'Friction', initial: 0.4, min: 0, max: 1 },
    gravity: { label: 'Gravity', unit: 'm/s²', initial: 0.5, min: 0.1, max: 10 },
  },
  presets: [{ label: 'On the Earth', values: { gravity: 9.81 } }],
  build({ restitution, friction, gravity }) {
    const world = createPhysicsWorld({
      preset: rigidBodies,
      capacity: 40,
      forces: [uniformGravity({ y: -gravity }), angularDrag()],
      integrator: softStep({ restitutionThreshold: 0.1 }),
    });
    const material = { restitution, friction };
    spawn(world, {
      position: { y: -0.5 },
      collider: { shape: box(60, 1), ...material },
      appearance: rgba(0.29, 0.33, 0.47),
    });
    const blocks = BLOCKS.map(([w, h, degrees, x, y], i) =>
      spawn(world, {
        position: { x: (x - 260) * SCALE, y: (350 - y) * SCALE },
        velocity: {},
        rotation: (-degrees * Math.PI) / 180,
        angularVelocity: 0,
        angularDrag: 0.02 * w * h * SCALE * SCALE,
        collider: { shape: box(w * SCALE, h * SCALE), density: 1, ...material },
        appearance: rgba(0.3 + 0.05 * i, 0.6, 1 - 0.05 * i),
      }),
    );
    const start = energy(world).total;
    const deepest = () =>
      blocks.reduce((low, id) => cornersOf(world, id).reduce((least, { y }) => Math.min(least, y), low), 0);
    return { world, dt: 1 / 60, blocks, deepest, gained: () => (energy(world).total - start) / start };
  },
  picture() {
    return {
      view: { minX: -9, maxX: 9, minY: -1, maxY: 17 },
    };
  },
  plots: (plot) => [
    plot('Total energy', 'E, J', { label: 'all blocks', value: ({ world }) => energy(world).total }),
    plot('Asleep', 'blocks', { label: 'asleep', value: ({ world }) => asleepCount(world) }),
  ],
  checks: ({ at, largest }) => [
    at(30, 'Blocks asleep after 30 s', { exact: 10, absolute: 0 }, ({ world }) => asleepCount(world)),
    at(
      30,
      'How deep a corner is in the floor after 30 s: half a pixel at most',
      { exact: 0, unit: 'm', absolute: 0.5 * SCALE },
      ({ deepest }) => deepest(),
    ),
    largest(30, 'Most energy gained at any time, of that at the start', { exact: 0, absolute: 1e-3 }, ({ gained }) =>
      gained(),
    ),
    at(30, 'Area of all blocks after 30 s', { exact: AREA, unit: 'm²', relative: 1e-9 }, ({ world, blocks }) =>
      blocks.reduce((sum, id) => sum + areaOf(cornersOf(world, id)), 0),
    ),
  ],
  tryThis: [
    'Drag a block out of the heap: those that lay on it wake and fall.',
    'Set the friction to zero: the heap spreads, because nothing holds the blocks on each other.',
  ],
});
