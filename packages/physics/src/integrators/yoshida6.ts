// Yoshida's sixth-order composition: seven drift-kick-drift steps, solution A.
//
//   lengths w3, w2, w1, w0, w1, w2, w3 of dt, with w0 = 1 - 2 (w1 + w2 + w3)
//
// Sixth order, symplectic and reversible for forces that depend only on position; seven evaluations. For orbits over
// very many periods with a small, bounded error. A force that depends on velocity makes it first order. Yoshida,
// Phys. Lett. A 150, 262 (1990), table 1; digits: Hairer, Lubich, Wanner: Geometric Numerical Integration, V.3.
import { compose, composeLengths, isStableComposition } from './support/composition.ts';
import { defineIntegrator } from './support/define-integrator.ts';

const W1 = -1.177679984178871;
const W2 = 0.23557321335935813;
const W3 = 0.7845136104775573;
const W0 = 1 - 2 * (W1 + W2 + W3);
const { drifts, kicks } = composeLengths([W3, W2, W1, W0, W1, W2, W3]);

/**
 * Yoshida's composition of sixth order: symplectic and reversible for forces that depend on position alone, seven
 * evaluations a step. For orbits over very many periods with a small error; first order where a force depends on
 * velocity.
 */
export const yoshida6 = /* @__PURE__ */ defineIntegrator(
  {
    name: 'Yoshida 6',
    order: 6,
    symplectic: true,
    evaluations: 7,
    isStable: (stiffness, damping) => isStableComposition(drifts, kicks, stiffness, damping),
  },
  compose(drifts, kicks),
);
