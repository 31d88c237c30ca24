import { addComponent, addEntity, observe, onAdd, onRemove, query, removeEntity } from 'bitecs';
import { describe, expect, it } from 'vitest';
import { hashAfter } from '../../../../test/support/chaos.ts';
import { codeOf, emitting, living, run } from '../../../../test/support/emitting.ts';
import { KINDS } from '../../../../test/support/worlds.ts';
import {
  aliveCount,
  bodies,
  burst,
  createEmitter,
  createPhysicsWorld,
  createRandom,
  defineForce,
  despawn,
  destroyEmitter,
  destroyWorld,
  entityRef,
  isAlive,
  keepState,
  markImmutable,
  on,
  type PhysicsWorld,
  particleContacts,
  replaceForce,
  resource,
  restore,
  setRate,
  snapshot,
  spawn,
  spawnMany,
  springs,
  stateHash,
  step,
  uniformGravity,
} from '../index.ts';

/** Spawns, removes and connects bodies by springs, singly and by the dozen, in a seeded random sequence. */
function churn(world: PhysicsWorld, seed: number, steps: number): string {
  const random = createRandom(seed);
  const point = () => ({ x: random.uniform(-9, 9), y: random.uniform(0, 9) });
  for (let i = 0; i < steps; i++) {
    const list = bodies(world);
    if (random.uniform() < 0.5) {
      spawn(world, { position: point(), velocity: point(), mass: 1, collider: { radius: 0.2 } });
    }
    if (random.uniform() < 0.1) spawnMany(world, 12, { position: point(), velocity: {}, mass: 2 });
    if (random.uniform() < 0.2 && list.count > 2) {
      const [a, b] = [list.ids[0], list.ids[list.count - 1]];
      spawn(world, { spring: { a, b, stiffness: 5, length: 1 } });
    }
    if (random.uniform() < 0.5 && list.count > 2) despawn(world, list.ids[random.integer(0, list.count - 1)]);
    step(world, 1 / 60);
  }
  return `${stateHash(world)} ${[...bodies(world).ids.slice(0, bodies(world).count)]} ${addEntity(world)}`;
}

const crowd = (options: { dimensions?: 2 | 3; precision?: 'f32' | 'f64' } = {}) =>
  createPhysicsWorld({
    capacity: 3000,
    preset: particleContacts,
    forces: [uniformGravity({ y: -3 }), springs()],
    ...options,
  });

describe.each(KINDS)('bodies that are created and removed, $dimensions D $precision', (kind) => {
  it('are created again with the same ids', () => {
    const world = crowd(kind);
    churn(world, 1, 60);
    const taken = snapshot(world);
    const first = churn(world, 2, 100);
    restore(world, taken);
    expect(churn(world, 2, 100)).toBe(first);
  });

  it('may diverge in between; earlier and later snapshots work', () => {
    const world = crowd(kind);
    const start = snapshot(world);
    churn(world, 1, 80);
    const middle = snapshot(world);
    const end = churn(world, 2, 60);
    for (const taken of [start, middle, start]) {
      restore(world, taken);
      churn(world, 9, 40);
    }
    restore(world, middle);
    expect(churn(world, 2, 60)).toBe(end);
    restore(world, start);
    expect(bodies(world).count).toBe(0);
  });
});

describe('restored state', () => {
  it('a removed body, under its old reference; not a body created since', () => {
    const world = crowd();
    const a = spawn(world, { position: {}, mass: 1 });
    const ref = entityRef(world, a);
    const taken = snapshot(world);
    despawn(world, a);
    const b = spawn(world, { position: { x: 3 } });
    expect(b).toBe(a);
    const later = entityRef(world, b);
    restore(world, taken);
    expect([isAlive(world, ref), isAlive(world, later)]).toEqual([true, false]);
    expect(world.components.Position.x[a]).toBe(0);
    expect(world.components.Mass.value[a]).toBe(1);
  });

  it('forces, systems, the integrator, the time', () => {
    const world = createPhysicsWorld({ forces: [uniformGravity({ y: -1 })] });
    spawn(world, { position: {}, mass: 1 });
    const taken = snapshot(world);
    const first = hashAfter(world, 20);
    replaceForce(world, uniformGravity({ y: -5 }));
    world.forces.push(defineForce({ name: 'none', accumulate() {} }));
    world.phases.input.push(() => {});
    hashAfter(world, 20);
    restore(world, taken);
    expect([world.forces.length, world.phases.input.length, world.tick]).toEqual([1, 0, 0]);
    expect(hashAfter(world, 20)).toBe(first);
  });

  it('faults, and the quarantine of their bodies', () => {
    const world = createPhysicsWorld();
    const body = spawn(world, { position: {}, velocity: {}, mass: 1 });
    const taken = snapshot(world);
    world.components.Position.x[body] = Number.NaN;
    step(world, 1 / 60);
    expect(world.faults.faults).toHaveLength(1);
    expect(query(world, [world.components.Quarantined])).toHaveLength(1);
    restore(world, taken);
    expect(world.faults.faults).toHaveLength(0);
    expect(query(world, [world.components.Quarantined])).toHaveLength(0);
  });

  it('the plain objects of a resource; resources created since are created again', () => {
    const score = resource(() => ({ points: 0, names: ['a'], seen: new Set([1]), numbers: new Float64Array(2) }));
    const late = resource(() => ({ made: true, count: 0 }));
    const world = createPhysicsWorld();
    const state = score(world);
    const taken = snapshot(world);
    state.points = 5;
    state.names.push('b');
    state.seen.add(2);
    state.numbers[1] = 7;
    Object.assign(state, { more: 1 });
    late(world).count = 3;
    restore(world, taken);
    expect(score(world)).toBe(state);
    expect(state).toEqual({ points: 0, names: ['a'], seen: new Set([1]), numbers: new Float64Array(2) });
    expect(late(world).count).toBe(0);
  });

  it('event listeners are excluded', () => {
    const world = crowd();
    const taken = snapshot(world);
    let eventCount = 0;
    on(world, 'contact', () => eventCount++);
    restore(world, taken);
    for (const x of [0, 0.3]) spawn(world, { position: { x }, mass: 1, collider: { radius: 0.2 } });
    step(world, 1 / 60);
    expect(eventCount).toBe(1);
  });

  it('calls observers, and survives one that throws', () => {
    const world = crowd();
    const body = spawn(world, { position: { x: 2 }, mass: 1 });
    const hash = stateHash(world);
    const taken = snapshot(world);
    despawn(world, body);
    spawn(world, { position: {}, charge: 1 });
    const heard: string[] = [];
    observe(world, onAdd(world.components.Mass), () => heard.push('mass'));
    observe(world, onRemove(world.components.Charge), () => {
      throw new Error('not now');
    });
    expect(() => restore(world, taken)).toThrow(/observers threw 1 exception/);
    expect(heard).toEqual(['mass']);
    expect(stateHash(world)).toBe(hash);
  });

  it('keeps entities without physics, removes later ones, recreates earlier ones', () => {
    const world = crowd();
    const Tag = {};
    const [kept, lost] = [addEntity(world), addEntity(world)];
    addComponent(world, kept, Tag);
    const taken = snapshot(world);
    removeEntity(world, lost);
    for (let i = 0; i < 3; i++) addEntity(world);
    restore(world, taken);
    expect([...query(world, [Tag])]).toEqual([kept]);
    expect(addEntity(world)).toBe(lost + 1);
  });
});

describe('emitters', () => {
  it('continue with the same pool and the same random numbers', () => {
    const { world, emitter } = emitting({ rate: 300, lifetime: [0.2, 1.5], speed: [1, 9], spread: 3 });
    run(world, 1);
    const taken = snapshot(world);
    const play = () => {
      burst(emitter, 50);
      setRate(emitter, 500);
      run(world, 1);
      return `${stateHash(world)} ${aliveCount(emitter)} ${living(emitter)}`;
    };
    const first = play();
    restore(world, taken);
    expect(play()).toBe(first);
    // The rate is the saved one, not the one that `play` set last.
    restore(world, taken);
    run(world, 0.5);
    const undisturbed = emitting({ rate: 300, lifetime: [0.2, 1.5], speed: [1, 9], spread: 3 });
    run(undisturbed.world, 1.5);
    expect(stateHash(world)).toBe(stateHash(undisturbed.world));
  });

  it('destroyed since work again; those created since throw an error', () => {
    const { world, emitter } = emitting({ rate: 100, lifetime: 1 });
    run(world, 0.5);
    const taken = snapshot(world);
    const alive = aliveCount(emitter);
    expect(alive).toBeGreaterThan(0);
    destroyEmitter(emitter);
    const later = createEmitter(world, { capacity: 500, rate: 10, lifetime: 1 });
    const both = snapshot(world);
    run(world, 0.5);
    restore(world, taken);
    expect(aliveCount(emitter)).toBe(alive);
    expect(codeOf(() => aliveCount(later))).toBe('E_STALE');
    expect(() => destroyEmitter(later)).not.toThrow();
    restore(world, both);
    expect(codeOf(() => aliveCount(emitter))).toBe('E_STALE');
    expect(aliveCount(later)).toBe(0);
  });
});

describe('rejected calls', () => {
  it('a snapshot of another world, and other values', () => {
    const [world, other] = [crowd(), crowd()];
    spawn(world, { position: {} });
    const hash = stateHash(world);
    const taken = snapshot(world);
    expect(codeOf(() => restore(other, taken))).toBe('E_TYPE');
    expect(codeOf(() => snapshot(other, taken))).toBe('E_TYPE');
    for (const bad of [undefined, null, 7, {}]) expect(codeOf(() => restore(world, bad as never))).toBe('E_TYPE');
    expect(stateHash(world)).toBe(hash);
    restore(world, taken);
  });

  it('80 a snapshot or a restore inside a step, and of a destroyed world, is refused', () => {
    const world = crowd();
    const taken = snapshot(world);
    const seen: string[] = [];
    world.phases.input.push(() =>
      seen.push(
        codeOf(() => snapshot(world)),
        codeOf(() => restore(world, taken)),
      ),
    );
    step(world, 1 / 60);
    expect(seen).toEqual(['E_REENTRANT', 'E_REENTRANT']);
    destroyWorld(world);
    expect(codeOf(() => snapshot(world))).toBe('E_DESTROYED');
    expect(codeOf(() => restore(world, taken))).toBe('E_DESTROYED');
  });
});

it('reuses the memory of a spare snapshot', () => {
  const world = crowd();
  churn(world, 1, 40);
  const old = snapshot(world);
  churn(world, 2, 40);
  const [time, hash] = [world.time, stateHash(world)];
  expect(snapshot(world, old)).toBe(old);
  expect([old.time, old.tick]).toEqual([time, 80]);
  const end = churn(world, 3, 40);
  restore(world, old);
  expect(stateHash(world)).toBe(hash);
  expect(churn(world, 3, 40)).toBe(end);
});

it('takes no more memory than the world uses', () => {
  const world = createPhysicsWorld({ capacity: 1_000_000, precision: 'f32' });
  spawnMany(world, 100, { position: {}, velocity: {}, mass: 1 });
  step(world, 1 / 60);
  // The snapshot has one page per column in use, of a memory of several hundred megabytes.
  expect(snapshot(world).bytes).toBeLessThan(60 * 4096);
});

describe('instances of classes inside kept objects', () => {
  class Player {
    hp = 3;
    readonly items = ['sword'];
  }

  it('are refused by a snapshot, which names the place', () => {
    for (const [game, place] of [
      [{ round: 1, players: [new Player()] }, 'object[0].players[0]'],
      [{ players: new Map([['a', new Player()]]) }, 'object[0].players[a]'],
      [{ players: new Set([new Player()]) }, 'object[0].players.member 0'],
      [Object.assign(new Player(), { rival: new Player() }), 'object[0].rival'],
    ] as const) {
      const world = createPhysicsWorld({ capacity: 5 });
      keepState(world, game);
      expect(() => snapshot(world)).toThrow(`keepState: ${place} is an instance of a class`);
    }
  });

  it('go back if they were passed as well, and are left alone if they keep their own state or have none', () => {
    const world = createPhysicsWorld({ capacity: 5 });
    const player = new Player();
    const record = Object.assign(new Player(), { state: { best: 1 } });
    const picture = markImmutable(new Player());
    const game = {
      round: 1,
      players: [player],
      record,
      picture,
      day: new Date(0),
      frozen: Object.freeze(new Player()),
    };
    keepState(world, game, player, record.state);
    const taken = snapshot(world);
    Object.assign(game, { round: 2 });
    player.hp = 1;
    player.items.push('key');
    record.state.best = 2;
    record.hp = picture.hp = 9;
    game.players.push(new Player());
    restore(world, taken);
    expect([game.round, game.players, player.hp, player.items]).toEqual([1, [player], 3, ['sword']]);
    expect([record.state.best, record.hp, picture.hp]).toEqual([1, 9, 9]);
  });
});
