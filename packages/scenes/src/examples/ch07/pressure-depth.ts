import { buoyancy, createPhysicsWorld, linearDrag, spawn, uniformGravity } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { forceArrow } from '../support/arrows.ts';
import { positionOf } from '../support/read.ts';

const GRAVITY = 9.81;
/** Half the length of the tube, m; its foot has an area of one square metre. */
const HALF = 10;

export default defineExample({
  id: 'ch07-pressure-depth',
  title: 'A tube that measures pressure',
  chapter: 7,
  tags: ['pressure', 'buoyancy', 'fluids'],
  about:
    'A long tube stands in water. Only the pressure on its foot, of one square metre, pushes it up. It sinks until this push equals its weight. With ten tonnes that is at ten metres: there the water presses with 98.1 kPa, as much again as the air above.',
  duration: 40,
  parameters: {
    mass: { label: 'Mass of the tube', unit: 't', initial: 10, min: 1, max: 15 },
    density: { label: 'Density of the fluid', unit: 'kg/m³', initial: 1000, min: 800, max: 1300 },
  },
  presets: [{ label: 'Five tonnes', values: { mass: 5 } }],
  build({ mass, density }, options) {
    const fluid = { density, gravity: { y: -GRAVITY }, level: 0 };
    const forces = [uniformGravity({ y: -GRAVITY }), buoyancy(fluid), linearDrag()];
    const world = createPhysicsWorld({ capacity: 4, forces, ...options });
    const hull = { volume: 2 * HALF, halfHeight: HALF, shape: 1 };
    const body = { position: { y: HALF - 2 }, mass: 1000 * mass, hull, linearDrag: 1200 * mass };
    const tube = spawn(world, body);
    const depth = () => HALF - positionOf(world, tube).y;
    return { world, dt: 1 / 60, tube, depth, pressure: () => (density * GRAVITY * depth()) / 1000 };
  },
  picture({ world, tube, depth, pressure }, { mass }) {
    const side = (x: number, end: number) => () => ({ x, y: positionOf(world, tube).y + end * HALF });
    const foot = () => ({ x: 0, y: positionOf(world, tube).y - HALF });
    return {
      view: { minX: -16, maxX: 16, minY: -17, maxY: 12 },
      fills: [{ shape: { minX: -100, maxX: 100, minY: -100, maxY: 0 }, color: COLORS.water, opacity: 0.5 }],
      lines: [
        { from: side(-1, -1), to: side(-1, 1), width: 4, color: COLORS.orange },
        { from: side(1, -1), to: side(1, 1), width: 4, color: COLORS.orange },
        { from: side(-1, -1), to: side(1, -1), width: 6, color: COLORS.orange },
        ...[-5, -10, -15].map((y) => ({ from: { x: 6, y }, to: { x: 7, y }, color: COLORS.grey })),
      ],
      labels: [
        ...[-5, -10, -15].map((y) => ({ at: { x: 7.5, y }, text: `${-y} m`, color: COLORS.grey })),
        { at: () => ({ x: 2, y: foot().y }), text: () => `${depth().toFixed(2)} m, ${pressure().toFixed(1)} kPa` },
      ],
      arrows: [
        forceArrow(world, tube, 'weight', () => ({ x: 0, y: -mass * GRAVITY }), 0.05),
        { label: 'pressure', from: foot, vector: () => ({ x: 0, y: pressure() }), scale: 0.05, color: COLORS.violet },
      ],
    };
  },
  plots: (plot) => [
    {
      title: 'Pressure on the foot',
      x: { label: 'depth, m', value: ({ depth }) => depth() },
      y: { label: 'p, kPa' },
      series: [{ label: 'foot', value: ({ pressure }) => pressure() }],
    },
    plot('Depth of the foot', 'depth, m', { label: 'foot', value: ({ depth }) => depth() }),
  ],
  checks: ({ at }) => [
    at(
      40,
      'Depth at which it floats, m/(ρ A)',
      { exact: ({ mass, density }) => (1000 * mass) / density, unit: 'm', relative: 1e-6 },
      ({ depth }) => depth(),
    ),
    at(40, 'Pressure there, above that of the air', { exact: 98.1, unit: 'kPa', relative: 1e-6 }, ({ pressure }) =>
      pressure(),
    ),
  ],
  tryThis: [
    'Choose “Five tonnes”: the tube floats at half the depth, where the pressure is half as large.',
    'Make the fluid denser, as the Dead Sea with 1240: the tube rises.',
  ],
});
