// A damped spring from a body to a point that a pointer or a script moves.
//
//   F = m ω² (p - r) - 2 ζ m ω v,  at most `maxForce`        ω = 2π f
//   U = m ω² d²/2 below the maximum force, F_max d - F_max²/(2 m ω²) above        d = |p - r|
//
//   m  mass, kg    p  the point, m    f  frequency, Hz    ζ  damping ratio, 1 critical
//
// Scaled by the mass, so that heavy and light bodies respond alike. Keep f below a tenth of the step rate. A body may
// be grabbed and released at run time by functions of the force, `grab(world, id, point)`, `moveTo(point)` and `release()`;
// the grab is input, like a key, and not part of the world's state. Energy is conserved while the point rests and ζ = 0:
// damping dissipates it, and a moving point adds to it. Catto, Soft Constraints (Game Developers Conference, 2011). Cost:
// none unless a body is grabbed, and then two square roots or divisions and about 25 more operations for every body,
// because all SIMD lanes do the same.
import { defineLaw } from '../dynamics/define-law.ts';
import { assertBody, type EntityRef, entityRef, isAlive } from '../ecs/entity-ref.ts';
import { checkVector, type VectorInput } from '../errors/validate.ts';
import { constant, select, vec3 } from '../laws/expression.ts';
import { scalar } from '../laws/parameter.ts';
import { type TableLocation, table } from '../laws/table.ts';
import { forceMemory } from '../memory/force-memory.ts';
import type { Force, PhysicsWorld } from '../world/types.ts';
import { POSITION_BOUNDS } from './support/bounds.ts';

export interface PointerPullOptions {
  /** Frequency f, Hz; default 2. */
  readonly frequency?: number;
  /** Damping ratio ζ; default 1, without overshoot. */
  readonly dampingRatio?: number;
  /** Maximum force, N; default 10³⁰. */
  readonly maxForce?: number;
}

/** The force, with functions to grab and move a body. */
export interface PointerPull extends Force {
  /** Grabs a body. @throws PhysicsError E_STALE, E_DESTROYED, E_TYPE, E_NONFINITE, E_RANGE */
  grab(world: PhysicsWorld, eid: number, point: VectorInput): void;
  /** Moves the point. @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE */
  moveTo(point: VectorInput): void;
  /** Releases the body, which keeps its velocity. */
  release(): void;
}

/** The grabbed entity and the target point: one row, or none. */
const GRAB = ['entity', 'x', 'y', 'z'] as const;

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function pointerPull(options: PointerPullOptions = {}): PointerPull {
  const grabbed = { world: undefined as PhysicsWorld | undefined, eid: 0, ref: 0 as EntityRef };
  let target = checkVector({}, 'pointerPull');
  const { of: grabOf, release: releaseMemory } = forceMemory(({ memory }, take) => {
    const at = take(8 * GRAB.length, 'a pointer pull');
    return { row: new Float64Array(memory.buffer, at, GRAB.length), tableAt: { at, count: 0 } };
  });
  const force = definePull((world) => {
    const { row, tableAt } = grabOf(world);
    tableAt.count = grabbed.world === world && isAlive(world, grabbed.ref) ? 1 : 0;
    row[0] = grabbed.eid;
    row[1] = target.x;
    row[2] = target.y;
    row[3] = target.z;
    return tableAt;
  })(options);
  return {
    ...force,
    releaseMemory,
    grab(world, eid, point) {
      assertBody(world, eid);
      target = checkVector(point, 'pointerPull.point', POSITION_BOUNDS);
      grabbed.ref = entityRef(world, eid);
      grabbed.eid = eid;
      grabbed.world = world;
    },
    moveTo(point) {
      target = checkVector(point, 'pointerPull.point', POSITION_BOUNDS);
    },
    release() {
      grabbed.world = undefined;
    },
  };
}

function definePull(locate: (world: PhysicsWorld) => TableLocation) {
  return defineLaw({
    name: 'pointer pull',
    formula: 'F = m ω² (p - r) - 2 ζ m ω v',
    source: 'Catto, Soft Constraints, Game Developers Conference (2011).',
    parameters: {
      frequency: scalar('Hz', { default: 2, above: 0, max: 1e6 }),
      dampingRatio: scalar('', { default: 1, min: 0, max: 100 }),
      maxForce: scalar('N', { default: 1e30, above: 0, max: 1e38 }),
      grip: table(GRAB, locate),
    },
    acceleration: ({ position, velocity, mass, entity }, { frequency, dampingRatio, maxForce, grip }) =>
      grip.sum(({ entity: held, x, y, z }) => {
        const omega = frequency.mul(2 * Math.PI);
        const springAcceleration = vec3(x, y, z).sub(position).mul(omega.square());
        const desired = springAcceleration.sub(velocity.mul(dampingRatio.mul(2).mul(omega)));
        const scale = constant(1).min(maxForce.div(desired.length().mul(mass)));
        return select(entity.equals(held), desired.mul(scale), vec3(0, 0, 0));
      }),
    potential: ({ position, mass, entity }, { frequency, maxForce, grip }) =>
      grip.sum(({ entity: held, x, y, z }) => {
        const stiffness = mass.mul(frequency.mul(2 * Math.PI).square());
        const distance = vec3(x, y, z).sub(position).length();
        const elastic = stiffness.mul(distance.square()).div(2);
        const limited = maxForce.mul(distance.sub(maxForce.div(stiffness).div(2)));
        const energy = select(stiffness.mul(distance).lessOrEqual(maxForce), elastic, limited);
        return select(entity.equals(held), energy, 0);
      }),
    prepare: (world) => void locate(world),
  });
}
