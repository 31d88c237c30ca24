// Heun's second-order method: the mean of the derivatives at the start and, by explicit Euler, at the end of the step.
//
//   k₁ = f(t, y)        k₂ = f(t + dt, y + k₁ dt)        y' = y + (k₁ + k₂) dt/2        y = (x, v),  f = (v, F/m)
//
// Second order for any smooth force, dependent on velocity and time as well. Not symplectic: the energy of an
// oscillator grows by (ω dt)⁴/4 a step. Heun, Z. Math. Phys. 45, 23 (1900); Hairer, Nørsett, Wanner: Solving Ordinary
// Differential Equations I, II.1.
import { momentOf } from '../forces/evaluate';
import type { Integrator } from './integrator';
import { clearSums, finishSums, rungeKuttaStage } from './runge-kutta-stages';

export const heun: Integrator = {
  name: 'Heun',
  order: 2,
  symplectic: false,
  evaluations: 2,
  advance(world, spans, dt, evaluateForces) {
    clearSums(world, spans, dt);
    evaluateForces(world, spans, momentOf(world, 0));
    rungeKuttaStage(world, spans, 1 / 2, dt);
    evaluateForces(world, spans, momentOf(world, dt));
    rungeKuttaStage(world, spans, 1 / 2, 0);
    finishSums(world, spans, dt);
  },
};
