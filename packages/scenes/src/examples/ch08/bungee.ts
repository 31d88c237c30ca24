import { createPhysicsWorld, quadraticDrag, spawn, springs, uniformGravity } from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS, type Point } from '../picture.ts';
import { forceArrow, velocityArrow } from '../support/arrows.ts';
import { distanceBetween, positionOf, velocityOf } from '../support/read.ts';

const BRIDGE = { x: 350, y: 50 };
const [GRAVITY, STIFFNESS] = [20, 25];

type Values = ValuesOf<'mass' | 'cord' | 'drag' | 'aside'>;

/** Lowest point of a jump without drag, from the energy. */
function lowest({ mass, cord }: Values): number {
  const weight = mass * GRAVITY;
  return BRIDGE.y + cord + (weight + Math.sqrt(weight * weight + 2 * weight * STIFFNESS * cord)) / STIFFNESS;
}

export default defineExample({
  id: 'ch08-bungee',
  title: 'A bungee jump',
  chapter: 8,
  tags: ['spring', 'gravity', 'energy', 'oscillation'],
  about:
    'The jumper falls freely until the cord is taut. Then the cord pulls, the harder the longer it is; it never pushes. At the lowest point all the energy of the fall is in the cord, which throws the jumper up again. Drag makes each swing smaller.',
  duration: 60,
  parameters: {
    mass: { label: 'Mass of the jumper', unit: 'kg', initial: 90, min: 40, max: 120 },
    cord: { label: 'Length of the cord', unit: 'px', initial: 100, min: 40, max: 150 },
    drag: { label: 'Drag coefficient', unit: 'kg/px', initial: 0.02, min: 0, max: 10 },
    aside: { label: 'Jumps from the left by', unit: 'px', initial: 0, min: 0, max: 90 },
  },
  presets: [
    { label: 'No drag', values: { drag: 0 } },
    { label: 'From the side', values: { aside: 50 } },
    { label: 'In thick oil', values: { drag: 10 } },
  ],
  build({ mass, cord, drag, aside }, options) {
    const forces = [uniformGravity({ y: GRAVITY }), quadraticDrag(), springs()];
    const world = createPhysicsWorld({ capacity: 8, forces, ...options });
    const bridge = spawn(world, { position: BRIDGE });
    const position = { x: BRIDGE.x - aside, y: BRIDGE.y };
    const jumper = spawn(world, { position, mass, collider: 8, quadraticDrag: drag });
    spawn(world, { spring: { a: bridge, b: jumper, stiffness: STIFFNESS, length: cord, tensionOnly: 1 } });
    return { world, dt: 1 / 60, jumper };
  },
  picture({ world, jumper }, { mass, cord }) {
    const at = () => positionOf(world, jumper);
    const pull = (): Point => {
      const [{ x, y }, length] = [at(), distanceBetween(at(), BRIDGE)];
      const tension = Math.max(0, STIFFNESS * (length - cord)) / Math.max(length, 1e-9);
      return { x: tension * (BRIDGE.x - x), y: tension * (BRIDGE.y - y) };
    };
    const limb = (x: number, y: number, toX: number, toY: number) => ({
      from: () => ({ x: at().x + x, y: at().y + y }),
      to: () => ({ x: at().x + toX, y: at().y + toY }),
      width: 3,
    });
    return {
      yDown: true,
      view: { minX: 100, maxX: 600, minY: 20, maxY: 430 },
      fills: [
        { shape: { minX: 60, maxX: 640, minY: 34, maxY: 48 }, color: COLORS.ground },
        { shape: { minX: -500, maxX: 1500, minY: 400, maxY: 900 }, color: COLORS.water, opacity: 0.6 },
      ],
      springs: 'lines',
      lines: [limb(0, 8, 0, 26), limb(0, 26, -6, 38), limb(0, 26, 6, 38), limb(-9, 14, 9, 14)],
      arrows: [
        forceArrow(world, jumper, 'weight', () => ({ x: 0, y: mass * GRAVITY }), 0.02),
        { ...forceArrow(world, jumper, 'cord', pull, 0.02), color: COLORS.yellow },
        velocityArrow(world, jumper, 0.6),
      ],
    };
  },
  plots: (plot) => [
    plot('Depth below the bridge', 'depth, px', {
      label: 'jumper',
      value: ({ world, jumper }) => positionOf(world, jumper).y - BRIDGE.y,
    }),
    plot('Speed downwards', 'v, px/s', { label: 'jumper', value: ({ world, jumper }) => velocityOf(world, jumper).y }),
  ],
  checks: ({ at, largest }) => [
    largest(
      12,
      'Lowest point, from the top',
      { exact: 356.1, unit: 'px', relative: 0.005 },
      ({ world, jumper }) => positionOf(world, jumper).y,
    ),
    largest(
      12,
      'Lowest point without drag, from the energy',
      { exact: lowest, unit: 'px', relative: 0.005, preset: 'No drag' },
      ({ world, jumper }) => positionOf(world, jumper).y,
    ),
    at(
      3,
      'Distance in the first 3 s, ½ g t²: the slack cord does not push',
      { exact: 90, unit: 'px', absolute: 1e-9, preset: 'No drag' },
      ({ world, jumper }) => positionOf(world, jumper).y - BRIDGE.y,
    ),
    {
      label: 'Time until the cord is taut, √(2L/g)',
      unit: 's',
      exact: Math.sqrt(10),
      tolerance: { relative: 0.005 },
      at: { event: ({ world, jumper }) => positionOf(world, jumper).y - 150 },
      preset: 'No drag',
    },
    {
      label: 'Speed then, √(2gL)',
      unit: 'px/s',
      exact: 20 * Math.sqrt(10),
      tolerance: { relative: 0.005 },
      at: { event: ({ world, jumper }) => positionOf(world, jumper).y - 150 },
      measure: ({ world, jumper }) => velocityOf(world, jumper).y,
      preset: 'No drag',
    },
    at(
      60,
      'Where the jumper comes to rest, 50 + L + mg/k',
      { exact: 222, unit: 'px', relative: 0.005, preset: 'In thick oil' },
      ({ world, jumper }) => positionOf(world, jumper).y,
    ),
  ],
  tryThis: [
    'Take a heavier jumper without a shorter cord: at 110 kg the feet get wet.',
    'Choose “From the side”: the jumper swings as well as bounces.',
  ],
});
