import { implicitEuler } from '@principia/physics';
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
  id: 'ch14-implicit-euler',
  title: 'Implicit Euler loses',
  chapter: 14,
  tags: ['integrators', 'oscillation', 'stability'],
  about:
    'This scheme takes the force at the end of the step, which it must first find out by solving equations. It errs to the other side: the amplitude shrinks by √(1 + ω² dt²) in each step, as if there were friction. But it is patient: even steps of ten seconds, longer than a whole swing, do not make it explode.',
  duration: 100,
  parameters: { rate: { ...rateParameter, min: 0.1 } },
  presets: [
    { label: 'Steps of a second', values: { rate: 1 } },
    { label: 'Steps of ten seconds', values: { rate: 0.1 } },
  ],
  build({ rate }, { integrator = implicitEuler() }) {
    const run = oscillator(rate, integrator);
    // Steps of ten seconds are meant to be as long.
    run.world.onWarning = () => {};
    return run;
  },
  picture: (run) => phasePicture(run, 220),
  plots: [amplitudePlot],
  checks: ({ at }) => [
    at(
      100,
      'Amplitude after 100 s, 200/(1 + ω² dt²)³⁰⁰⁰',
      { exact: AMPLITUDE / integerPower(1 + 1 / 3600, 3000), unit: 'px', absolute: 1e-3 },
      ({ amplitude }) => amplitude(),
    ),
    at(
      20,
      'Amplitude after twenty steps of a second, 200/2¹⁰',
      { exact: AMPLITUDE / 1024, unit: 'px', absolute: 1e-6, preset: 'Steps of a second' },
      ({ amplitude }) => amplitude(),
    ),
    at(
      50,
      'Amplitude after five steps of ten seconds, 200/101^2.5: stable',
      { exact: AMPLITUDE / (101 * 101 * Math.sqrt(101)), unit: 'px', absolute: 1e-6, preset: 'Steps of ten seconds' },
      ({ amplitude }) => amplitude(),
    ),
  ],
  tryThis: [
    'Take ten steps a second: the swing dies away within a minute, although nothing brakes it.',
    'Choose explicit Euler, the opposite of this scheme: with the same steps the amplitude grows.',
  ],
});
