// The classical fourth-order Runge-Kutta method (Kutta 1901): four evaluations, weights 1/6, 1/3, 1/3, 1/6.
//
// Fourth order for any smooth force, dependent on velocity and time as well. Not symplectic: the energy of an
// oscillator decays by (ω dt)⁶/72 a step. Choose it for accuracy over few periods. Hairer, Nørsett, Wanner: Solving
// Ordinary Differential Equations I, II.1.
import { momentOf } from '../forces/evaluate';
import type { Integrator } from './integrator';
import { multiplesOf } from './multiples';
import { clearSums, finishSums, rungeKuttaStage } from './runge-kutta-stages';

const halfOf = multiplesOf([1 / 2]);

export const rungeKutta4: Integrator = {
  name: 'Runge-Kutta 4',
  order: 4,
  symplectic: false,
  evaluations: 4,
  isStable: (stiffness, damping) => {
    // |1 + z + z²/2 + z³/6 + z⁴/24| <= 1 at both roots z of z² + γ dt z + ω² dt² = 0.
    const half = damping / 2;
    const square = half * half - stiffness;
    const root = Math.sqrt(Math.abs(square));
    if (square < 0) return growth(-half, root) <= 1 + 1e-9;
    return growth(-half - root, 0) <= 1 + 1e-9 && growth(-half + root, 0) <= 1 + 1e-9;
  },
  advance(world, spans, dt, evaluateForces) {
    const half = halfOf(dt)[0];
    clearSums(world, spans, dt);
    evaluateForces(world, spans, momentOf(world, 0));
    rungeKuttaStage(world, spans, 1 / 6, half);
    evaluateForces(world, spans, momentOf(world, half));
    rungeKuttaStage(world, spans, 1 / 3, half);
    evaluateForces(world, spans, momentOf(world, half));
    rungeKuttaStage(world, spans, 1 / 3, dt);
    evaluateForces(world, spans, momentOf(world, dt));
    rungeKuttaStage(world, spans, 1 / 6, 0);
    finishSums(world, spans, dt);
  },
};

/** Square of the factor by which a step multiplies a mode z = x + i y. */
function growth(x: number, y: number): number {
  let re = 1;
  let im = 0;
  for (let n = 4; n >= 1; n--) {
    const next = 1 + (re * x - im * y) / n;
    im = (re * y + im * x) / n;
    re = next;
  }
  return re * re + im * im;
}
