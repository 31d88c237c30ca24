import { explicitEuler } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import {
  AMPLITUDE,
  amplitudePlot,
  integerPower,
  oscillator,
  phasePicture,
  rateParameter,
} from '../support/oscillator.ts';

export default defineExample({
  id: 'ch14-explicit-euler',
  title: 'Explicit Euler gains',
  chapter: 14,
  tags: ['integrators', 'oscillation', 'accuracy'],
  about:
    'The simplest scheme takes the velocity at the beginning of a step for the whole of it, and so always moves along the tangent: out of the circle, never back. The amplitude grows by the factor √(1 + ω² dt²) in each step. After 100 s the swing has more than twice its size, from nothing.',
  duration: 100,
  parameters: { rate: { ...rateParameter, min: 5 } },
  presets: [{ label: 'Short steps', values: { rate: 240 } }],
  build: ({ rate }, { integrator = explicitEuler }) => oscillator(rate, integrator),
  picture: (run) => phasePicture(run, 500),
  plots: [amplitudePlot],
  checks: ({ at }) => [
    at(
      100,
      'Amplitude after 100 s, 200 (1 + ω² dt²)³⁰⁰⁰',
      { exact: AMPLITUDE * integerPower(1 + 1 / 3600, 3000), unit: 'px', absolute: 1e-8 },
      ({ amplitude }) => amplitude(),
    ),
    at(
      100,
      'The same with four times as many steps',
      { exact: AMPLITUDE * integerPower(1 + 1 / 57600, 12000), unit: 'px', absolute: 1e-8, preset: 'Short steps' },
      ({ amplitude }) => amplitude(),
    ),
  ],
  tryThis: [
    'Take longer steps, ten a second: after half a minute the dot has left the picture.',
    'Choose another integrator: most keep to the circle, or even close to it.',
  ],
});
