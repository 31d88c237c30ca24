// A damped spring from one body to a point that a finger or a script moves.
//
//   F = m ω² (p - r) - 2 ζ m ω v,  at most `maxForce`        ω = 2π f
//   U = m ω² d²/2 while the spring pulls with less, F_max d - F_max²/(2 m ω²) beyond        d = |p - r|
//
//   m  mass, kg    p  the point, m    f  frequency, Hz    ζ  damping ratio, 1 critical
//
// Scaled by the mass, so that heavy and light bodies follow alike. Keep f below a tenth of the step rate. The body may be
// held and let go while the world runs; what is held is input, as a key is, and no part of the world's state. The energy
// closes while the point rests and ζ = 0: damping takes some, a hand that moves adds to it.
// Catto, Soft Constraints (Game Developers Conference, 2011). Cost: nothing unless something is held.
import { checkKeys, checkNumber, checkVector, type VectorInput } from '../faults/validate';
import { assertBody, type EntityRef, entityRef, isAlive } from '../store/references';
import type { PhysicsWorld } from '../world';
import { PLACES } from './bounds';
import type { Force } from './force';
import { lawKernels } from './law-kernels';

export interface PointerPullOptions {
  /** f, Hz; default 2. */
  readonly frequency?: number;
  /** ζ; default 1, which does not overshoot. */
  readonly dampingRatio?: number;
  /** Most force, N; default 10³⁰. */
  readonly maxForce?: number;
}

/** The force, and the hand that holds it. */
export interface PointerPull extends Force {
  /** Takes hold of a body. @throws PhysicsError E_STALE, E_DESTROYED, E_TYPE, E_NONFINITE, E_RANGE */
  grab(world: PhysicsWorld, eid: number, point: VectorInput): void;
  /** Moves the point. @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE */
  moveTo(point: VectorInput): void;
  /** Lets go; the body keeps its velocity. */
  release(): void;
}

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function pointerPull(options: PointerPullOptions = {}): PointerPull {
  checkKeys(options, 'pointerPull', ['frequency', 'dampingRatio', 'maxForce']);
  const frequency = checkNumber(options.frequency ?? 2, 'pointerPull.frequency', { above: 0, max: 1e6 });
  const ratio = checkNumber(options.dampingRatio ?? 1, 'pointerPull.dampingRatio', { min: 0, max: 100 });
  const most = checkNumber(options.maxForce ?? 1e30, 'pointerPull.maxForce', { above: 0, max: 1e38 });
  const omega = 2 * Math.PI * frequency;
  const held = { world: undefined as PhysicsWorld | undefined, eid: 0, ref: 0 as EntityRef };
  let target = checkVector({}, 'pointerPull');
  return {
    name: 'pointer pull',
    equation: 'F = m ω² (p - r) - 2 ζ m ω v',
    parameters: {
      frequency: { unit: 'Hz', value: frequency },
      dampingRatio: { unit: '', value: ratio },
      maxForce: { unit: 'N', value: most },
    },
    reads: ['Position', 'Velocity', 'Mass'],
    local: true,
    timeless: true,
    grab(world, eid, point) {
      assertBody(world, eid);
      target = checkVector(point, 'pointerPull.point', PLACES);
      held.ref = entityRef(world, eid);
      held.eid = eid;
      held.world = world;
    },
    moveTo(point) {
      target = checkVector(point, 'pointerPull.point', PLACES);
    },
    release() {
      held.world = undefined;
    },
    accumulate(world, first, last) {
      const { eid } = held;
      if (held.world !== world || eid < first || eid >= last || !isAlive(world, held.ref)) return;
      const { Position: p, Velocity: v, Mass } = world.components;
      const stiffness = omega * omega * Mass.value[eid];
      const damping = 2 * ratio * omega * Mass.value[eid];
      const x = stiffness * (target.x - p.x[eid]) - damping * v.x[eid];
      const y = stiffness * (target.y - p.y[eid]) - damping * v.y[eid];
      const z = world.dimensions === 3 ? stiffness * (target.z - p.z[eid]) - damping * v.z[eid] : 0;
      const size = Math.sqrt(x * x + y * y + z * z);
      const scale = size > most ? most / size : 1;
      const at = world.scratch.at.force;
      const kernels = lawKernels(world);
      kernels.addToRow(at.x, eid, scale * x);
      kernels.addToRow(at.y, eid, scale * y);
      kernels.addToRow(at.z, eid, scale * z);
    },
    potential(world) {
      const { eid } = held;
      if (held.world !== world || !isAlive(world, held.ref)) return 0;
      const { Position: p, Mass } = world.components;
      const stiffness = omega * omega * Mass.value[eid];
      const x = target.x - p.x[eid];
      const y = target.y - p.y[eid];
      const z = world.dimensions === 3 ? target.z - p.z[eid] : 0;
      const squared = x * x + y * y + z * z;
      if (stiffness * stiffness * squared <= most * most) return (stiffness * squared) / 2;
      return most * Math.sqrt(squared) - (most * most) / (2 * stiffness);
    },
  };
}
