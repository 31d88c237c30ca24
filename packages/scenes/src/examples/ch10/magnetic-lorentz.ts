import { boris, createPhysicsWorld, electricField, linearDrag, rgba, spawn } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS, type Line, type Point } from '../picture.ts';
import { forceArrow, velocityArrow } from '../support/arrows.ts';
import { distanceBetween, positionOf, speedOf, velocityOf } from '../support/read.ts';

const START = { x: 350, y: 450 };
const SPEED = 40;

/** A cross with arms of a length. */
function cross({ x, y }: Point, arm: number): Line[] {
  return [-1, 1].map((sign) => ({
    from: { x: x - arm, y: y - sign * arm },
    to: { x: x + arm, y: y + sign * arm },
    color: COLORS.violet,
    width: 2,
  }));
}

export default defineExample({
  id: 'ch10-magnetic-lorentz',
  title: 'A charge in a magnetic field',
  chapter: 10,
  tags: ['magnetic field', 'electric field', 'circular motion'],
  about:
    'A magnetic field, here into the picture, pushes a moving charge at right angles to its path: it bends it into a circle of the radius m v/(q B), and never makes it faster or slower. A circle takes 2π m/(q B), however fast the charge. With an electric field too the circle drifts, across that field.',
  duration: 250,
  parameters: {
    magnetic: { label: 'Magnetic field B', unit: 'T', initial: 0.5, min: 0.1, max: 2 },
    electric: { label: 'Electric field E to the right', unit: 'V/px', initial: 0, min: -5, max: 5 },
    slowing: { label: 'Slowed down by', unit: '1/s', initial: 0, min: 0, max: 0.5 },
  },
  presets: [
    { label: 'A weaker field', values: { magnetic: 0.2 } },
    { label: 'Drift', values: { electric: 1 } },
    { label: 'Spiral', values: { slowing: 0.06003 } },
  ],
  build({ magnetic, electric, slowing }) {
    const integrator = boris({ field: { z: magnetic } });
    const forces = [electricField({ x: electric }), linearDrag()];
    const world = createPhysicsWorld({ capacity: 4, forces, integrator });
    const charge = spawn(world, {
      position: START,
      velocity: { x: SPEED },
      mass: 1,
      charge: 1,
      linearDrag: slowing,
      collider: 7,
      appearance: rgba(1, 0.7, 0.35),
    });
    return { world, dt: 1 / 240, charge };
  },
  picture({ world, charge }, { magnetic, electric }) {
    const force = (): Point => {
      const { x, y } = velocityOf(world, charge);
      return { x: electric + magnetic * y, y: -magnetic * x };
    };
    const radius = SPEED / magnetic;
    const reach = Math.max(100, radius);
    const middle = { x: START.x, y: START.y - radius };
    const grid = [-1.2, -0.4, 0.4, 1.2].flatMap((x) => [-1.2, -0.4, 0.4, 1.2].map((y) => ({ x, y })));
    return {
      yDown: true,
      view: {
        minX: middle.x - 1.6 * reach,
        maxX: middle.x + 1.6 * reach,
        minY: middle.y - 1.6 * reach,
        maxY: middle.y + 1.4 * reach,
      },
      // Crosses are the feathers of arrows that point into the picture.
      lines: grid.flatMap(({ x, y }) => cross({ x: middle.x + x * reach, y: middle.y + y * reach }, 0.03 * reach)),
      trails: [{ body: charge, length: 3000, interval: 4 }],
      arrows: [forceArrow(world, charge, 'force', force, 1.5), velocityArrow(world, charge, 1)],
    };
  },
  plots: (plot) => [
    plot('Speed', 'v, px/s', { label: 'charge', value: ({ world, charge }) => speedOf(world, charge) }),
    plot('Height above the start', 'h, px', {
      label: 'charge',
      value: ({ world, charge }) => START.y - positionOf(world, charge).y,
    }),
  ],
  checks: ({ at, largest }) => [
    largest(
      30,
      'Diameter of the circle, 2 m v/(q B)',
      { exact: 160, unit: 'px', relative: 1e-3 },
      ({ world, charge }) => distanceBetween(positionOf(world, charge), START),
    ),
    {
      label: 'Period, 2π m/(q B)',
      unit: 's',
      exact: 4 * Math.PI,
      tolerance: { relative: 1e-4 },
      at: { event: ({ world, charge }) => positionOf(world, charge).x - START.x, from: 1, to: 2 },
    },
    at(100, 'Speed after 100 s', { exact: SPEED, unit: 'px/s', relative: 1e-12 }, ({ world, charge }) =>
      speedOf(world, charge),
    ),
    {
      label: 'Period in the weaker field',
      unit: 's',
      exact: 10 * Math.PI,
      tolerance: { relative: 1e-4 },
      at: { event: ({ world, charge }) => positionOf(world, charge).x - START.x, from: 1, to: 2 },
      preset: 'A weaker field',
    },
    at(
      32 * Math.PI,
      'Drift upwards in eight turns, E/B',
      { exact: 2, unit: 'px/s', relative: 1e-3, preset: 'Drift' },
      ({ world, charge }) => (START.y - positionOf(world, charge).y) / world.time,
    ),
    // The spiral shrinks by e^(−0.06003 · 250): 80 px become 2.4e-5 px.
    at(
      250,
      'Where the spiral ends, x',
      { exact: 359.47, unit: 'px', absolute: 0.02, preset: 'Spiral' },
      ({ world, charge }) => positionOf(world, charge).x,
    ),
    at(
      250,
      'Where the spiral ends, y',
      { exact: 371.14, unit: 'px', absolute: 0.02, preset: 'Spiral' },
      ({ world, charge }) => positionOf(world, charge).y,
    ),
  ],
  tryThis: [
    'Choose “Drift”: the electric field points to the right, and yet the charge moves upwards.',
    'Choose “A weaker field”: circle and period become two and a half times as large, the speed stays.',
  ],
});
