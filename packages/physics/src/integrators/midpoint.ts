// The explicit midpoint rule: the derivative in the middle of the step, predicted by half a step of explicit Euler.
//
//   k₁ = f(t, y)        y' = y + dt f(t + dt/2, y + k₁ dt/2)        y = (x, v),  f = (v, F/m)
//
// Second order for any smooth force, including forces that depend on velocity and time. Not symplectic: the energy of
// an oscillator grows by (ω dt)⁴/4 per step. Runge, Math. Ann. 46, 167 (1895); Hairer, Nørsett, Wanner: Solving
// Ordinary Differential Equations I, II.1.
import { defineIntegrator } from './support/define-integrator.ts';

/**
 * The explicit midpoint rule: the derivative in the predicted middle of the step. Second order for any smooth force,
 * two evaluations, not symplectic.
 */
export const midpoint = /* @__PURE__ */ defineIntegrator(
  {
    name: 'midpoint',
    order: 2,
    symplectic: false,
    evaluations: 2,
  },
  ({ position, velocity, dt }, kick) => {
    const half = dt.mul(0.5);
    const middle = velocity.add(kick(position, velocity, 0, half));
    return {
      position: position.add(middle.mul(dt)),
      velocity: velocity.add(kick(position.add(velocity.mul(half)), middle, 1 / 2, dt)),
    };
  },
);
