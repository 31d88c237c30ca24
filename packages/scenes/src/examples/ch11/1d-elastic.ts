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
  checks: [
    {
      label: 'Velocity of the left ball afterwards, ((m₁ − m₂) u₁ + 2 m₂ u₂)/(m₁ + m₂)',
      unit: 'px/s',
      exact: ({ m1, m2, u1, u2 }) => velocityAfter(1, [m1, u1], [m2, u2]),
      tolerance: { absolute: 1e-9 },
      at: { time: 4 },
      measure: ({ left, v }) => v(left),
    },
    {
      label: 'The same for 1 kg at 250 px/s on 125 kg at 50 px/s',
      unit: 'px/s',
      exact: -146.8254,
      tolerance: { absolute: 5e-5 },
      at: { time: 4 },
      measure: ({ left, v }) => v(left),
    },
    {
      label: 'Velocity of the right ball afterwards',
      unit: 'px/s',
      exact: 53.1746,
      tolerance: { absolute: 5e-5 },
      at: { time: 4 },
      measure: ({ right, v }) => v(right),
    },
    {
      label: 'Momentum afterwards',
      unit: 'kg px/s',
      exact: 6500,
      tolerance: { relative: 1e-12 },
      at: { time: 4 },
      measure: ({ world }) => momentum(world).x,
    },
    {
      label: 'Energy afterwards',
      unit: 'J',
      exact: 187_500,
      tolerance: { relative: 1e-12 },
      at: { time: 4 },
      measure: ({ world }) => energy(world).kinetic,
    },
    {
      label: 'Equal masses exchange their velocities: that of the left',
      unit: 'px/s',
      exact: 50,
      tolerance: { relative: 1e-12 },
      at: { time: 4 },
      measure: ({ left, v }) => v(left),
      preset: 'Equal masses',
    },
  ],
  tryThis: ['Choose “Heavy on light”: the light ball leaves with nearly twice the speed of the heavy one.'],
});
