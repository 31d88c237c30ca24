// The contacts of the last step as arrays, and as events.
import type { RealColumn } from '../components/define';
import { emit, hasHandlers } from '../events/handlers';
import { resource } from '../store/resource';
import type { PhysicsWorld } from '../world';
import { contactTable } from './contact-table';

/**
 * The contacts of the last step, by ascending (a, b); entry i of each array for i < `count`. The arrays stay valid, and
 * their content is that of the last step. A contact is listed when its bodies exchanged an impulse or overlap.
 */
export interface Contacts {
  readonly count: number;
  /** Candidates the step had no room for, or no time: see `contactCapacity`. */
  readonly lost: number;
  /** Entity ids, a < b. */
  readonly a: Uint32Array;
  readonly b: Uint32Array;
  /** Point of contact, m; the middle of the overlap when the step ended. */
  readonly x: RealColumn;
  readonly y: RealColumn;
  readonly z: RealColumn;
  /** Unit normal from a to b. */
  readonly nx: RealColumn;
  readonly ny: RealColumn;
  readonly nz: RealColumn;
  /** Impulse along the normal in this step, N s: on b, and the opposite on a. */
  readonly impulse: RealColumn;
}

/** The contacts with walls of the last step. */
export interface WallContacts {
  readonly count: number;
  /** Contacts there was no room for. */
  readonly lost: number;
  readonly body: Uint32Array;
  /** Entity id of the wall; 0 for `boxWalls`. */
  readonly wall: Uint32Array;
  /** Unit normal out of the wall. */
  readonly nx: RealColumn;
  readonly ny: RealColumn;
  readonly nz: RealColumn;
  /** Impulse of the wall on the body along the normal, N s. */
  readonly impulse: RealColumn;
}

const contactsOf = resource<Contacts>((world) => {
  const { at, read } = contactTable(world);
  const capacity = read('capacity');
  const { reals, words } = viewers(world, capacity);
  return {
    get count() {
      return read('count');
    },
    get lost() {
      return read('lost');
    },
    a: words(at.a),
    b: words(at.b),
    x: reals(at.x),
    y: reals(at.y),
    z: reals(at.z),
    nx: reals(at.nx),
    ny: reals(at.ny),
    nz: reals(at.nz),
    impulse: reals(at.impulse),
  };
});

const wallContactsOf = resource<WallContacts>((world) => {
  const { at, read } = contactTable(world);
  const { reals, words } = viewers(world, read('wallCapacity'));
  return {
    get count() {
      return read('wallCount');
    },
    get lost() {
      return read('wallLost');
    },
    body: words(at.wallBody),
    wall: words(at.wallId),
    nx: reals(at.wallNx),
    ny: reals(at.wallNy),
    nz: reals(at.wallNz),
    impulse: reals(at.wallImpulse),
  };
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
 * The contacts between bodies of the last step. Always the same object; empty in a world whose preset has no contacts.
 * @throws PhysicsError E_CAPACITY when the world's memory has no room for contacts, E_DESTROYED
 */
export function contacts(world: PhysicsWorld): Contacts {
  return contactsOf(world);
}

/**
 * The contacts with walls of the last step, in the order the walls were met, tile by tile of bodies.
 * @throws PhysicsError E_CAPACITY, E_DESTROYED
 */
export function wallContacts(world: PhysicsWorld): WallContacts {
  return wallContactsOf(world);
}

/** Most contacts a step can hold; a larger `arenaBytes` gives more. */
export function contactCapacity(world: PhysicsWorld): number {
  return contactTable(world).read('capacity');
}

/** System of the `events` phase: tells of this step's contacts between bodies. */
export function tellContacts(world: PhysicsWorld): void {
  if (!hasHandlers(world, 'contact')) return;
  const { count } = contactsOf(world);
  for (let i = 0; i < count; i++) emit(world, 'contact', i);
}
