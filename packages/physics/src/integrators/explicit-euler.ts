// Explicit (forward) Euler: both updates use the state at the start.
//
//   x' = x + v dt        v' = v + F(x, v, t)/m dt
//
// First order. Not symplectic: every step multiplies the amplitude of an oscillator by √(1 + ω² dt²), so its energy
// grows without bound. For comparison, and for pure decay. Euler, Institutionum calculi integralis I (1768), §650;
// Hairer, Nørsett, Wanner: Solving Ordinary Differential Equations I, I.7.
import { defineIntegrator } from './support/define-integrator.ts';

/**
 * Explicit Euler: x' = x + v dt, v' = v + F(x, v, t)/m dt. First order, and the energy of oscillators and orbits grows
 * without bound: for comparison.
 */
export const explicitEuler = /* @__PURE__ */ defineIntegrator(
  {
    name: 'explicit Euler',
    order: 1,
    symplectic: false,
    evaluations: 1,
    // x(n+1) - x(n) = v(n) dt: the stored velocity is that of the middle of the next step.
    velocityLag: -0.5,
  },
  ({ position, velocity, dt }, kick) => ({
    position: position.add(velocity.mul(dt)),
    velocity: velocity.add(kick(position, velocity, 0, dt)),
  }),
);
