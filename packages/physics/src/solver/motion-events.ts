// Which rigid bodies moved, fell asleep or woke, as arrays, which are read after a step.
import { assertUsable } from '../ecs/guards.ts';
import { RigidTableWord as Word } from '../memory/layouts.gen.ts';
import { COMPUTED_ANEW, markImmutable, namedResource } from '../memory/resource.ts';
import { isSoftStep } from '../world/is-soft-step.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { rigidTable } from './rigid-table.ts';

/** Ids of bodies: `ids[0 … count)`. */
export interface BodyIds {
  readonly count: number;
  readonly ids: Uint32Array;
}

/** What happened to bodies in the last step. The arrays are reused by every step. */
export interface MotionEvents {
  /** Bodies that the solver moved: those that are awake or were until the end of the step, ascending. */
  readonly moved: BodyIds;
  /** Bodies that fell asleep at the end of the step. */
  readonly asleep: BodyIds;
  /** Bodies that woke at the start of the step. */
  readonly awake: BodyIds;
}

const eventsOf = /* @__PURE__ */ namedResource<MotionEvents>(COMPUTED_ANEW, (world) => {
  const { words } = rigidTable(world);
  const bodies = (count: Word, list: Word): BodyIds => ({
    get count() {
      return words[count];
    },
    ids: new Uint32Array(world.memory.buffer, words[list], world.rows),
  });
  return markImmutable({
    moved: bodies(Word.awakeCount, Word.awake),
    asleep: bodies(Word.sleptCount, Word.slept),
    awake: bodies(Word.wokenCount, Word.woken),
  });
});

const NO_BODIES: BodyIds = { count: 0, ids: /* @__PURE__ */ new Uint32Array(0) };
const NO_EVENTS: MotionEvents = { moved: NO_BODIES, asleep: NO_BODIES, awake: NO_BODIES };

/**
 * Returns which rigid bodies moved, fell asleep and woke in the last step: always the same object. Parts of compound bodies
 * are not listed. A world without rigid bodies has none.
 * @throws PhysicsError E_CAPACITY, E_DESTROYED
 */
export function motionEvents(world: PhysicsWorld): MotionEvents {
  assertUsable(world);
  return isSoftStep(world.integrator) ? eventsOf(world) : NO_EVENTS;
}
