import {
  boxWalls,
  buoyancy,
  createPhysicsWorld,
  exp,
  keepState,
  log,
  quadraticDrag,
  rgba,
  spawn,
  uniformGravity,
} from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { forceArrow, velocityArrow } from '../support/arrows.ts';
import { held } from '../support/held.ts';
import { tanh } from '../support/hyperbolic.ts';
import { positionOf, velocityOf } from '../support/read.ts';

const GROUND = 450;
const GRAVITY = 10;
const AIR = 1.2;
/** Change of the density while a key is held, 1/s. */
const RATE = 0.06;

type Values = ValuesOf<'density' | 'drag'>;

const lift = ({ density }: Values) => GRAVITY * (AIR / density - 1);
const terminal = (values: Values) => Math.sqrt(lift(values) / values.drag);
/** Upward speed of a balloon that starts at rest. */
const speedAt = (t: number, values: Values) =>
  values.drag === 0 ? lift(values) * t : terminal(values) * tanh((lift(values) / terminal(values)) * t);

function heat({ burner }: { readonly burner: { change: number } }, rate: number): void {
  burner.change = rate;
}

export default defineExample({
  id: 'ch07-balloon',
  title: 'A hot-air balloon',
  chapter: 7,
  tags: ['buoyancy', 'drag', 'terminal speed'],
  about:
    'The air pushes the balloon up with the weight of the air whose place it takes. Its hot air is lighter, so it rises, until drag balances what is left of the lift. Heat it, and it takes more room; cool it to the density of the air, 1.2 kg/m³, and nothing drives it any more.',
  duration: 40,
  parameters: {
    density: { label: 'Density of the balloon', unit: 'kg/m³', initial: 1.1, min: 1, max: 1.19 },
    drag: { label: 'Drag coefficient', unit: 'kg/px', initial: 0.01, min: 0, max: 0.05 },
  },
  presets: [{ label: 'No drag', values: { drag: 0 } }],
  build({ density, drag }: Values, options: BuildOptions) {
    const air = { density: AIR, gravity: { y: GRAVITY } };
    const forces = [uniformGravity({ y: GRAVITY }), buoyancy(air), quadraticDrag()];
    const walls = [boxWalls({ max: { y: GROUND } })];
    const world = createPhysicsWorld({ capacity: 4, forces, walls, ...options });
    const position = { x: 350, y: GROUND - 30 };
    const appearance = rgba(1, 0.45, 0.35);
    const balloon = spawn(world, {
      position,
      mass: 1,
      collider: 30,
      hull: 1 / density,
      quadraticDrag: drag,
      appearance,
    });
    const burner = { density, change: 0 };
    keepState(world, burner);
    world.phases.input.push(() => {
      burner.density = Math.min(2, Math.max(1, burner.density + burner.change / 60));
      if (burner.change !== 0) world.components.Hull.volume[balloon] = 1 / burner.density;
    });
    const height = () => position.y - positionOf(world, balloon).y;
    const rise = () => -velocityOf(world, balloon).y;
    return { world, dt: 1 / 60, balloon, burner, height, rise };
  },
  picture({ world, balloon, burner }) {
    const at = () => positionOf(world, balloon);
    const corner = (x: number) => () => ({ x: at().x + 12 * x, y: at().y + 28 });
    const basket = (x: number) => () => ({ x: at().x + 8 * x, y: at().y + 50 });
    return {
      yDown: true,
      view: { minX: 50, maxX: 650, minY: 20, maxY: 500 },
      fills: [
        { shape: { minX: -2000, maxX: 3000, minY: -2000, maxY: GROUND + 22 }, color: 0x274a7a },
        { shape: { minX: -2000, maxX: 3000, minY: GROUND + 22, maxY: 2000 }, color: 0x2f6b45 },
      ],
      lines: [
        { from: corner(-1), to: basket(-1), width: 1 },
        { from: corner(1), to: basket(1), width: 1 },
        { from: basket(-1), to: basket(1), width: 6, color: COLORS.orange },
      ],
      arrows: [
        forceArrow(world, balloon, 'weight', () => ({ x: 0, y: GRAVITY }), 8),
        {
          ...forceArrow(world, balloon, 'buoyancy', () => ({ x: 0, y: (-GRAVITY * AIR) / burner.density }), 8),
          color: COLORS.violet,
        },
        velocityArrow(world, balloon, 4),
      ],
      labels: [{ at: () => ({ x: at().x + 50, y: at().y }), text: () => `density ${burner.density.toFixed(3)} kg/m³` }],
    };
  },
  actions: {
    up: held('▲', 'arrowup', 'heat the air: its density falls', heat, -RATE),
    down: held('▼', 'arrowdown', 'cool the air: its density rises', heat, RATE),
  },
  plots: (plot) => [
    plot('Upward speed', 'v, px/s', { label: 'stepped', value: ({ rise }) => rise(), exact: speedAt }),
    plot('Height', 'h, px', { label: 'balloon', value: ({ height }) => height() }),
  ],
  checks: ({ at }) => [
    at(
      0.1,
      'Acceleration at the start, g (ρ/ρ_b − 1)',
      { exact: lift, unit: 'px/s²', relative: 1e-3 },
      ({ world, rise }) => rise() / world.time,
    ),
    at(10, 'Speed after 10 s', { exact: 7.0685, unit: 'px/s', relative: 1e-3 }, ({ rise }) => rise()),
    at(
      40,
      'Speed after 40 s; the limit is √(a m/k) = 9.5346',
      { exact: (values) => speedAt(40, values), unit: 'px/s', relative: 1e-3 },
      ({ rise }) => rise(),
    ),
    at(
      40,
      'Height after 40 s, (m/k) ln cosh(a t/v)',
      {
        exact: (values) => {
          if (values.drag === 0) return 800 * lift(values);
          const u = (lift(values) / terminal(values)) * 40;
          return log((exp(u) + exp(-u)) / 2) / values.drag;
        },
        unit: 'px',
        relative: 1e-3,
      },
      ({ height }) => height(),
    ),
    at(
      20,
      'Height after 20 s without drag, ½ a t²',
      { exact: (values) => 200 * lift(values), unit: 'px', absolute: 1e-9, preset: 'No drag' },
      ({ height }) => height(),
    ),
  ],
  tryThis: [
    'Hold the key that cools until the label says 1.200 kg/m³: the balloon keeps floating up, ever more slowly.',
    'Choose “No drag”: the balloon goes faster and faster.',
  ],
});
