// Semi-implicit (symplectic) Euler in its other ordering: drift with the old velocity, then kick with the force there.
//
//   x' = x + v dt        v' = v + F(x', v, t')/m dt
//
// First order, symplectic, one evaluation: the adjoint of the velocity-first ordering, which run backwards in time it
// is. The energy error of an oscillator stays within ω dt/2 of the energy for ever.
// Hairer, Lubich, Wanner: Geometric Numerical Integration, I.1.2 and VI.3.1.
import { defineIntegrator } from './support/define-integrator.ts';

export const positionFirstEuler = /* @__PURE__ */ defineIntegrator(
  {
    name: 'position-first Euler',
    order: 1,
    symplectic: true,
    evaluations: 1,
    // x(n+1) - x(n) = v(n) dt: the velocity is ahead, that of the middle of the step to come.
    velocityLag: -0.5,
    // The same trace and determinant as with the other ordering.
    isStable: (stiffness, damping) => stiffness + 2 * damping <= 4,
  },
  ({ position, velocity, dt }, kick) => {
    const drifted = position.add(velocity.mul(dt));
    return { position: drifted, velocity: velocity.add(kick(drifted, velocity, 1, dt)) };
  },
);
