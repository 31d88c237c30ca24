import { createPhysicsWorld, linearDrag, rgba, rungeKutta4, spawn, springs, uniformGravity } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { distanceBetween, positionOf } from '../support/read.ts';

const [COLUMNS, ROWS, SPACING, MASS] = [15, 10, 20, 10];
const ORIGIN = { x: 120, y: 30 };
/** Columns whose uppermost node is pinned. */
const PINNED = [0, 7, 14];

export default defineExample({
  id: 'ch13-cloth',
  title: 'A net on three pins',
  chapter: 13,
  tags: ['cloth', 'spring', 'wind', 'soft bodies'],
  about:
    'A hundred and fifty heavy knots and the springs between neighbours make a net, which hangs from three pins. Without cross springs it is soft: between the pins it sags in two bows. A wind pushes every knot by 10 times its speed, and the net hangs at a slant.',
  duration: 120,
  parameters: {
    wind: { label: 'Wind', unit: 'px/s', initial: 0, min: -15, max: 15 },
    stiffness: { label: 'Stiffness of the threads', unit: 'N/m', initial: 100, min: 60, max: 400 },
    gravity: { label: 'Gravity', unit: 'px/s²', initial: 10, min: 0, max: 20 },
  },
  presets: [{ label: 'In the wind', values: { wind: 10 } }],
  build(
    { wind, stiffness, gravity }: ValuesOf<'wind' | 'stiffness' | 'gravity'>,
    { integrator = rungeKutta4 }: BuildOptions,
  ) {
    const forces = [uniformGravity({ y: gravity }), linearDrag({ x: wind }), springs()];
    const world = createPhysicsWorld({ capacity: 600, forces, integrator });
    const nodes = Array.from({ length: COLUMNS * ROWS }, (_, i) => {
      const [column, row] = [Math.floor(i / ROWS), i % ROWS];
      const position = { x: ORIGIN.x + SPACING * column, y: ORIGIN.y + SPACING * row };
      if (row === 0 && PINNED.includes(column)) {
        return spawn(world, { position, appearance: { size: 5, color: rgba(1, 0.7, 0.35) } });
      }
      return spawn(world, { position, velocity: {}, mass: MASS, linearDrag: 10 });
    });
    const node = (column: number, row: number) => nodes[column * ROWS + row];
    const tie = (a: number, b: number) => spawn(world, { spring: { a, b, stiffness, damping: 10, length: SPACING } });
    for (let column = 0; column < COLUMNS; column++) {
      for (let row = 0; row < ROWS; row++) {
        if (column + 1 < COLUMNS) tie(node(column, row), node(column + 1, row));
        if (row + 1 < ROWS) tie(node(column, row), node(column, row + 1));
      }
    }
    const mean = (axis: 'x' | 'y') => nodes.reduce((sum, id) => sum + positionOf(world, id)[axis], 0) / nodes.length;
    const lowest = () => nodes.reduce((most, id) => Math.max(most, positionOf(world, id).y), 0);
    /** Force of all pins on the net against an axis, N: that of the threads which are tied to them. */
    const support = (axis: 'x' | 'y') => {
      let sum = 0;
      for (const column of PINNED) {
        const pin = positionOf(world, node(column, 0));
        for (const [beside, below] of [
          [-1, 0],
          [1, 0],
          [0, 1],
        ] as const) {
          if (column + beside < 0 || column + beside >= COLUMNS) continue;
          const knot = positionOf(world, node(column + beside, below));
          const length = distanceBetween(pin, knot);
          sum += (stiffness * (length - SPACING) * (knot[axis] - pin[axis])) / length;
        }
      }
      return sum;
    };
    return { world, dt: 1 / 60, node, mean, lowest, support };
  },
  picture() {
    return {
      yDown: true,
      view: { minX: 20, maxX: 560, minY: 10, maxY: 350 },
      springs: 'lines',
      dots: PINNED.map((column) => ({ at: { x: ORIGIN.x + SPACING * column, y: ORIGIN.y }, color: COLORS.orange })),
    };
  },
  plots: (plot) => [
    plot(
      'Mean place of the knots',
      'place, px',
      { label: 'x', value: ({ mean }) => mean('x') },
      { label: 'y', value: ({ mean }) => mean('y') },
    ),
    plot('Lowest point', 'y, px', { label: 'knot', value: ({ lowest }) => lowest() }),
  ],
  checks: ({ at }) => [
    at(
      120,
      'Bottom of the middle column, x',
      { exact: 260, unit: 'px', absolute: 0.1 },
      ({ world, node }) => positionOf(world, node(7, 9)).x,
    ),
    at(
      120,
      'Bottom of the middle column, y',
      { exact: 288.897, unit: 'px', absolute: 0.1 },
      ({ world, node }) => positionOf(world, node(7, 9)).y,
    ),
    at(
      120,
      'Bottom of the left column, x',
      { exact: 149.711, unit: 'px', absolute: 0.1 },
      ({ world, node }) => positionOf(world, node(0, 9)).x,
    ),
    at(
      120,
      'Bottom of the left column, y',
      { exact: 274.793, unit: 'px', absolute: 0.1 },
      ({ world, node }) => positionOf(world, node(0, 9)).y,
    ),
    at(120, 'Lowest point', { exact: 320.022, unit: 'px', absolute: 0.1 }, ({ lowest }) => lowest()),
    at(
      120,
      'Mean place of the knots in the wind, by 126.6 px to the right',
      { exact: 260 + 126.6, unit: 'px', absolute: 0.1, preset: 'In the wind' },
      ({ mean }) => mean('x'),
    ),
    ...(['x', 'y'] as const).map((axis) =>
      at(
        120,
        `Force of the pins in the wind ${axis === 'x' ? 'against the wind' : 'upwards'}: both are equal`,
        { exact: 14700, unit: 'N', relative: 1e-3, preset: 'In the wind' },
        ({ support }) => support(axis),
      ),
    ),
  ],
  tryThis: [
    'Choose “In the wind”: its force is as large as the weight, so the net hangs at 45° on the whole.',
    'Turn gravity off in the wind: the net flies like a flag, straight to the side.',
  ],
});
