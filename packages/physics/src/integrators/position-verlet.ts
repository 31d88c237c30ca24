// Position Verlet, or Störmer's method: each position follows from the two before it.
//
//   x' = x + (x - x(before)) + a dt²        start: x(before) = x - v dt + a dt²/2
//   v' = (x' - x)/dt + a dt/2
//
// Without the last term of the start the whole run would be off by g dt t/2: first order. With it the scheme is second
// order; one evaluation. A step that differs from the last scales the displacement:
// x' = x + (x - x(before)) dt/dt(before) + a dt (dt + dt(before))/2. A body that was moved or pushed since its last step
// starts afresh. The velocity is an estimate of second order, for forces and for users to read; forces that depend on it
// keep the order. Symplectic for forces of position alone and equal steps: the energy error is bounded.
// Størmer, Arch. Sci. Phys. Nat. 24 (1907); Verlet, Phys. Rev. 159, 98 (1967); Hairer, Lubich, Wanner: Geometric
// Numerical Integration, I.1.4.
import { type Scalar, select, type Vector, vec3 } from '../laws/expression.ts';
import { defineIntegrator } from './support/define-integrator.ts';

const AXES = ['x', 'y', 'z'] as const;

export const positionVerlet = /* @__PURE__ */ defineIntegrator(
  {
    name: 'position Verlet',
    order: 2,
    symplectic: true,
    evaluations: 1,
    columns: 9,
  },
  ({ position, velocity, dt, lastDt, memory }, kick) => {
    const [displacement, leftPosition, leftVelocity] = memory;
    const kicked = kick(position, velocity, 0, dt);
    const hasLast = lastDt.greater(0);
    const ratio = select(hasLast, dt.div(lastDt), 0);
    const bend = select(hasLast, dt.add(lastDt).mul(0.5), dt);
    const goesOn = displacement.mul(ratio).add(kicked.mul(bend));
    const starts = velocity.mul(dt).add(kicked.mul(dt.mul(0.5)));
    const step = eachAxis((axis) => {
      const isLeft = position[axis].equals(leftPosition[axis]).and(velocity[axis].equals(leftVelocity[axis]));
      return select(isLeft.and(hasLast), goesOn[axis], starts[axis]);
    });
    const after = position.add(step);
    // The mean velocity of the step, and half a step's acceleration more.
    const estimate = step.div(dt).add(kicked.mul(0.5));
    return { position: after, velocity: estimate, memory: [step, after, estimate] };
  },
  // What a body remembers: the last displacement, and where and how fast its last step left it.
  { memory: 3 },
);

function eachAxis(make: (axis: 'x' | 'y' | 'z') => Scalar): Vector {
  const [x, y, z] = AXES.map(make);
  return vec3(x, y, z);
}
