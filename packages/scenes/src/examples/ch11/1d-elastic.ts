import { energy, momentum } from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import {
  ENCOUNTER_PARAMETERS,
  ENCOUNTER_PLOTS,
  encounterPicture,
  meetOnLine,
  velocityAfter,
} from '../support/collision-1d.ts';

type Values = ValuesOf<'m1' | 'm2' | 'u1' | 'u2'>;

export default defineExample({
  id: 'ch11-1d-elastic',
  title: 'An elastic encounter on a line',
  chapter: 11,
  tags: ['collision', 'momentum', 'energy'],
  about:
    'Momentum and energy together leave only one way to go on after a head-on collision. Equal masses exchange their velocities; a light one is thrown back by a heavy one, which hardly notices; and a heavy one sends a light one ahead with up to twice its own speed.',
  duration: 4,
  ends: true,
  parameters: ENCOUNTER_PARAMETERS,
  presets: [
    { label: 'Equal masses', values: { m2: 1 } },
    { label: 'Heavy on light', values: { m1: 125, m2: 1 } },
  ],
  build: (values: Values, options) => meetOnLine({ ...values, e: 1 }, options),
  picture: encounterPicture,
  plots: ENCOUNTER_PLOTS,
  checks: ({ at }) => [
    at(
      4,
      'Velocity of the left ball afterwards, ((m₁ − m₂) u₁ + 2 m₂ u₂)/(m₁ + m₂)',
      { exact: ({ m1, m2, u1, u2 }) => velocityAfter(1, [m1, u1], [m2, u2]), unit: 'px/s', absolute: 1e-9 },
      ({ left, v }) => v(left),
    ),
    at(
      4,
      'The same for 1 kg at 250 px/s on 125 kg at 50 px/s',
      { exact: -18_500 / 126, unit: 'px/s', absolute: 5e-5 },
      ({ left, v }) => v(left),
    ),
    at(
      4,
      'Velocity of the right ball afterwards',
      { exact: 6700 / 126, unit: 'px/s', absolute: 5e-5 },
      ({ right, v }) => v(right),
    ),
    at(4, 'Momentum afterwards', { exact: 6500, unit: 'kg px/s', relative: 1e-12 }, ({ world }) => momentum(world).x),
    at(
      4,
      'Energy afterwards',
      { exact: 187_500, unit: 'kg px²/s²', relative: 1e-12 },
      ({ world }) => energy(world).kinetic,
    ),
    at(
      4,
      'Equal masses exchange their velocities: that of the left',
      { exact: 50, unit: 'px/s', relative: 1e-12, preset: 'Equal masses' },
      ({ left, v }) => v(left),
    ),
  ],
  tryThis: ['Choose “Heavy on light”: the light ball leaves with nearly twice the speed of the heavy one.'],
});
