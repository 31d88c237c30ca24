// The classical fourth-order Runge-Kutta method (Kutta 1901): four evaluations, weights 1/6, 1/3, 1/3, 1/6.
//
// Fourth order for any smooth force, dependent on velocity and time as well. Not symplectic: the energy of an
// oscillator decays by (ω dt)⁶/72 a step. Choose it for accuracy over few periods. Hairer, Nørsett, Wanner: Solving
// Ordinary Differential Equations I, II.1.
import { AXES } from '../store/axes';
import type { Spans } from '../store/spans';
import type { PhysicsWorld } from '../world';
import type { Integrator } from './integrator';

export const rungeKutta4: Integrator = {
  name: 'Runge-Kutta 4',
  order: 4,
  symplectic: false,
  evaluations: 4,
  isStable: (stiffness, damping) => {
    // |1 + z + z²/2 + z³/6 + z⁴/24| <= 1 at both roots z of z² + γ dt z + ω² dt² = 0.
    const half = damping / 2;
    const square = half * half - stiffness;
    const root = Math.sqrt(Math.abs(square));
    if (square < 0) return growth(-half, root) <= 1 + 1e-9;
    return growth(-half - root, 0) <= 1 + 1e-9 && growth(-half + root, 0) <= 1 + 1e-9;
  },
  advance(world, spans, dt, evaluateForces) {
    const { time } = world;
    clearSums(world, spans);
    evaluateForces(world, spans, time);
    stage(world, spans, 1 / 6, dt / 2);
    evaluateForces(world, spans, time + dt / 2);
    stage(world, spans, 1 / 3, dt / 2);
    evaluateForces(world, spans, time + dt / 2);
    stage(world, spans, 1 / 3, dt);
    evaluateForces(world, spans, time + dt);
    stage(world, spans, 1 / 6, 0);
    finish(world, spans, dt);
  },
};

/** Square of the factor by which a step multiplies a mode z = x + i y. */
function growth(x: number, y: number): number {
  let re = 1;
  let im = 0;
  for (let n = 4; n >= 1; n--) {
    const next = 1 + (re * x - im * y) / n;
    im = (re * y + im * x) / n;
    re = next;
  }
  return re * re + im * im;
}

function clearSums(world: PhysicsWorld, spans: Spans): void {
  const { kernels, scratch } = world;
  const { stage1, stage2 } = scratch.at;
  for (const axis of AXES[world.dimensions]) {
    for (let r = 0; r < spans.count; r++) {
      const first = spans.bounds[2 * r] as number;
      const last = spans.bounds[2 * r + 1] as number;
      kernels.zeroColumn(stage1[axis], first, last);
      kernels.zeroColumn(stage2[axis], first, last);
    }
  }
}

function stage(world: PhysicsWorld, spans: Spans, weight: number, next: number): void {
  const { kernels, addresses, scratch } = world;
  const { Position, Velocity, Mass } = addresses;
  const { startVelocity, stage1, stage2, force } = scratch.at;
  for (const axis of AXES[world.dimensions]) {
    const x = Position[axis];
    const v = Velocity[axis];
    const x0 = world.previousAddresses.Position[axis];
    const v0 = startVelocity[axis];
    for (let r = 0; r < spans.count; r++) {
      const first = spans.bounds[2 * r] as number;
      const last = spans.bounds[2 * r + 1] as number;
      const f = force[axis];
      kernels.rungeKuttaStageAxis(x, v, x0, v0, stage1[axis], stage2[axis], f, Mass.value, weight, next, first, last);
    }
  }
}

function finish(world: PhysicsWorld, spans: Spans, dt: number): void {
  const { kernels, addresses, scratch } = world;
  const { Position, Velocity } = addresses;
  const { startVelocity, stage1, stage2 } = scratch.at;
  for (const axis of AXES[world.dimensions]) {
    const x = Position[axis];
    const v = Velocity[axis];
    const x0 = world.previousAddresses.Position[axis];
    const v0 = startVelocity[axis];
    for (let r = 0; r < spans.count; r++) {
      const first = spans.bounds[2 * r] as number;
      const last = spans.bounds[2 * r + 1] as number;
      kernels.rungeKuttaFinishAxis(x, v, x0, v0, stage1[axis], stage2[axis], dt, first, last);
    }
  }
}
