import { createPhysicsWorld, log, rgba, spawn } from '@principia/physics';
import { wrapAround } from '../../edges.ts';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { tanh } from '../support/hyperbolic.ts';
import { PointVortices } from '../support/point-vortices.ts';
import { positionOf, velocityOf } from '../support/read.ts';

type Values = ValuesOf<'ratio' | 'circulation'>;

/** Distance of the vortices of a row, m, and their number, which is even. */
const [SPACING, PER_ROW] = [4, 4];
/** Lines of dye, their distance, m, and drops in a line. */
const [LINES, APART, PER_LINE] = [8, 0.5, 240];
const PERIOD = SPACING * PER_ROW;
const HALF = PERIOD / 2;
/** Radius in which the fluid of a vortex turns like a solid, as drops of dye see it, m. */
const CORE = 0.35;
/** By how much every second vortex is shifted, m. */
const SHIFT = 2e-4 * SPACING;
/** Width over spacing of Kármán's street: cosh π h/a = √2. */
const KARMAN = 0.28055;

const speedOf = ({ ratio, circulation }: Values) => (circulation / (2 * SPACING)) * tanh(Math.PI * ratio);
/** Rate at which a shift of every second vortex grows, 1/s (Lamb, Hydrodynamics, article 156, at φ = π). */
const growthOf = ({ ratio, circulation }: Values) => {
  const t = tanh(Math.PI * ratio);
  // 1/cosh² = 1 − tanh².
  return (Math.abs(t * t - 0.5) * Math.PI * circulation) / (2 * SPACING * SPACING);
};
const wrap = (x: number) => x - PERIOD * Math.round(x / PERIOD);

export default defineExample({
  id: 'ch17-vortex-street',
  title: 'Kármán’s vortex street',
  chapter: 17,
  tags: ['fluid', 'vortex', 'instability', 'wind'],
  about:
    'Behind a post in a stream, a chimney in the wind or an island under clouds, vortices leave to the left and to the right in turn and make two rows. Each is carried by all the others. Kármán found in 1911 that only one width of the street can last: 0.281 of the distance between neighbours. Straight lines of dye, warm above and cold below, show how the rows stir the fluid.',
  duration: 24,
  parameters: {
    ratio: { label: 'Width over spacing', initial: KARMAN, min: 0.1, max: 1 },
    circulation: { label: 'Circulation of a vortex', unit: 'm²/s', initial: 12, min: 2, max: 20 },
  },
  presets: [{ label: 'Too wide', values: { ratio: 0.5 } }],
  build({ ratio, circulation }: Values, options: BuildOptions) {
    const world = createPhysicsWorld({ capacity: 2000, ...options });
    const { Position, Velocity } = world.components;
    const dt = 1 / 60;
    // The upper row turns clockwise; the lower one is shifted by half a spacing.
    const vortices = Array.from({ length: 2 * PER_ROW }, (_, i) => {
      const [isUpper, n] = [i < PER_ROW, i % PER_ROW];
      const x = SPACING * (n + (isUpper ? 0.25 : 0.75)) - HALF + (n % 2 === 0 ? SHIFT : -SHIFT);
      const position = { x, y: ((isUpper ? 1 : -1) * ratio * SPACING) / 2 };
      const appearance = { size: 0.2, color: isUpper ? rgba(1, 0.88, 0.5) : rgba(0.9, 0.95, 1) };
      return {
        id: spawn(world, { position, velocity: {}, appearance }),
        circulation: isUpper ? -circulation : circulation,
      };
    });
    const tracers = Array.from({ length: LINES * PER_LINE }, (_, i) => {
      const y = (Math.floor(i / PER_LINE) - (LINES - 1) / 2) * APART;
      const color = y > 0 ? rgba(1, 0.72 - 0.14 * y, 0.25) : rgba(0.3, 0.65 + 0.14 * y, 1);
      const position = { x: (((i % PER_LINE) + 0.5) / PER_LINE) * PERIOD - HALF, y };
      return spawn(world, { position, velocity: {}, appearance: { size: 0.045, color } });
    });
    const flow = new PointVortices(vortices.length, PERIOD);
    const velocity = { x: 0, y: 0 };
    /** Puts the vortices where they are after `ahead` seconds with their present velocities. */
    const place = (ahead: number) => {
      flow.clear();
      for (const { id, circulation: strength } of vortices) {
        flow.add(Position.x[id] + ahead * Velocity.x[id], Position.y[id] + ahead * Velocity.y[id], strength);
      }
    };
    const carry = (id: number, ahead: number, core: number) => {
      const [x, y] = [Position.x[id] + ahead * Velocity.x[id], Position.y[id] + ahead * Velocity.y[id]];
      flow.velocityAt(x, y, core, velocity);
      Velocity.x[id] = velocity.x;
      Velocity.y[id] = velocity.y;
    };
    world.phases.input.push(wrapAround({ min: { x: -HALF }, max: { x: HALF } }));
    // The fluid sets the velocity, not the acceleration: that of half a step later, by the midpoint rule.
    world.phases.input.push(() => {
      for (const ahead of [0, dt / 2]) {
        place(ahead);
        for (const { id } of vortices) carry(id, ahead, 0);
        for (const id of tracers) carry(id, ahead, CORE);
      }
    });
    const drift = () => -vortices.reduce((sum, { id }) => sum + velocityOf(world, id).x, 0) / vortices.length;
    /** Root mean square of the shifts of every second vortex of both rows, m. */
    const waviness = () => {
      let sum = 0;
      for (let i = 0; i < vortices.length; i += 2) {
        const [a, b] = [positionOf(world, vortices[i].id), positionOf(world, vortices[i + 1].id)];
        const [dx, dy] = [wrap(b.x - a.x) - SPACING, b.y - a.y];
        sum += (dx * dx + dy * dy) / 4;
      }
      return Math.sqrt((2 * sum) / vortices.length);
    };
    return { world, dt, drift, waviness };
  },
  picture() {
    return {
      view: { minX: -HALF, maxX: HALF, minY: -4.5, maxY: 4.5 },
      fills: [{ shape: { minX: -900, maxX: 900, minY: -900, maxY: 900 }, color: 0x060a16 }],
    };
  },
  plots: (plot) => [
    plot('How wavy the rows are', 'ln(shift / m)', {
      label: 'every second vortex',
      value: ({ waviness }) => log(waviness()),
    }),
  ],
  checks: ({ at }) => [
    // Shifts of 2·10⁻⁴ change it by their square; so do steps of 1/60 s, in which the street moves 0.4 % of a spacing.
    at(
      3,
      'Speed of the street against the fluid, Γ/(2a) tanh(π h/a)',
      { exact: speedOf, unit: 'm/s', relative: 1e-4 },
      ({ drift }) => drift(),
    ),
    {
      label: 'ln of how much the shifts of Kármán’s street grow in 20 s',
      exact: 0,
      tolerance: { absolute: 1e-3 },
      at: { event: ({ world }) => world.time - (world.time < 12 ? 1 : 21), from: 1, to: 2 },
      measure: ({ waviness }) => log(waviness()),
    },
    {
      label: 'ln of how much the shifts of a street that is too wide grow in 4 s',
      exact: 4 * growthOf({ ratio: 0.5, circulation: 12 }),
      // The shifts are below 0.01 of the spacing; what is not linear in them is of their square.
      tolerance: { relative: 1e-3 },
      at: { event: ({ world }) => world.time - (world.time < 8 ? 6 : 10), from: 1, to: 2 },
      measure: ({ waviness }) => log(waviness()),
      preset: 'Too wide',
    },
  ],
  tryThis: [
    'Choose “Too wide” and wait: the shifts double every 1.7 s until the rows fall apart.',
    'Find a width that lasts: at 0.281 of the spacing the two rows hold each other in place.',
  ],
});
