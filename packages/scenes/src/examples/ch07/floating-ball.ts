import { buoyancy, createPhysicsWorld, immersedDrag, spawn, uniformGravity } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { forceArrow, velocityArrow } from '../support/arrows.ts';
import { positionOf, velocityOf } from '../support/read.ts';

const LEVEL = 100;
const RADIUS = 20;
/** Where the centre of the ball rests with the default values. */
const REST = 104.521;
const VIEW = { minX: 0, maxX: 400, minY: 0, maxY: 200 };

export default defineExample({
  id: 'ch07-floating-ball',
  title: 'A beach ball bobs',
  chapter: 7,
  tags: ['buoyancy', 'drag', 'oscillation'],
  about:
    'The fluid pushes up with the weight of what the ball displaces, and how much that is depends on its depth. So the ball bobs about the depth at which both are equal, like a weight on a spring. Drag grows with the square of the speed: it stops a splash soon, and a gentle bobbing hardly ever.',
  duration: 60,
  parameters: {
    gravity: { label: 'Gravity', unit: 'px/s²', initial: 10, min: 2, max: 40 },
    density: { label: 'Density, fluid over ball', unit: '×', initial: 1.5, min: 1.05, max: 4 },
    drag: { label: 'Drag coefficient', unit: 'kg/px', initial: 0.01, min: 0, max: 0.1 },
  },
  presets: [
    { label: 'Hardly lighter than the fluid', values: { density: 1.1 } },
    { label: 'A cork', values: { density: 4 } },
  ],
  build({ gravity, density, drag }, options) {
    const fluid = { density, gravity: { y: gravity }, level: -LEVEL };
    const forces = [uniformGravity({ y: gravity }), buoyancy(fluid), immersedDrag(fluid)];
    const world = createPhysicsWorld({ capacity: 4, forces, ...options });
    const body = { mass: 1, hull: 1, collider: RADIUS, quadraticDrag: drag };
    const ball = spawn(world, { ...body, position: { x: 50, y: 50 }, velocity: { x: 40, y: -20 } });
    // A second ball without drag bobs a little about the depth of rest.
    const bob = spawn(world, { ...body, position: { x: 350, y: REST + 0.4 }, quadraticDrag: 0 });
    /** Fraction of a ball that is under water. */
    const immersed = (id: number) => {
      const d = Math.max(-1, Math.min(1, (positionOf(world, id).y - LEVEL) / RADIUS));
      return 0.5 + (d * (3 - d * d)) / 4;
    };
    return { world, dt: 1 / 60, ball, bob, immersed };
  },
  picture({ world, ball, immersed }, { gravity, density }) {
    const push = () => ({ x: 0, y: -density * gravity * immersed(ball) });
    return {
      yDown: true,
      view: VIEW,
      fills: [
        { shape: { minX: -500, maxX: 900, minY: LEVEL, maxY: 700 }, color: COLORS.water, opacity: 0.45, inFront: true },
      ],
      trails: [{ body: ball, length: 400 }],
      arrows: [
        forceArrow(world, ball, 'weight', () => ({ x: 0, y: gravity }), 3),
        { ...forceArrow(world, ball, 'buoyancy', push, 3), color: COLORS.violet },
        velocityArrow(world, ball, 0.6),
      ],
    };
  },
  plots: (plot) => [
    plot(
      'Depth of the centres',
      'depth, px',
      { label: 'thrown', value: ({ world, ball }) => positionOf(world, ball).y - LEVEL },
      { label: 'without drag', value: ({ world, bob }) => positionOf(world, bob).y - LEVEL },
    ),
    plot('Part under water', 'fraction', { label: 'thrown', value: ({ immersed, ball }) => immersed(ball) }),
  ],
  checks: ({ mean }) => [
    {
      label: 'Deepest point of the first plunge, from the top',
      unit: 'px',
      exact: 153,
      tolerance: { relative: 0.005 },
      at: { event: ({ world, ball }) => (world.time > 3 ? -velocityOf(world, ball).y : -1) },
      measure: ({ world, ball }) => positionOf(world, ball).y,
    },
    {
      label: 'Period of a small bob',
      unit: 's',
      exact: 8.6,
      tolerance: { relative: 0.005 },
      at: { event: ({ world, bob }) => positionOf(world, bob).y - REST, from: 1, to: 2 },
    },
    mean(5 * 8.6, 'Depth of rest: two thirds under water', { exact: 2 / 3, relative: 0.005 }, ({ immersed, bob }) =>
      immersed(bob),
    ),
  ],
  tryThis: [
    'Choose “A cork”: it floats high and bobs fast.',
    'Set the drag to zero: the ball jumps out of the water again and again.',
  ],
});
