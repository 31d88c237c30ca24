// Yoshida's fourth-order composition: three drift-kick-drift steps, forwards, backwards, forwards.
//
//   lengths w, 1 - 2w, w of dt, with w = 1/(2 - 2^(1/3)) = 1.3512…
//
// Fourth order, symplectic and reversible for forces that depend only on position; three evaluations. The middle step
// goes back by 1.70 dt, so the error constant is large: compare it with leapfrog at half of dt. A force that depends
// on velocity makes it first order. Forest and Ruth, Physica D 43, 105 (1990); Yoshida, Phys. Lett. A 150, 262
// (1990).
import { compose, composeLengths, isStableComposition } from './support/composition.ts';
import { defineIntegrator } from './support/define-integrator.ts';

const CUBE_ROOT_OF_2 = 1.2599210498948732;
const W = 1 / (2 - CUBE_ROOT_OF_2);
const { drifts, kicks } = composeLengths([W, 1 - 2 * W, W]);

/**
 * Yoshida's composition of fourth order: symplectic and reversible for forces that depend on position alone, three
 * evaluations a step. For orbits over very many periods; first order where a force depends on velocity.
 */
export const yoshida4 = /* @__PURE__ */ defineIntegrator(
  {
    name: 'Yoshida 4',
    order: 4,
    symplectic: true,
    evaluations: 3,
    isStable: (stiffness, damping) => isStableComposition(drifts, kicks, stiffness, damping),
  },
  compose(drifts, kicks),
);
