import { atan2, createPhysicsWorld, momentum, mutualCoulomb, rgba, rungeKutta4, spawn } from '@principia/physics';
import { choiceOf, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { lengthOf, positionOf, velocityOf } from '../support/read.ts';

const CONSTANT = 1e4;
/** Two bodies of 1 kg move about each other like one of half a kilogram. */
const REDUCED = 0.5;
/** The gap at which the fall is measured, px. */
const NEAR = 10;

type Values = ValuesOf<'charge' | 'opposite' | 'gap'>;

const strength = ({ charge }: Values) => CONSTANT * charge * charge;
/** Time in which opposite charges fall from rest to a fraction x of their distance. */
function fallTime(values: Values, x: number): number {
  const scale = Math.sqrt((REDUCED * values.gap * values.gap * values.gap) / (2 * strength(values)));
  return scale * (Math.sqrt(x * (1 - x)) + atan2(Math.sqrt(1 - x), Math.sqrt(x)));
}

export default defineExample({
  id: 'ch10-charge-pair',
  title: 'Two charges',
  chapter: 10,
  tags: ['charges', 'Coulomb', 'momentum', 'energy'],
  about:
    'Like charges push each other apart, ever faster, but never faster than 20 px/s, because the push fades with the distance. Opposite ones fall together in 7.85 s: slowly at first and then in a rush. The forces of the two are equal and opposite, so that the middle stays where it is.',
  duration: 60,
  parameters: {
    opposite: choiceOf('Charges', ['like', 'opposite']),
    charge: { label: 'Size of the charges', unit: 'C', initial: 1, min: 0.3, max: 2 },
    gap: { label: 'Distance at the start', unit: 'px', initial: 100, min: 40, max: 200 },
  },
  presets: [{ label: 'Opposite charges', values: { opposite: 1 } }],
  build({ opposite, charge, gap }, { integrator = rungeKutta4 }) {
    // A small softening keeps the path finite where opposite charges fly through each other.
    const force = mutualCoulomb({ k: CONSTANT, softening: 0.1 });
    const world = createPhysicsWorld({ capacity: 5, forces: [force], integrator });
    const add = (x: number, value: number) => {
      const appearance = value > 0 ? rgba(0.95, 0.35, 0.35) : rgba(0.35, 0.55, 1);
      return spawn(world, { position: { x }, velocity: {}, mass: 1, charge: value, collider: 5, appearance });
    };
    const left = add(-gap / 2, charge);
    const right = add(gap / 2, opposite === 1 ? -charge : charge);
    const distance = () => positionOf(world, right).x - positionOf(world, left).x;
    const parting = () => velocityOf(world, right).x - velocityOf(world, left).x;
    return { world, dt: 1 / 1000, left, right, distance, parting };
  },
  picture({ world, left, right }, { gap, opposite }) {
    const reach = opposite === 1 ? gap : 4 * gap;
    return {
      view: { minX: -reach, maxX: reach, minY: -0.5 * reach, maxY: 0.5 * reach },
      dots: [{ at: { x: 0, y: 0 }, radius: 3, color: COLORS.grey }],
      trails: [
        { body: left, length: 2000, interval: 10 },
        { body: right, length: 2000, interval: 10 },
      ],
      arrows: [velocityArrow(world, left, 3), velocityArrow(world, right, 3)],
      labels: [left, right].map((id, i) => ({
        at: () => ({ x: positionOf(world, id).x, y: 0.1 * reach }),
        text: i === 1 && opposite === 1 ? '−' : '+',
      })),
    };
  },
  plots: (plot) => [
    plot('Speed at which they part', 'v, px/s', { label: 'relative', value: ({ parting }) => parting() }),
    plot('Distance', 'd, px', { label: 'gap', value: ({ distance }) => distance() }),
  ],
  checks: ({ at }) => [
    // What is left of the potential energy still speeds them up.
    at(
      50,
      'Speed that they would part with in the end, √(2k q²/(μ d))',
      { exact: 20, unit: 'px/s', relative: 0.005 },
      ({ distance, parting }) => Math.sqrt(parting() * parting() + (2 * CONSTANT) / (REDUCED * distance())),
    ),
    at(50, 'Momentum of both after 50 s', { exact: 0, unit: 'kg px/s', absolute: 1e-12 }, ({ world }) =>
      lengthOf(momentum(world)),
    ),
    {
      label: 'Time until opposite charges are 10 px apart; they meet after 7.854 s',
      unit: 's',
      exact: (values) => fallTime(values, NEAR / values.gap),
      tolerance: { relative: 0.005 },
      at: { event: ({ distance }) => NEAR - distance() },
      preset: 'Opposite charges',
    },
  ],
  tryThis: [
    'Choose “Opposite charges”: the first half of the distance takes four fifths of the time.',
    'Double the charges: everything happens twice as fast.',
  ],
});
