import {
  attractors,
  createPhysicsWorld,
  exp,
  linearDrag,
  powerLaw,
  rgba,
  rungeKutta4,
  spawn,
} from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { rootOf } from '../support/functions.ts';
import { distanceBetween, positionOf } from '../support/read.ts';

type Values = ValuesOf<'rows' | 'drag' | 'strength'>;

const HALF = 2;
/** Pull of the thread to the middle, 1/s²; height of the bobs above the magnets, m. */
const [SPRING, HEIGHT] = [0.5, 0.25];
const ROOT = Math.sqrt(3) / 2;
/** On a circle of 1 m. The one on the axis of symmetry is added last, so that mirror images agree to the bit. */
const MAGNETS = [
  { x: -1 / 2, y: ROOT },
  { x: -1 / 2, y: -ROOT },
  { x: 1, y: 0 },
];
const PAINTS = [rgba(0.43, 0.72, 1), rgba(1, 0.7, 0.28), rgba(0.37, 0.84, 0.64)];

/** Distance from the middle of the place near a magnet where a bob comes to rest: no force along the axis there. */
function restingDistance(strength: number): number {
  const pull = (x: number) =>
    MAGNETS.reduce((sum, magnet) => {
      const [dx, dy] = [magnet.x - x, magnet.y];
      const square = dx * dx + dy * dy + HEIGHT * HEIGHT;
      return sum + (strength * dx) / (square * Math.sqrt(square));
    }, -SPRING * x);
  return rootOf(pull, 0.8, 1.2);
}

export default defineExample({
  id: 'ch17-magnetic-pendulum',
  title: 'Which magnet will catch the pendulum?',
  chapter: 17,
  tags: ['pendulum', 'magnetism', 'chaos', 'basins of attraction'],
  about:
    'A pendulum swings over three magnets, and air slows it until one of them holds it. Thousands are let go at once, one from each point of the picture, and the point takes the colour of the magnet that is nearest to its pendulum now. Near a magnet the outcome is clear. Elsewhere the colours are mixed ever more finely.',
  duration: 50,
  parameters: {
    rows: { label: 'Rows of pendulums', initial: 64, min: 10, max: 120, integer: true },
    drag: { label: 'Drag', unit: 'kg/s', initial: 0.3, min: 0.05, max: 1 },
    strength: { label: 'Magnets', unit: 'N m²', initial: 1, min: 0.6, max: 3 },
  },
  presets: [
    { label: 'Thick air', values: { drag: 0.8 } },
    { label: 'Thin air', values: { drag: 0.08 } },
  ],
  build({ rows, drag, strength }: Values, { integrator = rungeKutta4 }: BuildOptions) {
    const forces = [attractors(), powerLaw({ strength: -SPRING, exponent: 1 }), linearDrag()];
    const world = createPhysicsWorld({ capacity: 2 * 120 * 120 + 10, forces, integrator });
    for (const position of MAGNETS) spawn(world, { position, attractor: { mu: strength, softening: HEIGHT } });
    const { Position, Appearance } = world.components;
    const size = HALF / rows;
    const places = Array.from({ length: rows * rows }, (_, i) => ({
      x: (2 * (i % rows) + 1 - rows) * size,
      y: (2 * Math.floor(i / rows) + 1 - rows) * size,
    }));
    // First the points of the picture, then the bobs, in the same order.
    const points = places.map((position) => spawn(world, { position, appearance: { size: 1.05 * size, color: 1 } }));
    const bobs = places.map((position) => spawn(world, { position, velocity: {}, mass: 1, linearDrag: drag }));
    const nearest = (id: number) => {
      const [x, y] = [Position.x[id], Position.y[id]];
      let [best, least] = [0, Number.POSITIVE_INFINITY];
      for (let i = 0; i < 3; i++) {
        const [dx, dy] = [x - MAGNETS[i].x, y - MAGNETS[i].y];
        const square = dx * dx + dy * dy;
        if (square < least) [best, least] = [i, square];
      }
      return best;
    };
    const paint = () => {
      for (let i = 0; i < bobs.length; i++) Appearance.color[points[i]] = PAINTS[nearest(bobs[i])];
      // Renderers read colours again.
      world.versions.style++;
    };
    paint();
    world.phases.finish.push(paint);
    /** Bobs that are not where the mirror image of their partner on the other side of the axis is. */
    const asymmetry = () => {
      let count = 0;
      for (let i = 0; i < bobs.length; i++) {
        const mirrored = bobs[(rows - 1 - Math.floor(i / rows)) * rows + (i % rows)];
        if (Position.x[bobs[i]] !== Position.x[mirrored] || Position.y[bobs[i]] !== -Position.y[mirrored]) count++;
      }
      return count;
    };
    const share = (magnet: number) => bobs.filter((id) => nearest(id) === magnet).length / bobs.length;
    return { world, dt: 1 / 60, bobs, share, asymmetry };
  },
  picture({ bobs }) {
    return {
      view: { minX: -HALF, maxX: HALF, minY: -HALF, maxY: HALF },
      dots: MAGNETS.map((at) => ({ at, radius: 6, color: COLORS.white })),
      trails: [{ body: bobs[Math.floor(bobs.length * 0.4)], length: 1500, color: 0x000000 }],
    };
  },
  plots: (plot) => [
    plot(
      'Pendulums nearest to each magnet',
      'share',
      { label: 'upper', value: ({ share }) => share(0) },
      { label: 'lower', value: ({ share }) => share(1) },
      { label: 'right', value: ({ share }) => share(2) },
    ),
  ],
  checks: ({ at }) => [
    at(
      50,
      'Where the last ones rest: distance from the middle, where no force is',
      {
        exact: ({ strength }) => restingDistance(strength),
        // Swings of at most 2 m have died away with e^(−ct/2m).
        holds: ({ drag }) => HALF * exp(-25 * drag) < 2e-3,
        unit: 'm',
        absolute: 2e-3,
      },
      ({ world, bobs }) => Math.max(...bobs.map((id) => distanceBetween(positionOf(world, id), { x: 0, y: 0 }))),
    ),
    at(
      50,
      'Pendulums that are not where the mirror image of their partner is',
      { exact: 0, absolute: 0 },
      ({ asymmetry }) => asymmetry(),
    ),
  ],
  tryThis: [
    'Choose “Thick air”: the pendulums are caught soon, and three clear regions remain.',
    'Choose “Thin air”: hardly a point has neighbours of its own colour, and the end of a swing cannot be predicted.',
  ],
});
