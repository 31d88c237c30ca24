// Semi-implicit (symplectic) Euler, position first: drift with the old velocity, then kick with the force at the new
// position.
//
//   x' = x + v dt        v' = v + F(x', v, t')/m dt
//
// First order, symplectic, one evaluation: the adjoint of the velocity-first variant, which it becomes when run
// backwards in time. The energy error of an oscillator stays within ω dt/2 of the energy for ever. Hairer, Lubich,
// Wanner: Geometric Numerical Integration, I.1.2 and VI.3.1.
import { defineIntegrator } from './support/define-integrator.ts';

/**
 * Semi-implicit Euler, position first: x' = x + v dt, v' = v + F(x', v, t')/m dt. First order, symplectic, one
 * evaluation.
 */
export const positionFirstEuler = /* @__PURE__ */ defineIntegrator(
  {
    name: 'position-first Euler',
    order: 1,
    symplectic: true,
    evaluations: 1,
    // x(n+1) - x(n) = v(n) dt: the stored velocity is that of the middle of the next step.
    velocityLag: -0.5,
    // Trace and determinant equal those of the velocity-first variant.
    isStable: (stiffness, damping) => stiffness + 2 * damping <= 4,
  },
  ({ position, velocity, dt }, kick) => {
    const drifted = position.add(velocity.mul(dt));
    return { position: drifted, velocity: velocity.add(kick(drifted, velocity, 1, dt)) };
  },
);
