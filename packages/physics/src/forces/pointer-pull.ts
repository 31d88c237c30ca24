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
// Catto, Soft Constraints (Game Developers Conference, 2011). Cost: nothing unless something is
// held, and then two square roots or divisions and some 25 more operations for every body: all lanes do the same.
import { defineLaw } from '../dynamics/define-law.ts';
import { assertBody, type EntityRef, entityRef, isAlive } from '../ecs/entity-ref.ts';
import { checkVector, type VectorInput } from '../errors/validate.ts';
import { constant, select, vec3 } from '../laws/expression.ts';
import { scalar } from '../laws/parameter.ts';
import { type TablePlace, table } from '../laws/table.ts';
import { allocate } from '../memory/arena.ts';
import { resource } from '../memory/resource.ts';
import type { Force, PhysicsWorld } from '../world/types.ts';
import { PLACES } from './support/bounds.ts';

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

/** What is held, and where to: one row, or none. */
const GRIP = ['entity', 'x', 'y', 'z'] as const;

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function pointerPull(options: PointerPullOptions = {}): PointerPull {
  const held = { world: undefined as PhysicsWorld | undefined, eid: 0, ref: 0 as EntityRef };
  let target = checkVector({}, 'pointerPull');
  const rowOf = resource(({ internal, memory }) => {
    const at = allocate(internal.arena, 8 * GRIP.length, 'a pointer pull');
    return { row: new Float64Array(memory.buffer, at, GRIP.length), place: { at, count: 0 } };
  });
  const force = pullBy((world) => {
    const { row, place } = rowOf(world);
    place.count = held.world === world && isAlive(world, held.ref) ? 1 : 0;
    row[0] = held.eid;
    row[1] = target.x;
    row[2] = target.y;
    row[3] = target.z;
    return place;
  })(options);
  return {
    ...force,
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
  };
}

function pullBy(placeOf: (world: PhysicsWorld) => TablePlace) {
  return defineLaw({
    name: 'pointer pull',
    formula: 'F = m ω² (p - r) - 2 ζ m ω v',
    source: 'Catto, Soft Constraints, Game Developers Conference (2011).',
    parameters: {
      frequency: scalar('Hz', { default: 2, above: 0, max: 1e6 }),
      dampingRatio: scalar('', { default: 1, min: 0, max: 100 }),
      maxForce: scalar('N', { default: 1e30, above: 0, max: 1e38 }),
      grip: table(GRIP, placeOf),
    },
    acceleration: ({ position, velocity, mass, entity }, { frequency, dampingRatio, maxForce, grip }) =>
      grip.sum(({ entity: held, x, y, z }) => {
        const omega = frequency.mul(2 * Math.PI);
        const pull = vec3(x, y, z).sub(position).mul(omega.square());
        const wanted = pull.sub(velocity.mul(dampingRatio.mul(2).mul(omega)));
        const share = constant(1).min(maxForce.div(wanted.length().mul(mass)));
        return select(entity.equals(held), wanted.mul(share), vec3(0, 0, 0));
      }),
    potential: ({ position, mass, entity }, { frequency, maxForce, grip }) =>
      grip.sum(({ entity: held, x, y, z }) => {
        const stiffness = mass.mul(frequency.mul(2 * Math.PI).square());
        const distance = vec3(x, y, z).sub(position).length();
        const stretched = stiffness.mul(distance.square()).div(2);
        const most = maxForce.mul(distance.sub(maxForce.div(stiffness).div(2)));
        const energy = select(stiffness.mul(distance).lessOrEqual(maxForce), stretched, most);
        return select(entity.equals(held), energy, 0);
      }),
    prepare: (world) => void placeOf(world),
  });
}
