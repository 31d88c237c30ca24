import {
  type BodyInput,
  bodies,
  createPhysicsWorld,
  despawn,
  destroyWorld,
  type ManyInput,
  type PhysicsWorld,
  restore,
  snapshot,
  spawn,
  spawnMany,
  stateHash,
  step,
} from '@principia/physics';
import {
  addComponent,
  addEntity,
  getAllEntities,
  getEntityComponents,
  hasComponent,
  Not,
  Or,
  observe,
  onAdd,
  onRemove,
  query,
  removeEntity,
} from 'bitecs';
import { describe, expect, it } from 'vitest';
import { assertRefused, bodyState, emptySpace, refusal, worldState } from '../support/worlds.ts';

const N = 40;
const each = (value: (i: number) => number) => Float64Array.from({ length: N }, (_, i) => value(i));

/** Columns with arrays and single numbers, a normalised component and a scalar. */
const MANY: ManyInput = {
  position: { x: each((i) => i), y: 2 },
  velocity: { y: each((i) => -i) },
  mass: each((i) => (i === 3 ? Infinity : 1 + i)),
  orientation: { x: each((i) => i), w: 1 },
  collider: { radius: 0.25 },
  appearance: 7,
};

function bodyOf(i: number): BodyInput {
  return {
    position: { x: i, y: 2 },
    velocity: { y: -i },
    mass: i === 3 ? Infinity : 1 + i,
    orientation: { x: i, w: 1 },
    collider: { radius: 0.25 },
    appearance: 7,
  };
}

/** Registers everything that a user can observe. */
function watched(world: PhysicsWorld) {
  const { Position, Velocity, Mass, LinearDrag } = world.components;
  const tag = {};
  const marked = addEntity(world);
  addComponent(world, marked, tag);
  const terms = [
    [Position],
    [Position, Velocity],
    [Not(Velocity)],
    [Position, Not(Mass)],
    [Position, Not(LinearDrag)],
    [Or(Mass, LinearDrag)],
    [Or(LinearDrag, tag)],
    [Not(tag)],
    [tag],
  ];
  const told: string[] = [];
  for (const [q, term] of terms.entries()) {
    query(world, term);
    observe(world, onAdd(...term), (eid) => void told.push(`+${q}:${eid}`));
    observe(world, onRemove(...term), (eid) => void told.push(`-${q}:${eid}`));
  }
  const results = () => terms.map((term) => [...query(world, term)].sort((a, b) => a - b));
  return { results, told };
}

/** Returns the final state of observers: created one by one, bodies also join and leave queries in between. */
function net(told: readonly string[]): unknown {
  const sums = new Map<string, number>();
  for (const text of told) sums.set(text.slice(1), (sums.get(text.slice(1)) ?? 0) + (text[0] === '+' ? 1 : -1));
  return [...sums].filter(([, sum]) => sum !== 0).sort();
}

function churn(world: PhysicsWorld): void {
  const ids = Array.from({ length: 50 }, (_, i) => spawn(world, { position: { x: i }, linearDrag: 3 }));
  for (const i of [7, 3, 40, 4, 5, 30, 1, 49, 20, 21, 22]) despawn(world, ids[i]);
}

describe('bulk creation', () => {
  it.each([
    ['in a fresh world', false],
    ['after churn, with recycled ids', true],
  ])('equals creation component by component %s', (_, churned) => {
    const outcomes = [true, false].map((bulk) => {
      const world = emptySpace({ dimensions: 3 });
      const { results, told } = watched(world);
      if (churned) churn(world);
      told.length = 0;
      const ids = bulk ? [...spawnMany(world, N, MANY)] : Array.from({ length: N }, (_, i) => spawn(world, bodyOf(i)));
      const heard = net(told);
      const state = ids.map((eid) => [
        bodyState(world, eid),
        getEntityComponents(world, eid).length,
        hasComponent(world, eid, world.components.LinearDrag),
        world.previous.Position.x[eid],
      ]);
      const found = results();
      for (const eid of ids) removeEntity(world, eid);
      const after = [results(), stateHash(world), { ...world.internal.counts }];
      return { ids, hash: stateHash(world), state, found, world: worldState(world), after, heard };
    });
    expect(outcomes[0]).toEqual(outcomes[1]);
  });

  it('passes complete bodies to onAdd observers', () => {
    const world = emptySpace();
    const { Position, Velocity } = world.components;
    const seen: number[][] = [];
    observe(world, onAdd(Position), (eid) => void seen.push([eid, Position.x[eid], Velocity.x[eid]]));
    spawnMany(world, 3, { position: { x: [1, 2, 3] }, velocity: { x: 9 } });
    expect(seen).toEqual([
      [1, 1, 9],
      [2, 2, 9],
      [3, 3, 9],
    ]);
  });

  it('undoes everything if an observer or the progress callback throws', () => {
    const world = emptySpace();
    const { Position } = world.components;
    churn(world);
    const before = worldState(world);
    const fail = () => {
      throw new Error('no');
    };
    expect(() => spawnMany(world, 5, { position: {}, mass: 2 }, fail)).toThrow('no');
    expect(worldState(world)).toEqual(before);
    const off = observe(world, onAdd(Position), fail);
    expect(() => spawnMany(world, 5, { position: {}, mass: 2 })).toThrow('no');
    expect(worldState(world)).toEqual(before);
    off();
    spawnMany(world, 5, { position: {} });
  });

  it('does not overwrite other bodies if recycled ids are out of order', () => {
    const world = emptySpace();
    for (let i = 0; i < 12; i++) spawn(world, { position: { x: 100 + i } });
    // bitECS reuses the id freed last: 2, 9, 1 and 5, whose ends are as far apart as four consecutive ids.
    for (const eid of [5, 1, 9, 2]) despawn(world, eid);
    expect([...spawnMany(world, 4, { position: { x: -1 } })]).toEqual([2, 9, 1, 5]);
    const { x } = world.components.Position;
    expect([...x.subarray(1, 13)]).toEqual([-1, -1, 102, 103, -1, 105, 106, 107, -1, 109, 110, 111]);
  });

  it('leaves nothing of what was written to rows whose bodies are gone', () => {
    const world = createPhysicsWorld({ capacity: 8 });
    spawn(world, { position: {} });
    const gone = spawn(world, { position: {}, mass: 1 });
    despawn(world, gone);
    world.components.Velocity.x[gone] = 5;
    const [id] = spawnMany(world, 1, { position: { x: 3 } });
    expect([id, world.components.Velocity.x[id]]).toEqual([gone, 0]);
    step(world, 0.1);
    expect(world.components.Position.x[id]).toBe(3);
  });

  it('zero bodies are allowed', () => {
    const world = emptySpace();
    const before = worldState(world);
    expect(spawnMany(world, 0, { position: { x: [] } })).toHaveLength(0);
    expect(worldState(world)).toEqual(before);
  });

  it('refuses a restore, a step and the end of the world while it reports progress', () => {
    const world = createPhysicsWorld({ capacity: 100 });
    const taken = snapshot(world);
    const acts = [
      () => restore(world, taken),
      () => step(world, 0.01),
      () => snapshot(world),
      () => destroyWorld(world),
    ];
    for (const act of acts) {
      expect(refusal(() => spawnMany(world, 50, { position: {} }, act)).code).toBe('E_REENTRANT');
      expect([bodies(world).count, world.state, getAllEntities(world).length]).toEqual([0, 'idle', 0]);
    }
    expect(spawnMany(world, 100, { position: {} })).toHaveLength(100);
  });

  it('reports progress up to the end', () => {
    const world = emptySpace({ capacity: 140_000 });
    const made: number[] = [];
    spawnMany(world, 140_000, { position: {} }, (count) => made.push(count));
    expect(made).toEqual([65536, 131072, 140_000]);
  });

  it.each([
    [3, { position: { x: new Float32Array(2) } }, 'E_RANGE', 'position.x'],
    [3, { position: { x: [0, 1, NaN] } }, 'E_NONFINITE', 'position.x[2]'],
    [3, { position: { x: [0, '1', 2] } }, 'E_TYPE', 'position.x[1]'],
    [3, { position: { x: new Array(3) } }, 'E_TYPE', 'position.x[0]'],
    [3, { position: { x: new BigInt64Array(3) } }, 'E_TYPE', 'position.x[0]'],
    [3, { position: { x: new DataView(new ArrayBuffer(3)) } }, 'E_TYPE', 'position.x'],
    [3, { position: { x: { length: 3 } } }, 'E_TYPE', 'position.x'],
    [3, { position: { x: undefined } }, 'E_TYPE', 'position.x'],
    [3, { position: [1, 2, 3] }, 'E_TYPE', 'position'],
    [3, { position: { x: [0, 1, 1e30] } }, 'E_RANGE', 'position.x[2]'],
    [3, { position: { z: [0, 0, 1] } }, 'E_RANGE', 'position.z[2]'],
    [3, { mass: [1, 0, 2] }, 'E_RANGE', 'mass[1]'],
    [3, { mass: [1, -Infinity, 2] }, 'E_NONFINITE', 'mass[1]'],
    [3, { appearance: { color: [1, 2, 0.5] } }, 'E_RANGE', 'appearance[2]'],
    [3, { orientation: { w: [1, 0, 1] } }, 'E_RANGE', 'orientation'],
    [3, { mas: 1 }, 'E_UNKNOWN', 'mas'],
    [3, { position: { q: 1 } }, 'E_UNKNOWN', 'q'],
    [3, null, 'E_TYPE', 'spawnMany'],
    [3, [], 'E_TYPE', 'spawnMany'],
    [-1, {}, 'E_RANGE', 'count'],
    [1.5, {}, 'E_RANGE', 'count'],
    ['3', {}, 'E_TYPE', 'count'],
    [NaN, {}, 'E_NONFINITE', 'count'],
    [4e9, {}, 'E_CAPACITY', 'capacity'],
  ])('of %s with %o is refused with %s at %s', (count, values, code, field) => {
    const world = emptySpace();
    churn(world);
    assertRefused(world, () => spawnMany(world, count as number, values as ManyInput), { code, field });
  });
});
