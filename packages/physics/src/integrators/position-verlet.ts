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
import { momentOf } from '../forces/evaluate';
import { AXES } from '../store/axes';
import { axisColumns } from '../store/columns';
import { resource } from '../store/resource';
import type { Spans } from '../store/spans';
import type { PhysicsWorld } from '../world';
import type { Integrator } from './integrator';
import { integratorKernels } from './kernels';

/** What a body remembers: the last displacement, and where and how fast its last step left it. */
const memoryOf = resource(({ internal: { arena }, precision, rows }) => ({
  displacement: axisColumns(arena, precision, rows, 'position Verlet: displacement')[1],
  leftX: axisColumns(arena, precision, rows, 'position Verlet: position')[1],
  leftV: axisColumns(arena, precision, rows, 'position Verlet: velocity')[1],
  tick: -1,
  /** The step under way, and the one before it where that was the world's last. */
  dt: 0,
  before: 0,
}));

export const positionVerlet: Integrator = {
  name: 'position Verlet',
  order: 2,
  symplectic: true,
  evaluations: 1,
  columns: 9,
  prepare(world) {
    memoryOf(world);
  },
  advance(world, spans, dt, evaluateForces) {
    const memory = memoryOf(world);
    if (memory.tick !== world.tick) {
      memory.before = memory.tick === world.tick - 1 ? memory.dt : 0;
      memory.tick = world.tick;
      memory.dt = dt;
    }
    evaluateForces(world, spans, momentOf(world, 0));
    move(world, spans, dt, memory.before === 0 ? 0 : dt / memory.before);
  },
};

function move(world: PhysicsWorld, spans: Spans, dt: number, ratio: number): void {
  const { addresses, scratch } = world;
  const { Position, Velocity, Mass } = addresses;
  const { displacement, leftX, leftV } = memoryOf(world);
  const { stormerAxis } = integratorKernels(world);
  for (const axis of AXES[world.dimensions]) {
    const x = Position[axis];
    const v = Velocity[axis];
    const f = scratch.at.force[axis];
    const d = displacement[axis];
    const px = leftX[axis];
    const pv = leftV[axis];
    for (let r = 0; r < spans.count; r++) {
      const first = spans.bounds[2 * r];
      stormerAxis(x, v, d, px, pv, f, Mass.value, dt, ratio, first, spans.bounds[2 * r + 1]);
    }
  }
}
