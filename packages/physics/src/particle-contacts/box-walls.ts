// Walls of an axis-aligned box, solved at the time of impact. The formulas are in
// kernels/particle-contacts/walls/impact.ts.
import { MAX_SPEED } from '../components/velocity.ts';
import { type BoxSystem, bounceFromBox } from '../dynamics/fused-step.ts';
import { FAR } from '../dynamics/loop-checks.ts';
import { findImpacts, refineImpacts } from '../dynamics/refine-impacts.ts';
import { assertUsable } from '../ecs/guards.ts';
import { checkKeys, checkNumber, checkVector, mustBe, type VectorInput } from '../errors/validate.ts';
import { AXES } from '../memory/axes.ts';
import { BOX_BYTES, BoxNumber, BoxWord } from '../memory/layouts.gen.ts';
import { allocateRecord } from '../memory/record.ts';
import { COMPUTED_ANEW, namedResource } from '../memory/resource.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** A box that keeps bodies inside. An axis omitted from `min` or `max` has no wall on that side. */
export interface BoxWallsOptions {
  /** Corner with the smallest coordinates, m. Default no walls there. */
  readonly min?: VectorInput;
  /** Corner with the largest coordinates, m. Default no walls there. */
  readonly max?: VectorInput;
  /** Restitution of the walls; a contact's is the larger of this and the body's. Default 0: the body decides. */
  readonly restitution?: number;
  /** Friction of the walls; a contact's is the geometric mean of this and the body's. Default: the body's own. */
  readonly friction?: number;
}

/**
 * Creates a system for the `walls` phase. It acts on bodies with Mass and Collider. In a world of rigid bodies each wall becomes
 * an entity with PlaneWall before the next step.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function boxWalls(options: BoxWallsOptions): BoxSystem {
  checkKeys(options, 'boxWalls', ['min', 'max', 'restitution', 'friction']);
  checkVector(options.min ?? {}, 'boxWalls.min');
  checkVector(options.max ?? {}, 'boxWalls.max');
  const low = { x: -FAR, y: -FAR, z: -FAR, ...options.min };
  const high = { x: FAR, y: FAR, z: FAR, ...options.max };
  for (const axis of AXES[3]) {
    if (low[axis] < high[axis]) continue;
    throw mustBe(`below max.${axis} (${high[axis]})`, low[axis], `boxWalls.min.${axis}`, 'E_RANGE');
  }
  const restitution = checkNumber(options.restitution ?? 0, 'boxWalls.restitution', { min: 0, max: 10 });
  const friction =
    options.friction === undefined ? -1 : checkNumber(options.friction, 'boxWalls.friction', { min: 0, max: 100 });
  const values = [low.x, low.y, low.z, high.x, high.y, high.z, restitution, friction];
  const boxAt = namedResource(COMPUTED_ANEW, (world) => writeBox(world, values));
  const lagOf = ({ integrator }: PhysicsWorld, dt: number) => (integrator.velocityLag ?? 0) * dt;
  const system: BoxSystem = {
    name: 'box walls',
    role: 'box',
    box: { low, high, restitution, friction },
    prepare: boxAt,
    run(world, { bounds, count }, dt) {
      if (world.integrator.solvesWalls === true) return;
      if (world.internal.plan?.fusion?.walls === system) {
        bounceFromBox(world, system, world.ranges, dt);
        return;
      }
      const at = boxAt(world);
      for (let r = 0; r < count; r++) {
        world.kernels.boxRows(at, dt, lagOf(world, dt), bounds[2 * r], bounds[2 * r + 1]);
      }
    },
    bounceListed(world, words, list, dt, savesVelocity) {
      const impacts = findImpacts(world, words, list, dt, savesVelocity);
      const box = boxAt(world);
      const wrong = world.kernels.boxListed(box, list, dt, lagOf(world, dt), MAX_SPEED, savesVelocity ? 1 : 0);
      refineImpacts(world, impacts, dt, savesVelocity);
      return wrong === 0;
    },
  };
  return system;
}

/**
 * Replaces the first `boxWalls` of a world by a box with these options, wherever it stands among the walls; a world without one gets it.
 * Walls have no velocity: a box that shrinks from step to step does no work on what it holds.
 * @throws PhysicsError as `boxWalls`; E_DESTROYED
 */
export function replaceBoxWalls(world: PhysicsWorld, options: BoxWallsOptions): void {
  assertUsable(world);
  const { walls } = world.phases;
  const index = walls.findIndex((system) => typeof system !== 'function' && system.role === 'box');
  walls[index < 0 ? walls.length : index] = boxWalls(options);
}

function writeBox(world: PhysicsWorld, values: readonly number[]): number {
  const { internal, scratch, dimensions, previousAddresses } = world;
  const origin = previousAddresses.Position;
  const { at, numbers, words } = allocateRecord(internal.arena, BOX_BYTES, 'box walls');
  const { x, y, z } = scratch.at.startVelocity;
  numbers.set(values, BoxNumber.lowX);
  words.set([x, y, z], BoxWord.startX);
  words.set([origin.x, origin.y, origin.z], BoxWord.originX);
  words[BoxWord.axes] = dimensions;
  return at;
}
