// Leapfrog as drift, kick, drift.
//
//   x½ = x + v dt/2        v' = v + F(x½, t½)/m dt        x' = x½ + v' dt/2
//
// Second order, symplectic and reversible for forces that depend only on position, with a single evaluation: the
// cheapest scheme of its order. A force that depends on velocity makes it first order. Hairer, Lubich, Wanner:
// Geometric Numerical Integration, I.1.4.
import { compose, isStableComposition } from './support/composition.ts';
import { defineIntegrator } from './support/define-integrator.ts';

const DRIFTS = [1 / 2, 1 / 2];
const KICKS = [1];

/**
 * Leapfrog as drift, kick, drift: of second order, symplectic and reversible for forces that depend on position alone,
 * for one force evaluation a step. First order where a force depends on velocity.
 */
export const driftKickDrift = /* @__PURE__ */ defineIntegrator(
  {
    name: 'drift-kick-drift',
    order: 2,
    symplectic: true,
    evaluations: 1,
    isStable: (stiffness, damping) => isStableComposition(DRIFTS, KICKS, stiffness, damping),
  },
  compose(DRIFTS, KICKS),
);
