// Events of contacts between rigid bodies as arrays, which are read after a step.
import type { RealColumn } from '../components/define.ts';
import { RigidTableWord as Word } from '../memory/layouts.gen.ts';
import { markImmutable, resource } from '../memory/resource.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { rigidTable } from './rigid-table.ts';

/** Pairs of bodies in ascending order; entry i of each array is valid for i < `count`. */
export interface ContactPairs {
  readonly count: number;
  /** Entity ids, a < b. */
  readonly a: Uint32Array;
  readonly b: Uint32Array;
}

/** Impacts faster than the `hitSpeed` of the integrator. */
export interface ContactHits extends ContactPairs {
  /** The point, m, and the unit normal from a to b. */
  readonly x: RealColumn;
  readonly y: RealColumn;
  readonly nx: RealColumn;
  readonly ny: RealColumn;
  /** Speed of approach before the impact, m/s. */
  readonly speed: RealColumn;
}

/** The events of the last step. The arrays are reused by every step. */
export interface ContactEvents {
  /** Bodies that began to touch, or came within 2 cm. */
  readonly begin: ContactPairs;
  /** Bodies that no longer touch; one of them may be gone. Pairs that ended because they drifted apart come first. */
  readonly end: ContactPairs;
  readonly hit: ContactHits;
  /** Pairs for which there was no room since the world was made: more memory by `arenaBytes` prevents that. */
  readonly droppedCount: number;
}

const eventsOf = /* @__PURE__ */ resource<ContactEvents>((world) => {
  const { words } = rigidTable(world);
  const { buffer } = world.memory;
  const length = words[Word.contactCapacity];
  const Column = world.precision === 'f32' ? Float32Array : Float64Array;
  const ids = (word: Word) => new Uint32Array(buffer, words[word], length);
  const reals = (word: Word): RealColumn => new Column(buffer, words[word], length);
  const pairs = (count: Word, a: Word, b: Word) => ({
    get count() {
      return words[count];
    },
    a: ids(a),
    b: ids(b),
  });
  const impacts = {
    x: reals(Word.hitX),
    y: reals(Word.hitY),
    nx: reals(Word.hitNx),
    ny: reals(Word.hitNy),
    speed: reals(Word.hitSpeeds),
  };
  const hit = Object.defineProperties(
    impacts,
    Object.getOwnPropertyDescriptors(pairs(Word.hitCount, Word.hitA, Word.hitB)),
  );
  return markImmutable({
    begin: pairs(Word.beginCount, Word.beginA, Word.beginB),
    end: pairs(Word.endCount, Word.endA, Word.endB),
    hit: hit as ContactHits,
    get droppedCount() {
      return words[Word.droppedCount];
    },
  });
});

/**
 * Returns the events of contacts between rigid bodies in the last step: always the same object. A world without rigid
 * bodies has none.
 * @throws PhysicsError E_CAPACITY, E_DESTROYED
 */
export function contactEvents(world: PhysicsWorld): ContactEvents {
  return eventsOf(world);
}
