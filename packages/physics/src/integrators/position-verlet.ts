// Position Verlet, or Störmer's method: each position follows from the two previous ones.
//
//   x' = x + (x - x(previous)) + a dt²        start: x(previous) = x - v dt + a dt²/2
//   v' = (x' - x)/dt + a dt/2
//
// Without the last term of the start the whole run would be off by g dt t/2: first order. With it the scheme is
// second order; one evaluation. A step of different length scales the displacement: x' = x + (x - x(previous))
// dt/dt(previous) + a dt (dt + dt(previous))/2. A body whose position or velocity was changed since its last step
// starts anew, as does one that was and is at rest without a force: that is what a new body looks like, and one whose
// force begins then gets a dt²/2 as it should. The velocity is a second-order estimate, for forces and users; forces
// that depend on it keep the order. Symplectic for forces that depend only on position and equal steps: the energy error
// is bounded. Størmer, Arch. Sci. Phys. Nat. 24 (1907); Verlet, Phys. Rev. 159, 98 (1967); Hairer, Lubich, Wanner:
// Geometric Numerical Integration, I.1.4.
import { type Scalar, select, type Vector, vec3 } from '../laws/expression.ts';
import { defineIntegrator } from './support/define-integrator.ts';

const AXES = ['x', 'y', 'z'] as const;

/**
 * Störmer's method: each position follows from the two before it. Second order and symplectic with equal steps, one
 * evaluation; a body that is moved or kicked between steps starts anew.
 */
export const positionVerlet = /* @__PURE__ */ defineIntegrator(
  {
    name: 'position Verlet',
    order: 2,
    symplectic: true,
    evaluations: 1,
    columns: 9,
  },
  ({ position, velocity, dt, lastDt, memory }, kick) => {
    const [displacement, lastPosition, lastVelocity] = memory;
    const kicked = kick(position, velocity, 0, dt);
    const hasLast = lastDt.greater(0);
    const ratio = select(hasLast, dt.div(lastDt), 0);
    const kickTime = select(hasLast, dt.add(lastDt).mul(0.5), dt);
    const continued = displacement.mul(ratio).add(kicked.mul(kickTime));
    const started = velocity.mul(dt).add(kicked.mul(dt.mul(0.5)));
    const step = eachAxis((axis) => {
      const isUnchanged = position[axis].equals(lastPosition[axis]).and(velocity[axis].equals(lastVelocity[axis]));
      // The row of a new body has zeros.
      const isAtRest = displacement[axis].equals(0).and(velocity[axis].equals(0));
      return select(isUnchanged.and(isAtRest.not()).and(hasLast), continued[axis], started[axis]);
    });
    const after = position.add(step);
    // The mean velocity of the step plus half a step of acceleration.
    const estimate = step.div(dt).add(kicked.mul(0.5));
    return { position: after, velocity: estimate, memory: [step, after, estimate] };
  },
  // Per body: the last displacement, and position and velocity at the end of its last step.
  { memory: 3 },
);

function eachAxis(make: (axis: 'x' | 'y' | 'z') => Scalar): Vector {
  const [x, y, z] = AXES.map(make);
  return vec3(x, y, z);
}
