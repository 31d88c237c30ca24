// Velocity Verlet (Swope, Andersen, Berens, Wilson, J. Chem. Phys. 76, 637, 1982):
//
//   x' = x + v dt + a dt²/2        v' = v + (a + a') dt/2
//
// with a' the acceleration at x'. A force that depends on velocity sees the predictor v + a dt there, which keeps the
// scheme second order. For forces of position alone it is symplectic and exactly reversible; constant force is exact.
// Two force evaluations: nothing is carried over from the last step, because contacts and users may have moved bodies.
import { momentOf } from '../forces/evaluate';
import { AXES } from '../store/axes';
import { eachRun } from '../store/spans';
import type { Integrator } from './integrator';

export const velocityVerlet: Integrator = {
  name: 'velocity Verlet',
  order: 2,
  symplectic: true,
  evaluations: 2,
  isStable: (w, g) => {
    // Trace and determinant of the matrix by which a step multiplies (x, v dt), with w = ω² dt² and g = γ dt.
    const trace = 2 - w - g + (g * g) / 2 + (w * g) / 4;
    const determinant =
      (1 - w / 2) * (1 - w / 2 - g + (g * g) / 2 + (w * g) / 4) + (1 - g / 2) * w * (1 - w / 4 - g / 2);
    return Math.abs(determinant) <= 1 + 1e-9 && Math.abs(trace) <= 1 + determinant + 1e-9;
  },
  advance(world, spans, dt, evaluateForces) {
    evaluateForces(world, spans, momentOf(world, 0));
    predict(world, spans, dt);
    evaluateForces(world, spans, momentOf(world, dt));
    correct(world, spans, dt);
  },
};

const predict = eachRun((world, first, last, dt) => {
  const { kernels, addresses, scratch } = world;
  const { Position, Velocity, Mass } = addresses;
  const { stage1, force } = scratch.at;
  const axes = AXES[world.dimensions];
  for (let a = 0; a < axes.length; a++) {
    const axis = axes[a];
    kernels.verletPredictAxis(Position[axis], Velocity[axis], stage1[axis], force[axis], Mass.value, dt, first, last);
  }
});

const correct = eachRun((world, first, last, dt) => {
  const { kernels, addresses, scratch } = world;
  const { Velocity, Mass } = addresses;
  const { startVelocity, stage1, force } = scratch.at;
  const axes = AXES[world.dimensions];
  for (let a = 0; a < axes.length; a++) {
    const axis = axes[a];
    const v = Velocity[axis];
    kernels.verletCorrectAxis(v, startVelocity[axis], stage1[axis], force[axis], Mass.value, dt, first, last);
  }
});
