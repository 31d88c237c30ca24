// The explicit midpoint rule: the derivative in the middle of the step, reached by half a step of explicit Euler.
//
//   k₁ = f(t, y)        y' = y + dt f(t + dt/2, y + k₁ dt/2)        y = (x, v),  f = (v, F/m)
//
// Second order for any smooth force, dependent on velocity and time as well. Not symplectic: the energy of an
// oscillator grows by (ω dt)⁴/4 a step. Runge, Math. Ann. 46, 167 (1895); Hairer, Nørsett, Wanner: Solving Ordinary
// Differential Equations I, II.1.
import { momentOf } from '../forces/evaluate';
import type { Integrator } from './integrator';
import { multiplesOf } from './multiples';
import { clearSums, finishSums, rungeKuttaStage } from './runge-kutta-stages';

const halfOf = multiplesOf([1 / 2]);

export const midpoint: Integrator = {
  name: 'midpoint',
  order: 2,
  symplectic: false,
  evaluations: 2,
  advance(world, spans, dt, evaluateForces) {
    const half = halfOf(dt)[0];
    clearSums(world, spans, dt);
    evaluateForces(world, spans, momentOf(world, 0));
    rungeKuttaStage(world, spans, 0, half);
    evaluateForces(world, spans, momentOf(world, half));
    rungeKuttaStage(world, spans, 1, 0);
    finishSums(world, spans, dt);
  },
};
