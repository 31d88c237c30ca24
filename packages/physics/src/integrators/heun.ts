// Heun's second-order method: the mean of the derivatives at the start and, predicted by explicit Euler, at the end
// of the step.
//
//   k₁ = f(t, y)        k₂ = f(t + dt, y + k₁ dt)        y' = y + (k₁ + k₂) dt/2        y = (x, v),  f = (v, F/m)
//
// Second order for any smooth force, including forces that depend on velocity and time. Not symplectic: the energy of
// an oscillator grows by (ω dt)⁴/4 per step. Heun, Z. Math. Phys. 45, 23 (1900); Hairer, Nørsett, Wanner: Solving
// Ordinary Differential Equations I, II.1.
import { defineIntegrator } from './support/define-integrator.ts';

/**
 * Heun's method: the mean of the derivatives at the start and at the predicted end of the step. Second order for any
 * smooth force, two evaluations, not symplectic.
 */
export const heun = /* @__PURE__ */ defineIntegrator(
  {
    name: 'Heun',
    order: 2,
    symplectic: false,
    evaluations: 2,
  },
  ({ position, velocity, dt }, kick) => {
    const first = kick(position, velocity, 0, dt);
    const predicted = velocity.add(first);
    const second = kick(position.add(velocity.mul(dt)), predicted, 1, dt);
    return {
      position: position.add(velocity.add(predicted).mul(dt.mul(0.5))),
      velocity: velocity.add(first.add(second).mul(0.5)),
    };
  },
);
