import { boris, createPhysicsWorld, electricField, linearDrag, rgba, spawn } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS, type Point } from '../picture.ts';
import { forceArrow, velocityArrow } from '../support/arrows.ts';
import { distanceBetween, positionOf, speedOf, velocityOf } from '../support/read.ts';

const START = { x: 350, y: 450 };
const SPEED = 40;

export default defineExample({
  id: 'ch10-magnetic-lorentz',
  title: 'A charge in a magnetic field',
  chapter: 10,
  tags: ['magnetic field', 'electric field', 'circular motion'],
  about:
    'A magnetic field, here out of the picture, pushes a moving charge at right angles to its path: it bends it into a circle of the radius m v/(q B), and never makes it faster or slower. A circle takes 2π m/(q B), however fast the charge. With an electric field too the circle drifts, across that field.',
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
      dots: grid.map(({ x, y }) => ({
        at: { x: middle.x + x * reach, y: middle.y + y * reach },
        radius: 3,
        color: COLORS.violet,
      })),
      trails: [{ body: charge, length: 3000, interval: 4 }],
      arrows: [forceArrow(world, charge, 'force', force, 1.5), velocityArrow(world, charge, 1)],
    };
  },
  plots: [
    {
      title: 'Speed',
      y: { label: 'v, px/s' },
      series: [{ label: 'charge', value: ({ world, charge }) => speedOf(world, charge) }],
    },
    {
      title: 'Height',
      y: { label: 'y, px' },
      series: [{ label: 'charge', value: ({ world, charge }) => positionOf(world, charge).y }],
    },
  ],
  checks: [
    {
      label: 'Diameter of the circle, 2 m v/(q B)',
      unit: 'px',
      exact: 160,
      tolerance: { relative: 1e-3 },
      at: { until: 30, take: 'largest' },
      measure: ({ world, charge }) => distanceBetween(positionOf(world, charge), START),
    },
    {
      label: 'Period, 2π m/(q B)',
      unit: 's',
      exact: 12.5664,
      tolerance: { relative: 1e-4 },
      at: { event: ({ world, charge }) => positionOf(world, charge).x - START.x, from: 1, to: 2 },
    },
    {
      label: 'Speed after 100 s',
      unit: 'px/s',
      exact: SPEED,
      tolerance: { relative: 1e-12 },
      at: { time: 100 },
      measure: ({ world, charge }) => speedOf(world, charge),
    },
    {
      label: 'Period in the weaker field',
      unit: 's',
      exact: 31.416,
      tolerance: { relative: 1e-4 },
      at: { event: ({ world, charge }) => positionOf(world, charge).x - START.x, from: 1, to: 2 },
      preset: 'A weaker field',
    },
    {
      label: 'Drift upwards in eight turns, E/B',
      unit: 'px/s',
      exact: 2,
      tolerance: { relative: 1e-3 },
      at: { time: 32 * Math.PI },
      measure: ({ world, charge }) => (START.y - positionOf(world, charge).y) / world.time,
      preset: 'Drift',
    },
    {
      label: 'Where the spiral ends, x',
      unit: 'px',
      // The spiral shrinks by e^(−0.06003 · 250): 80 px become 2.4e-5 px.
      exact: 359.47,
      tolerance: { absolute: 0.02 },
      at: { time: 250 },
      measure: ({ world, charge }) => positionOf(world, charge).x,
      preset: 'Spiral',
    },
    {
      label: 'Where the spiral ends, y',
      unit: 'px',
      exact: 371.14,
      tolerance: { absolute: 0.02 },
      at: { time: 250 },
      measure: ({ world, charge }) => positionOf(world, charge).y,
      preset: 'Spiral',
    },
  ],
  tryThis: [
    'Choose “Drift”: the electric field points to the right, and yet the charge moves upwards.',
    'Choose “A weaker field”: circle and period become two and a half times as large, the speed stays.',
  ],
});
