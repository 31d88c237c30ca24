import { cos, positionFirstEuler, semiImplicitEuler } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { AMPLITUDE, oscillator, phasePicture, rateParameter } from '../support/oscillator.ts';
import { positionOf } from '../support/read.ts';

export default defineExample({
  id: 'ch14-semi-implicit-euler',
  title: 'Semi-implicit Euler is faithful',
  chapter: 14,
  tags: ['integrators', 'oscillation', 'energy'],
  about:
    'Change the velocity first, and move with the new one: that small exchange saves everything. The path is no circle, but an ellipse that leans a little, and it closes. The energy swings by ω dt/2 to both sides and always comes back. Schemes of this kind are called symplectic; most games use this one.',
  duration: 100,
  parameters: { rate: rateParameter },
  presets: [{ label: 'Four steps a second', values: { rate: 4 } }],
  build: ({ rate }: ValuesOf<'rate'>, { integrator = semiImplicitEuler }: BuildOptions) => oscillator(rate, integrator),
  picture: (run) => phasePicture(run, 240),
  plots: [
    {
      title: 'Error of the energy',
      y: { label: 'error, %' },
      series: [{ label: 'energy', value: ({ energyError }) => 100 * energyError() }],
    },
  ],
  checks: [
    ...[semiImplicitEuler, positionFirstEuler].map((integrator, i) => ({
      label: ['Largest error of the energy, ω dt/2', 'The same, places first'][i],
      unit: '',
      exact: 1 / 120,
      tolerance: { relative: 0.02 },
      at: { until: 100, take: 'largest' as const },
      measure: ({ energyError }: { energyError(): number }) => Math.abs(energyError()),
      integrator,
    })),
    {
      label: 'Error of the place after 1 s with 60 steps',
      unit: 'px',
      exact: 1.4,
      tolerance: { absolute: 5e-3 },
      at: { time: 1 },
      measure: ({ world, ball }) => Math.abs(positionOf(world, ball).x + AMPLITUDE * cos(1)),
    },
  ],
  tryThis: [
    'Take four steps a second: the ellipse leans far over, but still it closes.',
    'Compare with explicit Euler, which moves with the old velocity instead of the new one: it spirals away.',
  ],
});
