import { buoyancy, createPhysicsWorld, immersedDrag, rgba, spawn, uniformGravity } from '@principia/physics';
import { teleport } from '../../teleport.ts';
import { defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { positionOf, velocityOf } from '../support/read.ts';

const LEVEL = 300;
/** Where the centre of the ball rests with the default values: it is 2/3 under water. */
const REST = 309.043;
/** Where the ball is thrown from, and how. */
const THROW = [
  { x: 50, y: 50 },
  { x: 40, y: -20 },
] as const;
const VIEW = { minX: 0, maxX: 700, minY: 0, maxY: 500 };

export default defineExample({
  id: 'ch05-floating-ball',
  title: 'A ball thrown into water',
  chapter: 5,
  tags: ['buoyancy', 'drag', 'oscillation'],
  about:
    'The ball falls into the water, and buoyancy ρ V g, by the immersed fraction of its volume, throws it out again. Drag acts in the water only. It comes to rest where it displaces its own weight: two thirds of it under water.',
  duration: 30,
  parameters: {
    gravity: { label: 'Gravity', unit: 'px/s²', initial: 50, min: 1, max: 100 },
    density: { label: 'Density, fluid over ball', unit: '×', initial: 1.5, min: 1.05, max: 4 },
    drag: { label: 'Drag coefficient', unit: 'kg/px', initial: 0.01, min: 0, max: 0.1 },
  },
  build({ gravity, density, drag }, options) {
    const fluid = { density, gravity: { y: gravity }, level: -LEVEL };
    const forces = [uniformGravity({ y: gravity }), buoyancy(fluid), immersedDrag(fluid)];
    const world = createPhysicsWorld({ capacity: 4, forces, ...options });
    const body = { mass: 1, hull: 1, collider: 40, quadraticDrag: drag, appearance: rgba(1, 0.7, 0.28) };
    const ball = spawn(world, { position: THROW[0], velocity: THROW[1], ...body });
    // A second ball, without drag, bobs a little about the depth at which it rests.
    const bob = spawn(world, { ...body, position: { x: 560, y: REST + 0.8 }, quadraticDrag: 0 });
    return { world, dt: 1 / 60, ball, bob };
  },
  picture({ world, ball }) {
    return {
      yDown: true,
      view: VIEW,
      fills: [{ shape: { ...VIEW, minY: LEVEL }, color: COLORS.water, opacity: 0.45, inFront: true }],
      trails: [{ body: ball, length: 300 }],
      arrows: [velocityArrow(world, ball, 0.5)],
    };
  },
  actions: {
    action: {
      label: 'Throw',
      about: 'throw the ball again',
      key: 't',
      press: ({ world, ball }) => teleport(world, ball, ...THROW),
    },
  },
  pointer: {
    about: 'put the ball there; a drag throws it',
    aims: true,
    release: ({ world, ball }, at, from) => teleport(world, ball, from, { x: at.x - from.x, y: at.y - from.y }),
  },
  plots: (plot) => [
    plot('Depth of the centre', 'depth, px', {
      label: 'depth',
      value: ({ world, ball }) => positionOf(world, ball).y - LEVEL,
    }),
  ],
  checks: ({ mean }) => [
    {
      label: 'Deepest point of the first plunge, from the top',
      unit: 'px',
      exact: 416.8,
      tolerance: { relative: 0.005 },
      at: { event: ({ world, ball }) => (world.time > 1.5 ? -velocityOf(world, ball).y : -1) },
      measure: ({ world, ball }) => positionOf(world, ball).y,
    },
    {
      label: 'Period of a small bob',
      unit: 's',
      exact: 5.439,
      tolerance: { relative: 0.005 },
      at: { event: ({ world, bob }) => positionOf(world, bob).y - REST, from: 1, to: 2 },
    },
    mean(
      5 * 5.439,
      'Mean depth of the bob in five periods',
      { exact: REST - LEVEL, unit: 'px', relative: 0.005 },
      ({ world, bob }) => positionOf(world, bob).y - LEVEL,
    ),
  ],
  tryThis: [
    'Set the drag to zero: the ball jumps out of the water for ever.',
    'Make the fluid denser: the ball floats higher, and bobs faster.',
  ],
});
