// Velocity Verlet (Swope, Andersen, Berens, Wilson, J. Chem. Phys. 76, 637, 1982):
//
//   x' = x + v dt + a dt²/2        v' = v + (a + a') dt/2
//
// with a' the acceleration at x'. A force that depends on velocity is evaluated there with the predictor v + a dt,
// which keeps the scheme second order. For forces that depend only on position it is symplectic and exactly
// reversible; a constant force is exact. Two force evaluations: none is reused, because contacts and users may have
// moved bodies.
import { defineIntegrator } from './support/define-integrator.ts';

/**
 * The default integrator: of second order, symplectic and reversible for forces that depend on position alone, exact for a constant
 * force. It evaluates the forces twice a step, and suits most worlds; docs/integrators.md compares all.
 */
export const velocityVerlet = /* @__PURE__ */ defineIntegrator(
  {
    name: 'velocity Verlet',
    order: 2,
    symplectic: true,
    evaluations: 2,
    isStable: (w, g) => {
      // Trace and determinant of the step matrix of (x, v dt), with w = ω² dt² and g = γ dt.
      const trace = 2 - w - g + (g * g) / 2 + (w * g) / 4;
      const determinant =
        (1 - w / 2) * (1 - w / 2 - g + (g * g) / 2 + (w * g) / 4) + (1 - g / 2) * w * (1 - w / 4 - g / 2);
      return Math.abs(determinant) <= 1 + 1e-9 && Math.abs(trace) <= 1 + determinant + 1e-9;
    },
  },
  ({ position, velocity, dt }, kick) => {
    const half = dt.mul(0.5);
    const first = kick(position, velocity, 0, half);
    const kicked = velocity.add(first);
    const drifted = position.add(kicked.mul(dt));
    // The force at the end is evaluated with the velocity predicted from the acceleration at the start.
    return { position: drifted, velocity: kicked.add(kick(drifted, kicked.add(first), 1, half)) };
  },
);
