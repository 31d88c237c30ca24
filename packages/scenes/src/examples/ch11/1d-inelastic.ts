import { energy, momentum } from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import {
  ENCOUNTER_PARAMETERS,
  ENCOUNTER_PLOTS,
  encounterPicture,
  lostEnergy,
  meetOnLine,
  velocityAfter,
} from '../support/collision-1d.ts';

type Values = ValuesOf<'m1' | 'm2' | 'u1' | 'u2' | 'e'>;

export default defineExample({
  id: 'ch11-1d-inelastic',
  title: 'An inelastic encounter on a line',
  chapter: 11,
  tags: ['collision', 'momentum', 'energy', 'restitution'],
  about:
    'The coefficient of restitution e says with what part of their speed of approach two balls separate. Their momentum does not care; their energy does. At e = 0 they go on together, and all the energy that can be lost without losing momentum is gone.',
  duration: 4,
  ends: true,
  parameters: {
    ...ENCOUNTER_PARAMETERS,
    e: { label: 'Restitution e', initial: 0.5, min: 0, max: 1 },
  },
  presets: [{ label: 'They stay together', values: { e: 0 } }],
  build: (values: Values, options) => meetOnLine(values, options),
  picture: encounterPicture,
  plots: ENCOUNTER_PLOTS,
  checks: ({ at }) => [
    at(
      4,
      'Velocity of the left ball afterwards',
      { exact: ({ m1, m2, u1, u2, e }) => velocityAfter(e, [m1, u1], [m2, u2]), unit: 'px/s', absolute: 1e-9 },
      ({ left, v }) => v(left),
    ),
    at(
      4,
      'Speed of separation, e times that of approach',
      { exact: ({ u1, u2, e }) => e * (u1 - u2), unit: 'px/s', absolute: 1e-9 },
      ({ left, right, v }) => v(right) - v(left),
    ),
    at(
      4,
      'Momentum that is lost',
      { exact: 0, unit: 'kg px/s', absolute: 1e-8 },
      ({ world, start }) => start.momentum - momentum(world).x,
    ),
    at(
      4,
      'Energy that is lost, ½ μ (1 − e²) (u₁ − u₂)²',
      { exact: lostEnergy, unit: 'kg px²/s²', absolute: 1e-6 },
      ({ world, start }) => start.energy - energy(world).kinetic,
    ),
    at(
      4,
      'Common velocity at e = 0',
      { exact: 6500 / 126, unit: 'px/s', absolute: 5e-5, preset: 'They stay together' },
      ({ left, v }) => v(left),
    ),
  ],
  tryThis: ['Give both the same momentum in opposite directions and e = 0: they stop dead.'],
});
