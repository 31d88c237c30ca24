// The classical fourth-order Runge-Kutta method (Kutta 1901): four evaluations, weights 1/6, 1/3, 1/3, 1/6.
//
// Fourth order for any smooth force, including forces that depend on velocity and time. Not symplectic: the energy of
// an oscillator decays by (ω dt)⁶/72 per step. Choose it for accuracy over few periods. Hairer, Nørsett, Wanner:
// Solving Ordinary Differential Equations I, II.1.
import { defineIntegrator } from './support/define-integrator.ts';

/**
 * The classical Runge-Kutta method of fourth order, with any smooth force and four evaluations a step. Not symplectic:
 * for accuracy over few periods.
 */
export const rungeKutta4 = /* @__PURE__ */ defineIntegrator(
  {
    name: 'Runge-Kutta 4',
    order: 4,
    symplectic: false,
    evaluations: 4,
    // Intermediate values of the stages, if some force is not a law.
    columns: 18,
    isStable: (stiffness, damping) => {
      // |1 + z + z²/2 + z³/6 + z⁴/24| <= 1 at both roots z of z² + γ dt z + ω² dt² = 0.
      const half = damping / 2;
      const square = half * half - stiffness;
      const root = Math.sqrt(Math.abs(square));
      if (square < 0) return amplification(-half, root) <= 1 + 1e-9;
      return amplification(-half - root, 0) <= 1 + 1e-9 && amplification(-half + root, 0) <= 1 + 1e-9;
    },
  },
  ({ position, velocity, dt }, kick) => {
    const half = dt.mul(0.5);
    const k1 = kick(position, velocity, 0, half);
    const v2 = velocity.add(k1);
    const k2 = kick(position.add(velocity.mul(half)), v2, 1 / 2, half);
    const v3 = velocity.add(k2);
    const k3 = kick(position.add(v2.mul(half)), v3, 1 / 2, half);
    const v4 = velocity.add(k3.mul(2));
    const k4 = kick(position.add(v3.mul(dt)), v4, 1, half);
    // These are kicks of half a step: two of them equal one of the textbook. The mean of the four velocities is written
    // out, v + (k1 + k2 + k3) / 3, so that both results share sums.
    const inner = k2.add(k3);
    const firstThree = k1.add(inner);
    return {
      position: position.add(velocity.add(firstThree.mul(1 / 3)).mul(dt)),
      velocity: velocity.add(
        firstThree
          .add(inner)
          .add(k4)
          .mul(1 / 3),
      ),
    };
  },
);

/** Returns the squared amplification factor of a mode z = x + i y per step. */
function amplification(x: number, y: number): number {
  let re = 1;
  let im = 0;
  for (let n = 4; n >= 1; n--) {
    const next = 1 + (re * x - im * y) / n;
    im = (re * y + im * x) / n;
    re = next;
  }
  return re * re + im * im;
}
