import { buoyancy, createPhysicsWorld, immersedDrag, spawn, springs, uniformGravity } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { distanceBetween, positionOf, speedOf } from '../support/read.ts';

const [GRAVITY, FLUID, LENGTH] = [10, 1, 3];
/** Stiffness of the balance and drag of the cube on it, for each kilogram that hangs there: all come to rest alike. */
const [STIFFNESS, DRAG] = [8, 0.6];
const HOOK = { x: 3, y: 2 };
/** Half the side of the cubes, m. */
const HALF = 0.5;

export default defineExample({
  id: 'ch07-apparent-weight',
  title: 'Float, hover or hang',
  chapter: 7,
  tags: ['buoyancy', 'Archimedes', 'density'],
  about:
    'Three cubes of the same size in water. The first is lighter than water and floats, 90 % of it under the surface if its density is 0.9 of that of water. The second has just the density of water and hovers anywhere. The third is heavier; on the spring balance it weighs less than in air, by the weight of the water whose place it takes.',
  duration: 60,
  parameters: {
    light: { label: 'Density of the first', unit: '× water', initial: 0.9, min: 0.1, max: 0.95 },
    heavy: { label: 'Density of the third', unit: '× water', initial: 2.5, min: 1.5, max: 12 },
  },
  presets: [{ label: 'Cork and lead', values: { light: 0.2, heavy: 11.3 } }],
  build({ light, heavy }, options) {
    const fluid = { density: FLUID, gravity: { y: -GRAVITY }, level: 0 };
    const forces = [uniformGravity({ y: -GRAVITY }), buoyancy(fluid), immersedDrag(fluid), springs()];
    const world = createPhysicsWorld({ capacity: 8, forces, ...options });
    const hull = { volume: 8 * HALF * HALF * HALF, halfHeight: HALF, shape: 1 };
    const cube = (x: number, y: number, density: number, linearDrag = 1.5) =>
      spawn(world, { position: { x, y }, velocity: {}, mass: density, hull, linearDrag });
    const [floating, hovering] = [cube(-3, 0.4, light), cube(0, -2, FLUID)];
    const hanging = cube(HOOK.x, -1.5, heavy, DRAG * heavy);
    const stiffness = STIFFNESS * heavy;
    const hook = spawn(world, { position: HOOK });
    spawn(world, { spring: { a: hook, b: hanging, stiffness, length: LENGTH } });
    const balance = () => stiffness * (distanceBetween(positionOf(world, hanging), HOOK) - LENGTH);
    const immersed = () => Math.min(1, Math.max(0, 0.5 - positionOf(world, floating).y / (2 * HALF)));
    return { world, dt: 1 / 60, floating, hovering, hanging, balance, immersed };
  },
  picture({ world, floating, hovering, hanging, balance, immersed }) {
    const sides = [floating, hovering, hanging].flatMap((id, k) => {
      const corner = (x: number, y: number) => () => ({
        x: positionOf(world, id).x + HALF * x,
        y: positionOf(world, id).y + HALF * y,
      });
      const corners = [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)];
      const color = [COLORS.orange, COLORS.green, COLORS.violet][k];
      return corners.map((from, i) => ({ from, to: corners[(i + 1) % 4], width: 5, color }));
    });
    return {
      view: { minX: -5, maxX: 5, minY: -4, maxY: 2.6 },
      fills: [{ shape: { minX: -40, maxX: 40, minY: -40, maxY: 0 }, color: COLORS.water, opacity: 0.45 }],
      lines: [{ from: { x: 2.4, y: HOOK.y }, to: { x: 3.6, y: HOOK.y }, color: COLORS.grey, width: 5 }, ...sides],
      springs: { coils: 12 },
      labels: [
        { at: { x: -4.5, y: 1.4 }, text: () => `${(100 * immersed()).toFixed(1)} % under water` },
        { at: { x: 3.8, y: 0.8 }, text: () => `${balance().toFixed(2)} N` },
      ],
    };
  },
  plots: (plot) => [
    plot('The balance shows', 'force, N', { label: 'spring', value: ({ balance }) => balance() }),
    plot('Part of the first cube under water', 'fraction', {
      label: 'cube',
      value: ({ immersed }) => immersed(),
      exact: (_, { light }) => light,
    }),
  ],
  checks: ({ at }) => [
    at(
      60,
      'Part of the floating cube under water, ρ/ρ_water',
      { exact: ({ light }) => light, relative: 1e-6 },
      ({ immersed }) => immersed(),
    ),
    at(60, 'Speed of the hovering cube after 60 s', { exact: 0, unit: 'm/s', absolute: 1e-12 }, ({ world, hovering }) =>
      speedOf(world, hovering),
    ),
    at(
      60,
      'Apparent weight of the third, (ρ − ρ_water) V g',
      { exact: ({ heavy }) => (heavy - FLUID) * GRAVITY, unit: 'N', relative: 1e-6 },
      ({ balance }) => balance(),
    ),
  ],
  tryThis: [
    'Set the density of the first to 0.5: it floats with half of it under water.',
    'Choose “Cork and lead”: in water lead keeps nine tenths of its weight, 10.3 of 11.3.',
  ],
});
