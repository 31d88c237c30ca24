// The contacts of the last step as arrays, and as events.

import { warnAboutWallContacts } from '#warnings';
import type { RealColumn } from '../components/define.ts';
import { ContactTableWord as Word } from '../memory/layouts.gen.ts';
import { COMPUTED_ANEW, markImmutable, namedResource } from '../memory/resource.ts';
import { emit, hasHandlers } from '../world/event-handlers.ts';
import { nameSystem } from '../world/name-system.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { contactTable } from './contact-table.ts';

/**
 * The contacts between bodies of the last step in ascending order of (a, b); entry i of each array is valid for i <
 * `count`. The arrays are reused by every step. A contact is listed when its bodies exchanged an impulse or overlap.
 */
export interface Contacts {
  readonly count: number;
  /** Candidates dropped because a limit was reached; see `contactCapacity`. */
  readonly droppedCount: number;
  /** Entity ids, a < b. */
  readonly a: Uint32Array;
  readonly b: Uint32Array;
  /** Contact point, m: the middle of the overlap at the end of the step. */
  readonly x: RealColumn;
  readonly y: RealColumn;
  readonly z: RealColumn;
  /** Unit normal from a to b. */
  readonly nx: RealColumn;
  readonly ny: RealColumn;
  readonly nz: RealColumn;
  /**
   * Speed of approach along the normal, m/s, when the surfaces met, or before the step if they met earlier; negative where
   * they part.
   */
  readonly speed: RealColumn;
  /** Normal impulse in this step, N s: positive on b, and the opposite on a. */
  readonly impulse: RealColumn;
}

/** The wall contacts of the last step. */
export interface WallContacts {
  readonly count: number;
  /** Contacts dropped because the capacity was reached. */
  readonly droppedCount: number;
  readonly body: Uint32Array;
  /** Entity id of the wall, or 0 for `boxWalls`. */
  readonly wall: Uint32Array;
  /** Unit normal out of the wall. */
  readonly nx: RealColumn;
  readonly ny: RealColumn;
  readonly nz: RealColumn;
  /** Speed into the wall, m/s, as in {@link Contacts}. */
  readonly speed: RealColumn;
  /** Impulse of the wall on the body along the normal, N s. */
  readonly impulse: RealColumn;
}

const contactsOf = /* @__PURE__ */ namedResource<Contacts>(COMPUTED_ANEW, (world) => {
  const table = contactTable(world).words;
  const capacity = table[Word.capacity];
  const { reals, words } = viewers(world, capacity);
  return markImmutable({
    get count() {
      return table[Word.count];
    },
    get droppedCount() {
      return table[Word.droppedCount];
    },
    a: words(table[Word.a]),
    b: words(table[Word.b]),
    x: reals(table[Word.x]),
    y: reals(table[Word.y]),
    z: reals(table[Word.z]),
    nx: reals(table[Word.nx]),
    ny: reals(table[Word.ny]),
    nz: reals(table[Word.nz]),
    speed: reals(table[Word.speed]),
    impulse: reals(table[Word.impulse]),
  });
});

const wallContactsOf = /* @__PURE__ */ namedResource<WallContacts>(COMPUTED_ANEW, (world) => {
  const table = contactTable(world).words;
  const { reals, words } = viewers(world, table[Word.wallCapacity]);
  return markImmutable({
    get count() {
      return table[Word.wallCount];
    },
    get droppedCount() {
      return table[Word.wallDroppedCount];
    },
    body: words(table[Word.wallBody]),
    wall: words(table[Word.wallId]),
    nx: reals(table[Word.wallNx]),
    ny: reals(table[Word.wallNy]),
    nz: reals(table[Word.wallNz]),
    speed: reals(table[Word.wallSpeed]),
    impulse: reals(table[Word.wallImpulse]),
  });
});

function viewers(world: PhysicsWorld, length: number) {
  const { buffer } = world.memory;
  const Column = world.precision === 'f32' ? Float32Array : Float64Array;
  return {
    reals: (address: number): RealColumn => new Column(buffer, address, length),
    words: (address: number) => new Uint32Array(buffer, address, length),
  };
}

/**
 * Returns the contacts between bodies of the last step. The object is the same at every call; it is empty in a world
 * whose preset has no contacts.
 * @throws PhysicsError E_CAPACITY if the world's memory is too small for contacts, E_DESTROYED
 */
export function contacts(world: PhysicsWorld): Contacts {
  return contactsOf(world);
}

/**
 * Returns the wall contacts of the last step, in the order in which they happened, chunk by chunk of bodies. They are noted by
 * `enableContacts`, which is in the preset `particleContacts`: in other worlds it is empty, with a warning.
 * @throws PhysicsError E_CAPACITY, E_DESTROYED
 */
export function wallContacts(world: PhysicsWorld): WallContacts {
  const contacts = wallContactsOf(world);
  if (!world.internal.recordsContacts) warnAboutWallContacts(world);
  return contacts;
}

/** Returns the maximum number of contacts in a step; a larger `arenaBytes` raises it. */
export function contactCapacity(world: PhysicsWorld): number {
  return contactTable(world).words[Word.capacity];
}

/** System of the `events` phase: dispatches the events of this step's contacts, of bodies first, then of walls. */
export const dispatchContactEvents = /* @__PURE__ */ nameSystem('dispatch contacts', (world: PhysicsWorld) => {
  if (hasHandlers(world, 'contact')) {
    const { count } = contactsOf(world);
    for (let i = 0; i < count; i++) emit(world, 'contact', i);
  }
  if (hasHandlers(world, 'wallContact')) {
    const { count } = wallContactsOf(world);
    for (let i = 0; i < count; i++) emit(world, 'wallContact', i);
  }
});
