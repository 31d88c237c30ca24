// Semi-implicit (symplectic) Euler: kick with the force at the start, then drift with the new velocity.
//
//   v' = v + F(x, v)/m dt        x' = x + v' dt
//
// First order; symplectic for forces that depend only on position: the energy error of an oscillator stays within ω
// dt/2 of the energy for ever. One force evaluation. Hairer, Lubich, Wanner: Geometric Numerical Integration, I.1.2.
import { defineIntegrator } from './support/define-integrator.ts';

/**
 * Semi-implicit (symplectic) Euler: v' = v + F(x, v, t)/m dt, x' = x + v' dt. First order, one evaluation: the
 * cheapest stable scheme, for contacts and millions of bodies.
 */
export const semiImplicitEuler = /* @__PURE__ */ defineIntegrator(
  {
    name: 'semi-implicit Euler',
    order: 1,
    symplectic: true,
    evaluations: 1,
    // x(n+1) - x(n) = v(n+1) dt: the stored velocity is that of the middle of the step.
    velocityLag: 0.5,
    // The step multiplies (x, v dt) by a matrix of trace 2 - γ dt - ω² dt² and determinant 1 - γ dt; its eigenvalues
    // lie in the unit circle when |trace| <= 1 + determinant and |determinant| <= 1 (Jury).
    isStable: (stiffness, damping) => stiffness + 2 * damping <= 4,
  },
  ({ position, velocity, dt }, kick) => {
    const kicked = velocity.add(kick(position, velocity, 0, dt));
    return { position: position.add(kicked.mul(dt)), velocity: kicked };
  },
);
