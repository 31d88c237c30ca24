// A damped spring from a body to a point that a pointer or a script moves.
//
//   F = m ω² (p - r) - 2 ζ m ω v,  at most `maxForce`        ω = 2π f
//   U = m ω² d²/2 below the maximum force, F_max d - F_max²/(2 m ω²) above        d = |p - r|
//
//   m  mass, kg    p  the point, m    f  frequency, Hz    ζ  damping ratio, 1 critical
//
// Scaled by the mass, so that heavy and light bodies respond alike. Keep f below a tenth of the step rate. A body may
// be grabbed and released at run time by functions of the force, `grab(world, id, point)`, `moveTo(point)` and `release()`;
// the grab is input, like a key, and not part of the world's state, unless it is named: `keepState(world, pull.grip)`.
// Energy is conserved while the point rests and ζ = 0: damping dissipates it, and a moving point adds to it. Catto, Soft
// Constraints (Game Developers Conference, 2011). Cost: none unless a body is grabbed, and then two square roots or
// divisions and about 25 more operations for every body, because all SIMD lanes do the same.
import { defineLaw } from '../dynamics/define-law.ts';
import { assertBody, type EntityRef, entityRef, isAlive, resolve } from '../ecs/entity-ref.ts';
import { checkVector, type VectorInput } from '../errors/validate.ts';
import { constant, select, vec3 } from '../laws/expression.ts';
import { scalar } from '../laws/parameter.ts';
import { type TableLocation, table } from '../laws/table.ts';
import { forceMemory } from '../memory/force-memory.ts';
import type { Force, PhysicsWorld } from '../world/types.ts';
import { POSITION_BOUNDS } from './support/bounds.ts';

/** Options of `pointerPull`. */
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
  /**
   * The reference of the body that is grabbed, 0 for none, and the point. `keepState(world, pull.grip)` makes them part of the
   * state of a world, which snapshots restore.
   */
  readonly grip: { ref: EntityRef; x: number; y: number; z: number };
  /** Grabs a body. @throws PhysicsError E_STALE, E_DESTROYED, E_TYPE, E_NONFINITE, E_RANGE */
  grab(world: PhysicsWorld, eid: number, point: VectorInput): void;
  /** Moves the point. @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE */
  moveTo(point: VectorInput): void;
  /** Releases the body, which keeps its velocity. */
  release(): void;
}

const NO_BODY = 0 as EntityRef;

/** The grabbed entity and the target point: one row, or none. */
const GRAB = ['entity', 'x', 'y', 'z'] as const;

/**
 * A damped spring from a body to a point that a pointer or a script moves: F = m ω² (p - r) - 2 ζ m ω v, N, at most
 * `maxForce`. It acts between `grab` and `release`.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function pointerPull(options: PointerPullOptions = {}): PointerPull {
  const grip = { ref: NO_BODY, x: 0, y: 0, z: 0 };
  // The world of the last grab. Worlds that took the state of one world have equal references.
  let lastWorld: PhysicsWorld | undefined;
  const moveTo = (point: VectorInput) => {
    const { x, y, z } = checkVector(point, 'pointerPull.point', POSITION_BOUNDS);
    Object.assign(grip, { x, y, z });
  };
  const { of: grabOf, release: releaseMemory } = forceMemory(({ memory }, take) => {
    const at = take(8 * GRAB.length, 'a pointer pull');
    return { row: new Float64Array(memory.buffer, at, GRAB.length), tableAt: { at, count: 0 } };
  });
  const force = definePull((world) => {
    const { row, tableAt } = grabOf(world);
    const isHeld = (lastWorld ?? world) === world && isAlive(world, grip.ref);
    tableAt.count = isHeld ? 1 : 0;
    row[0] = isHeld ? resolve(world, grip.ref) : 0;
    row[1] = grip.x;
    row[2] = grip.y;
    row[3] = grip.z;
    return tableAt;
  })(options);
  return {
    ...force,
    releaseMemory,
    grip,
    grab(world, eid, point) {
      assertBody(world, eid);
      moveTo(point);
      grip.ref = entityRef(world, eid);
      lastWorld = world;
    },
    moveTo,
    release() {
      grip.ref = NO_BODY;
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
