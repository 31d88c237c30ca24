// Events of contacts between rigid bodies as arrays, which are read after a step.
import type { RealColumn } from '../components/define.ts';
import { assertUsable } from '../ecs/guards.ts';
import {
  CONTACT_EVENT_LIST_BYTES,
  ContactEventListWord as EventWord,
  RigidTableWord as Word,
} from '../memory/layouts.gen.ts';
import { recordAt } from '../memory/record.ts';
import { COMPUTED_ANEW, markImmutable, namedResource } from '../memory/resource.ts';
import { isSoftStep } from '../world/is-soft-step.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { rigidTable } from './rigid-table.ts';

/** Pairs of entities in ascending order; entry i of each array is valid for i < `count`. */
export interface ContactPairs {
  readonly count: number;
  /** Ids of the entities with the shapes, a < b: bodies, or parts of compound bodies. */
  readonly a: Uint32Array;
  readonly b: Uint32Array;
}

/** Contacts and how they began or were hit. */
export interface ContactHits extends ContactPairs {
  /** The point, m, and the unit normal from a to b. */
  readonly x: RealColumn;
  readonly y: RealColumn;
  readonly nx: RealColumn;
  readonly ny: RealColumn;
  /** Speed of approach before the step, m/s; negative where they part. */
  readonly speed: RealColumn;
  /** Impulse along the normal in the step, N s; 0 for what only came near. */
  readonly impulse: RealColumn;
}

/** The events of the last step. The arrays are reused by every step. */
export interface ContactEvents {
  /** Bodies that began to touch, or came within 2 cm: those have an impulse of 0, here and in `contactPoints`. */
  readonly begin: ContactHits;
  /** Bodies that parted, at 2 to 7 cm if they go slowly; one of them may be gone. Pairs that ended because they drifted apart come first. */
  readonly end: ContactPairs;
  /** Impacts faster than the `hitSpeed` of the integrator. */
  readonly hit: ContactHits;
  /** Pairs for which there was no room since the world was made: more memory by `arenaBytes` prevents that. */
  readonly droppedCount: number;
}

const eventsOf = /* @__PURE__ */ namedResource<ContactEvents>(COMPUTED_ANEW, (world) => {
  const { words } = rigidTable(world);
  const end = {
    get count() {
      return words[Word.endCount];
    },
    a: listOf(world, words[Word.endA]),
    b: listOf(world, words[Word.endB]),
  };
  return markImmutable({
    begin: hitsOf(world, words[Word.begins]),
    end,
    hit: hitsOf(world, words[Word.hits]),
    get droppedCount() {
      return words[Word.droppedCount];
    },
  });
});

/** A list of ids with room for all contacts. */
export function listOf(world: PhysicsWorld, at: number): Uint32Array {
  return new Uint32Array(world.memory.buffer, at, rigidTable(world).words[Word.contactCapacity]);
}

function hitsOf(world: PhysicsWorld, at: number): ContactHits {
  const { memory, precision } = world;
  const { words } = recordAt(memory, at, CONTACT_EVENT_LIST_BYTES);
  const Column = precision === 'f32' ? Float32Array : Float64Array;
  const length = rigidTable(world).words[Word.contactCapacity];
  const reals = (word: EventWord): RealColumn => new Column(memory.buffer, words[word], length);
  return {
    get count() {
      return words[EventWord.count];
    },
    a: listOf(world, words[EventWord.a]),
    b: listOf(world, words[EventWord.b]),
    x: reals(EventWord.x),
    y: reals(EventWord.y),
    nx: reals(EventWord.nx),
    ny: reals(EventWord.ny),
    speed: reals(EventWord.speeds),
    impulse: reals(EventWord.impulses),
  };
}

const NO_IDS = /* @__PURE__ */ new Uint32Array(0);
const NO_PAIRS: ContactPairs = { count: 0, a: NO_IDS, b: NO_IDS };
const NO_REALS = /* @__PURE__ */ new Float64Array(0);
const NO_HITS: ContactHits = {
  count: 0,
  a: NO_IDS,
  b: NO_IDS,
  x: NO_REALS,
  y: NO_REALS,
  nx: NO_REALS,
  ny: NO_REALS,
  speed: NO_REALS,
  impulse: NO_REALS,
};
const NO_EVENTS: ContactEvents = { begin: NO_HITS, end: NO_PAIRS, hit: NO_HITS, droppedCount: 0 };

/**
 * Returns the events of contacts between rigid bodies in the last step: always the same object. A world without rigid
 * bodies has none. A pair is in `end` and in `begin` of one step where a body was despawned and its id given to another that touches
 * the same: count a pair up at each `begin` and down at each `end`, and the order does not matter.
 * @throws PhysicsError E_CAPACITY, E_DESTROYED
 */
export function contactEvents(world: PhysicsWorld): ContactEvents {
  assertUsable(world);
  return isSoftStep(world.integrator) ? eventsOf(world) : NO_EVENTS;
}
