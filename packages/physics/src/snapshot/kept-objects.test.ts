// What kept objects may contain: it goes back with the world, in place and in another world, or is refused by its place.
import { describe, expect, it } from 'vitest';
import {
  createPhysicsWorld,
  decodeSnapshot,
  encodeSnapshot,
  keepState,
  markImmutable,
  type PhysicsWorld,
  restore,
  snapshot,
  step,
} from '../index.ts';

function keeping<T extends object>(state: T): { world: PhysicsWorld; state: T } {
  const world = createPhysicsWorld({ capacity: 5 });
  keepState(world, state);
  return { world, state };
}

/** What `show` says of the state before a change, after it was taken back, and in another world that loads it. */
function takeBack<T extends object>(make: () => T, change: (state: T) => void, show: (state: T) => unknown): unknown[] {
  const { world, state } = keeping(make());
  const taken = snapshot(world);
  const before = structuredClone(show(state));
  change(state);
  restore(world, taken);
  const loaded = keeping(make());
  change(loaded.state);
  restore(loaded.world, decodeSnapshot(loaded.world, encodeSnapshot(taken)));
  return [before, show(state), show(loaded.state)];
}

const bytes = (...values: number[]) => new Uint8Array(values);

describe('values that go back', () => {
  it.each<[string, () => { v: unknown }, (state: { v: never }) => void]>([
    ['big integers', () => ({ v: 2n }), (s) => Object.assign(s, { v: 3n })],
    ['dates', () => ({ v: new Date(1) }), ({ v }) => (v as Date).setTime(5)],
    ['invalid dates', () => ({ v: new Date(Number.NaN) }), ({ v }) => (v as Date).setTime(5)],
    ['buffers', () => ({ v: bytes(1, 2).buffer }), ({ v }) => new Uint8Array(v).fill(7)],
    [
      'views of buffers',
      () => ({ v: new DataView(bytes(1, 2, 3).buffer, 1) }),
      ({ v }) => (v as DataView).setUint8(1, 7),
    ],
    ['16-bit integers', () => ({ v: new Int16Array([1, 2]) }), ({ v }) => (v as Int16Array).fill(7)],
    ['64-bit integers', () => ({ v: new BigInt64Array([1n]) }), ({ v }) => (v as BigInt64Array).fill(7n)],
    ['a value in the place of another', () => ({ v: new Date(1) }), (s) => Object.assign(s, { v: ['a'] })],
    ['an object in the place of an array', () => ({ v: { a: 1 } }), (s) => Object.assign(s, { v: [1] })],
    [
      'a dictionary in the place of an object',
      () => ({ v: Object.assign(Object.create(null), { a: 1 }) }),
      (s) => Object.assign(s, { v: { b: 1 } }),
    ],
    [
      'a number in the place of a dictionary',
      () => ({ v: new Float64Array(2) }),
      (s) => Object.assign(s, { v: Object.create(null) }),
    ],
  ])('%s', (_, make, change) => {
    const [before, restored, loaded] = takeBack(make, change as (state: { v: unknown }) => void, ({ v }) => v);
    expect(restored).toEqual(before);
    expect(loaded).toEqual(before);
    expect(Object.prototype.toString.call(loaded)).toBe(Object.prototype.toString.call(before));
  });

  it('holes of arrays', () => {
    const make = () => ({ v: Object.assign([] as unknown[], { 0: 1, 1: undefined, 3: 4, length: 5 }) });
    const show = ({ v }: { v: unknown[] }) => [v.length, ...Object.keys(v)];
    const results = takeBack(make, ({ v }) => v.splice(0, 5, 1, 2, 3), show);
    expect(results).toEqual([0, 1, 2].map(() => [5, '0', '1', '3']));
  });

  it('buffers of Node', () => {
    const results = takeBack(
      () => ({ v: Buffer.from([1, 2]) }),
      ({ v }) => v.fill(7),
      ({ v }) => [...v],
    );
    expect(results).toEqual([0, 1, 2].map(() => [1, 2]));
  });

  it('the order of keys, which loops follow', () => {
    const make = () => ({ ann: 1, bob: 2, cy: 3 }) as Record<string, number>;
    const change = (s: Record<string, number>) => {
      delete s.ann;
      s.cy = 7;
    };
    const expected = ['ann,1', 'bob,2', 'cy,3'];
    expect(takeBack(make, change, (s) => Object.entries(s).map(String))).toEqual([expected, expected, expected]);
    // The same keys in another order.
    const turn = (s: Record<string, number>) => {
      change(s);
      s.ann = 4;
    };
    expect(takeBack(make, turn, (s) => Object.entries(s).map(String))).toEqual([expected, expected, expected]);
  });

  it('the order of keys among getters', () => {
    const make = () => ({
      a: 1,
      get double() {
        return 2 * this.a;
      },
      b: 2,
    });
    const { world, state } = keeping<Record<string, number>>(make());
    const taken = snapshot(world);
    delete state.a;
    state.c = 5;
    restore(world, taken);
    expect(Object.keys(state)).toEqual(['a', 'double', 'b']);
    state.a = 4;
    expect(state.double).toBe(8);
  });

  it('a list of 20 000 objects, each of which contains the next', () => {
    type Item = { i: number; next?: Item };
    const make = () => {
      const head: Item = { i: -1 };
      for (let i = 0, at = head; i < 20_000; i++) at = at.next = { i };
      return head;
    };
    const sum = (head: Item) => {
      let total = 0;
      for (let at: Item | undefined = head; at !== undefined; at = at.next) total += at.i;
      return total;
    };
    const change = (head: Item) => {
      for (let at: Item | undefined = head; at !== undefined; at = at.next) at.i = 1;
    };
    expect(takeBack(make, change, sum)).toEqual([199_989_999, 199_989_999, 199_989_999]);
  });
});

it('an object stays kept when the world goes back to before it was', () => {
  const { world } = keeping({ round: 1 });
  const before = snapshot(world);
  const bytesBefore = encodeSnapshot(before);
  const score = { points: 1 };
  keepState(world, score);
  score.points = 2;
  restore(world, before);
  expect(score.points).toBe(2);
  const later = snapshot(world);
  score.points = 50;
  restore(world, later);
  expect(score.points).toBe(2);
  // Also where nothing was kept before.
  const empty = createPhysicsWorld({ capacity: 5 });
  const first = snapshot(empty);
  keepState(empty, score);
  restore(empty, first);
  const second = snapshot(empty);
  score.points = 50;
  restore(empty, second);
  expect(score.points).toBe(2);
  // Another program has no place for it.
  expect(() => decodeSnapshot(empty, bytesBefore)).toThrow('E_TYPE');
});

describe('immutable states', () => {
  const freeze = <T extends object>(value: T): T => {
    for (const item of Object.values(value)) if (typeof item === 'object' && item !== null) freeze(item);
    return Object.freeze(value);
  };

  it('are replaced, and go back by reference', () => {
    const game = { state: freeze({ hp: 3, items: [{ name: 'sword' }] }) };
    const { world } = keeping(game);
    const taken = snapshot(world);
    const before = game.state;
    game.state = freeze({ ...game.state, hp: 2 });
    restore(world, taken);
    expect(game.state).toBe(before);
    const loaded = keeping({ state: freeze({ hp: 9, items: [] as { name: string }[] }) });
    restore(loaded.world, decodeSnapshot(loaded.world, encodeSnapshot(taken)));
    expect(loaded.state.state).toEqual(before);
    expect([loaded.state.state, loaded.state.state.items, loaded.state.state.items[0]].every(Object.isFrozen)).toBe(
      true,
    );
  });

  it('may have been mutable when an earlier snapshot was taken', () => {
    const { world, state } = keeping({ state: { hp: 3 } });
    const spare = snapshot(world);
    Object.freeze(state.state);
    const bytesOfIt = encodeSnapshot(snapshot(world, spare));
    const loaded = keeping({ state: Object.freeze({ hp: 9 }) });
    restore(loaded.world, decodeSnapshot(loaded.world, bytesOfIt));
    expect(loaded.state.state.hp).toBe(3);
  });

  it('with shared parts and cycles', () => {
    const part: { self?: object } = {};
    part.self = part;
    Object.freeze(part);
    const loaded = keeping({ a: part, b: part });
    const bytesOfIt = encodeSnapshot(snapshot(loaded.world));
    restore(loaded.world, decodeSnapshot(loaded.world, bytesOfIt));
    expect(loaded.state.a).toBe(loaded.state.b);
    expect(loaded.state.a.self).toBe(loaded.state.a);
  });

  it('a frozen object around others that change is no hindrance', () => {
    const { world, state } = keeping({ box: Object.freeze({ lives: new Map([['ann', 3]]) }) });
    const taken = snapshot(world);
    state.box.lives.set('ann', 1);
    restore(world, taken);
    expect(state.box.lives.get('ann')).toBe(3);
    restore(world, decodeSnapshot(world, encodeSnapshot(taken)));
    expect(state.box.lives.get('ann')).toBe(3);
  });

  it.each<[string, (player: { hp: number; items: string[] }) => void, RegExp | undefined]>([
    [
      'frozen with other values',
      (p) => Object.freeze(Object.assign(p, { hp: 2 })),
      /object\[0\]\.players\[0\] is frozen or sealed/,
    ],
    [
      'sealed with another key',
      (p) => Object.seal(Object.assign(p, { more: 2 })),
      /object\[0\]\.players\[0\] is frozen or sealed/,
    ],
    [
      'a frozen list with another item',
      (p) => Object.freeze(Object.assign(p.items, { 1: 'b' })),
      /players\[0\]\.items is frozen/,
    ],
    ['frozen with the same values', (p) => freeze(p), undefined],
    ['sealed with another value', (p) => Object.assign(Object.seal(p), { hp: 2 }), undefined],
  ])('an object that was mutable is %s', (_, change, message) => {
    const { world, state } = keeping({ players: [{ hp: 3, items: ['a'] }] });
    const taken = snapshot(world);
    step(world, 0.1);
    change(state.players[0]);
    if (message === undefined) {
      restore(world, taken);
      expect(state).toEqual({ players: [{ hp: 3, items: ['a'] }] });
    } else {
      expect(() => restore(world, taken)).toThrow(message);
      expect(world.tick).toBe(1);
    }
  });
});

describe('values that are refused', () => {
  it.each<[string, object, string]>([
    ['regular expressions that go on', { a: [/a/g] }, 'object[0].a[0] is a regular expression that goes on'],
    ['weak maps', { a: new WeakMap() }, 'object[0].a has weak references'],
    ['symbols as keys', { a: { [Symbol('hp')]: 1 } }, 'object[0].a has the property Symbol(hp)'],
    ['properties of arrays', { a: Object.assign([1], { hp: 1 }) }, 'object[0].a has the property "hp"'],
  ])('%s, by their place', (_, state, message) => {
    const { world } = keeping(state);
    expect(() => snapshot(world)).toThrow(`E_TYPE: keepState: ${message}`);
    expect(() => snapshot(world)).toThrow('E_TYPE');
  });

  it('unless they are no state', () => {
    const Hidden = Symbol('hidden');
    const state = Object.defineProperty({ word: /a/, cache: markImmutable(new WeakMap()) }, Hidden, { value: 1 });
    expect(() => snapshot(keeping(state).world)).not.toThrow();
  });

  it('an instance at the end of a long list', () => {
    class Player {
      hp = 3;
    }
    const head: { next?: object } = {};
    let at = head;
    for (let i = 0; i < 20_000; i++) at = at.next = {};
    at.next = new Player();
    expect(() => snapshot(keeping(head).world)).toThrow(
      /^E_TYPE: keepState: object\[0\]\.next\.next.{185,200} is an instance of a class/,
    );
  });
});
