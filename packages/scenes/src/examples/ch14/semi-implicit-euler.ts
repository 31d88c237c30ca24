import { cos, positionFirstEuler, semiImplicitEuler } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { AMPLITUDE, type OscillatorRun, oscillator, phasePicture, rateParameter } from '../support/oscillator.ts';
import { positionOf } from '../support/read.ts';

/** Of first order: half the step, half the error. */
const ERRORS = [
  { rate: 60, exact: 1.4, tolerance: { absolute: 5e-3 }, preset: {} },
  { rate: 120, exact: 0.702, tolerance: { absolute: 5e-4 }, preset: { preset: 'Half the step' } },
  { rate: 240, exact: 0.351, tolerance: { absolute: 5e-4 }, preset: { preset: 'A quarter of the step' } },
];

export default defineExample({
  id: 'ch14-semi-implicit-euler',
  title: 'Semi-implicit Euler is faithful',
  chapter: 14,
  tags: ['integrators', 'oscillation', 'energy'],
  about:
    'Change the velocity first, and move with the new one: that small exchange saves everything. The path is no circle, but an ellipse that leans a little, and it closes. The energy swings by ω dt/2 to both sides and always comes back. Schemes of this kind are called symplectic; most games use this one.',
  duration: 100,
  parameters: { rate: rateParameter },
  presets: [
    { label: 'Four steps a second', values: { rate: 4 } },
    { label: 'Half the step', values: { rate: 120 } },
    { label: 'A quarter of the step', values: { rate: 240 } },
  ],
  build: ({ rate }: ValuesOf<'rate'>, { integrator = semiImplicitEuler }: BuildOptions) => oscillator(rate, integrator),
  picture: (run) => phasePicture(run, 240),
  plots: (plot) => [
    plot('Error of the energy', 'error, %', { label: 'energy', value: ({ energyError }) => 100 * energyError() }),
  ],
  checks: ({ largest }) => [
    ...[semiImplicitEuler, positionFirstEuler].map((integrator, i) =>
      largest(
        100,
        ['Largest error of the energy, ω dt/2', 'The same, places first'][i],
        { exact: 1 / 120, relative: 0.02, integrator },
        ({ energyError }: { energyError(): number }) => Math.abs(energyError()),
      ),
    ),
    ...ERRORS.map(({ preset, rate, exact, tolerance }) => ({
      label: `Error of the place after 1 s with ${rate} steps`,
      unit: 'px',
      exact,
      tolerance,
      at: { time: 1 },
      measure: ({ world, ball }: OscillatorRun) => Math.abs(positionOf(world, ball).x + AMPLITUDE * cos(1)),
      ...preset,
    })),
    largest(
      100,
      'Largest amplitude with four steps a second, in 100 s: bounded for ever, 200/√(1 − ω dt/2)',
      { exact: 200 / Math.sqrt(1 - 1 / 8), unit: 'px', relative: 1e-3, preset: 'Four steps a second' },
      ({ amplitude }) => amplitude(),
    ),
  ],
  tryThis: [
    'Take four steps a second: the ellipse leans far over, but still it closes.',
    'Compare with explicit Euler, which moves with the old velocity instead of the new one: it spirals away.',
  ],
});
