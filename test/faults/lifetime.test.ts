import {
  createPhysicsWorld,
  despawn,
  destroyWorld,
  entityRef,
  isAlive,
  isBody,
  type PhysicsWorld,
  resolve,
  spawn,
  stateHash,
  step,
} from '@principia/physics';
import {
  addComponent,
  addEntity,
  getComponent,
  hasComponent,
  observe,
  onRemove,
  query,
  removeComponent,
  removeEntity,
  removeQuery,
  set,
} from 'bitecs';
import { describe, expect, it } from 'vitest';
import {
  assertRefused,
  assertWorldAlive,
  ball,
  bodyState,
  DT,
  emptySpace,
  groundWorld,
  refusal,
  steps,
  worldState,
} from '../support/worlds.ts';

describe('references', () => {
  it('51 removing a body twice gives E_STALE and does not change the hash', () => {
    const world = groundWorld();
    ball(world, 0, 1);
    const eid = ball(world, 1, 1);
    despawn(world, eid);
    assertRefused(world, () => despawn(world, eid), { code: 'E_STALE', entity: eid });
    assertWorldAlive(world);
  });

  it('52 a stale reference reads and writes nothing, even if its id is reused', () => {
    const world = groundWorld();
    const first = entityRef(world, ball(world, 0, 1));
    despawn(world, resolve(world, first));
    const heir = ball(world, 7, 1);
    expect(heir).toBe(first % 2 ** 24); // the id was given again
    expect(isAlive(world, first)).toBe(false);
    assertRefused(world, () => resolve(world, first), { code: 'E_STALE', entity: heir });
    expect(resolve(world, entityRef(world, heir))).toBe(heir);
  });

  it('52 a row written through a stale id does not affect the next body', () => {
    const world = emptySpace();
    ball(world, 0, 0);
    const eid = ball(world, 1, 1, { x: 1 });
    despawn(world, eid);
    world.components.Velocity.x[eid] = 99;
    world.components.Mass.value[eid] = 1e9;
    expect(spawn(world, { position: { x: 2 } })).toBe(eid);
    expect(bodyState(world, eid)).toBe('Position.x=2');
  });

  it.each([0, -1, 1.5, NaN, 1e9, '1', null, undefined, {}, 2n])('52 %s is neither a body nor a reference', (bad) => {
    const world = groundWorld();
    ball(world, 0, 1);
    const eid = bad as number;
    expect([isBody(world, eid), isAlive(world, bad as never)]).toEqual([false, false]);
    assertRefused(world, () => despawn(world, eid), { code: 'E_STALE' });
    assertRefused(world, () => entityRef(world, eid), { code: 'E_STALE' });
    assertRefused(world, () => resolve(world, bad as never), { code: 'E_STALE' });
  });

  it('52 references to a row stay distinct over many generations', () => {
    const world = emptySpace({ capacity: 10 });
    const seen = new Set<number>();
    world.internal.generations.fill(2 ** 29 - 1000); // near the end of the numbers
    for (let life = 0; life < 900; life++) {
      const eid = spawn(world, { position: {} });
      const ref = entityRef(world, eid);
      expect(Number.isSafeInteger(ref) && resolve(world, ref) === eid && !seen.has(ref)).toBe(true);
      seen.add(ref);
      despawn(world, eid);
    }
  });
});

describe('the end of a world', () => {
  it('60 a world destroyed during a step is destroyed when the step ends', () => {
    const world = groundWorld();
    const eid = ball(world, 0, 5);
    let made = 0;
    world.phases.input.push(() => {
      destroyWorld(world);
      made = ball(world, 3, 3);
    });
    step(world, DT);
    expect([world.state, world.tick, made > 0]).toEqual(['destroyed', 1, true]);
    expect(world.components.Position.y[eid]).toBeLessThan(5); // the step was complete
    expect(refusal(() => step(world, DT)).code).toBe('E_DESTROYED');
  });

  it('60 an observer can destroy the world while edits take effect', () => {
    const world = groundWorld();
    const [a, b] = [ball(world, 0, 1), ball(world, 1, 1)];
    observe(world, onRemove(world.components.Position), () => destroyWorld(world));
    world.phases.input.push(() => {
      despawn(world, a);
      despawn(world, b);
    });
    step(world, DT);
    expect(world.state).toBe('destroyed');
  });

  it('60 destroying twice has no effect', () => {
    const world = groundWorld();
    destroyWorld(world);
    destroyWorld(world);
    expect(world.state).toBe('destroyed');
    expect(refusal(() => destroyWorld({} as PhysicsWorld)).code).toBe('E_TYPE');
  });
});

describe('direct use of bitECS', () => {
  it('62 adding twice and removing an absent component change nothing', () => {
    const world = groundWorld();
    const eid = ball(world, 0, 1);
    const { Position, LinearDrag } = world.components;
    step(world, DT);
    const before = worldState(world);
    addComponent(world, eid, Position);
    addComponent(world, eid, Position);
    removeComponent(world, eid, LinearDrag);
    expect(worldState(world)).toEqual(before);
    addComponent(world, eid, set(LinearDrag, 2));
    addComponent(world, eid, LinearDrag);
    expect([LinearDrag.coefficient[eid], world.internal.counts.LinearDrag]).toEqual([2, 1]);
    removeComponent(world, eid, LinearDrag);
    removeComponent(world, eid, LinearDrag);
    expect(worldState(world)).toEqual(before);
  });

  it('63 an entity removed raw loses its row, its counts and its references', () => {
    const world = groundWorld();
    const keep = ball(world, 0, 1);
    const eid = ball(world, 1, 1);
    const ref = entityRef(world, eid);
    removeEntity(world, eid);
    expect([isAlive(world, ref), bodyState(world, eid), world.lastId]).toEqual([false, '', keep]);
    const alone = groundWorld();
    ball(alone, 0, 1);
    expect(stateHash(world)).toBe(stateHash(alone));
    assertWorldAlive(world);
  });

  it('63 removeQuery does not disconnect the rows', () => {
    const world = groundWorld();
    const { Position } = world.components;
    const eid = ball(world, 1, 1);
    query(world, [Position]);
    removeQuery(world, [Position]);
    removeEntity(world, eid);
    expect([isBody(world, eid), bodyState(world, eid)]).toEqual([false, '']);
    const next = ball(world, 2, 1);
    expect([...query(world, [Position])]).toEqual([next]);
  });

  it('a component without values gets its default values', () => {
    const world = groundWorld();
    const eid = addEntity(world);
    const { Position, Mass, Orientation } = world.components;
    addComponent(world, eid, Position);
    addComponent(world, eid, Mass);
    addComponent(world, eid, Orientation);
    expect(bodyState(world, eid)).toBe('Mass.value=1 Orientation.w=1');
    expect(getComponent(world, eid, Mass)).toEqual({ value: 1 });
  });

  it('components copied by bitECS keep the meaning of infinity', () => {
    const world = groundWorld();
    const wall = spawn(world, { position: {}, mass: Infinity });
    const copy = addEntity(world);
    addComponent(world, copy, set(world.components.Mass, getComponent(world, wall, world.components.Mass)));
    expect(world.components.Mass.value[copy]).toBe(0);
    expect(hasComponent(world, copy, world.components.Mass)).toBe(true);
  });
});

describe('many worlds', () => {
  it('64 a thousand worlds coexist', { timeout: 60_000 }, () => {
    const worlds = Array.from({ length: 1000 }, (_, i) => {
      const world = createPhysicsWorld({ capacity: 8, arenaBytes: 0 });
      spawn(world, { position: { x: i }, velocity: { x: 1 } });
      return world;
    });
    for (const world of worlds) steps(world, 2, 0.5);
    expect(worlds.every(({ components }, i) => components.Position.x[1] === i + 1)).toBe(true);
    for (const world of worlds) destroyWorld(world);
  });
});
