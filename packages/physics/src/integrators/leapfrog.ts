// Leapfrog as kick, drift, kick.
//
//   v½ = v + F(x, t)/m dt/2        x' = x + v½ dt        v' = v½ + F(x', t')/m dt/2
//
// Second order, symplectic and reversible for forces of position alone, when it is velocity Verlet to the last rounding.
// A force that depends on velocity makes it first order: take velocity Verlet then. Two evaluations, because contacts
// and users may move bodies between steps. Verlet, Phys. Rev. 159, 98 (1967); Hairer, Lubich, Wanner: Geometric
// Numerical Integration, I.1.4.
import { momentOf } from '../forces/evaluate';
import { isStableComposition } from './composition';
import type { Integrator } from './integrator';
import { drift, kick } from './moves';

export const leapfrog: Integrator = {
  name: 'leapfrog',
  order: 2,
  symplectic: true,
  evaluations: 2,
  isStable: (stiffness, damping) => isStableComposition([0, 1], [1 / 2, 1 / 2], stiffness, damping),
  advance(world, spans, dt, evaluateForces) {
    evaluateForces(world, spans, momentOf(world, 0));
    kick(world, spans, dt / 2);
    drift(world, spans, dt);
    evaluateForces(world, spans, momentOf(world, dt));
    kick(world, spans, dt / 2);
  },
};
