// Leapfrog as kick, drift, kick.
//
//   v½ = v + F(x, t)/m dt/2        x' = x + v½ dt        v' = v½ + F(x', t')/m dt/2
//
// Second order, symplectic and reversible for forces that depend only on position, where it equals velocity Verlet up
// to rounding. A force that depends on velocity makes it first order: use velocity Verlet then. Two evaluations,
// because contacts and users may move bodies between steps. Verlet, Phys. Rev. 159, 98 (1967); Hairer, Lubich,
// Wanner: Geometric Numerical Integration, I.1.4.
import { isStableComposition } from './support/composition.ts';
import { defineIntegrator } from './support/define-integrator.ts';

/**
 * Leapfrog as kick, drift, kick: of second order, symplectic and reversible for forces that depend on position alone,
 * two evaluations a step. First order where a force depends on velocity.
 */
export const leapfrog = /* @__PURE__ */ defineIntegrator(
  {
    name: 'leapfrog',
    order: 2,
    symplectic: true,
    evaluations: 2,
    isStable: (stiffness, damping) => isStableComposition([0, 1], [1 / 2, 1 / 2], stiffness, damping),
  },
  ({ position, velocity, dt }, kick) => {
    const half = dt.mul(0.5);
    const kicked = velocity.add(kick(position, velocity, 0, half));
    const drifted = position.add(kicked.mul(dt));
    return { position: drifted, velocity: kicked.add(kick(drifted, kicked, 1, half)) };
  },
);
