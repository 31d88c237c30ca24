/** Edits of the world during a step, and exceptions of user code there. */
import {
  bodies,
  createPhysicsWorld,
  defineForce,
  despawn,
  entityRef,
  isAlive,
  isBody,
  on,
  type PhysicsWorld,
  particleContacts,
  pin,
  resolve,
  spawn,
  step,
  wallContacts,
} from '@principia/physics';
import {
  addComponent,
  entityExists,
  observe,
  onAdd,
  onRemove,
  query,
  removeComponent,
  removeEntity,
  set,
} from 'bitecs';
import { describe, expect, it } from 'vitest';
import {
  assertWorldAlive,
  ball,
  bodyState,
  DT,
  emptySpace,
  groundWorld,
  refusal,
  worldState,
} from '../support/worlds.ts';

/** Returns the exception of a step. */
function thrownBy(world: PhysicsWorld): unknown[] {
  try {
    step(world, DT);
  } catch (error) {
    return (error as AggregateError).errors;
  }
  return [];
}

describe('edits during a step', () => {
  /** Places where user code runs during a step. */
  const INSIDE: readonly [string, (world: PhysicsWorld, act: () => void) => void][] = [
    ['a system', (world, act) => world.phases.input.push(once(act))],
    ['a handler', inHandler],
    ['a force law', (world, act) => world.forces.push(defineForce({ name: 'act', accumulate: once(act) }))],
    ['a query loop in a system', (world, act) => world.phases.events.push(once(() => inLoop(world, act)))],
  ];

  function once(act: () => void): () => void {
    let done = false;
    return () => {
      if (!done) act();
      done = true;
    };
  }

  function inHandler(world: PhysicsWorld, act: () => void): void {
    on(world, 'fault', once(act));
    const eid = ball(world, 40, 1);
    world.components.Position.x[eid] = NaN;
  }

  function inLoop(world: PhysicsWorld, act: () => void): void {
    // bitECS's array is live: new bodies join it, so the loop needs an end condition.
    const loop = query(world, [world.components.Position]);
    for (let i = 0, count = loop.length; i < count; i++) act();
  }

  it.each(INSIDE)('55 a body removed in %s is removed when the step ends', (_, inside) => {
    const world = groundWorld();
    const eid = ball(world, 0, 1);
    const other = ball(world, 1, 1);
    let during: boolean | undefined;
    let told = 0;
    inside(world, () => {
      if (told++ > 0) return;
      despawn(world, eid);
      during = !isBody(world, eid) && entityExists(world, eid);
    });
    step(world, DT);
    expect(during).toBe(true);
    expect([isBody(world, eid), entityExists(world, eid), bodyState(world, eid)]).toEqual([false, false, '']);
    expect(isBody(world, other)).toBe(true);
    assertWorldAlive(world);
  });

  it.each(INSIDE)('55 a body removed raw in %s is removed when the step ends', (_, inside) => {
    const world = groundWorld();
    const eid = ball(world, 0, 1);
    ball(world, 1, 1);
    inside(world, () => removeEntity(world, eid));
    step(world, DT);
    expect([isBody(world, eid), bodyState(world, eid)]).toEqual([false, '']);
    assertWorldAlive(world);
  });

  it('55 all bodies removed in a query loop outside a step, by despawn and raw', () => {
    const world = groundWorld();
    for (let i = 0; i < 100; i++) ball(world, i, 1);
    const loop = query(world, [world.components.Position]);
    for (let i = 0; i < loop.length; i++) {
      if (i % 2 === 0) despawn(world, loop[i]);
      else removeEntity(world, loop[i]);
    }
    expect([bodies(world).count, world.lastId]).toEqual([0, 0]);
    expect(query(world, [world.components.Position])).toHaveLength(0);
    assertWorldAlive(world);
  });

  it('55 an observer can remove its body and others', () => {
    const world = groundWorld();
    const [a, b, c] = [0, 1, 2].map((x) => ball(world, x, 1));
    observe(world, onRemove(world.components.Position), (eid) => {
      if (eid === a) despawn(world, b);
    });
    observe(world, onAdd(world.components.LinearDrag), (eid) => despawn(world, eid));
    despawn(world, a);
    // bitECS itself fails if an observer removes the entity that is being added to; no trace of it remains.
    expect(() => addComponent(world, c, world.components.LinearDrag)).toThrow(TypeError);
    expect([a, b, c].map((eid) => isBody(world, eid))).toEqual([false, false, false]);
    expect(world.internal.counts.LinearDrag).toBe(0);
    assertWorldAlive(world);
  });

  it.each(INSIDE)('56 a body created in %s appears in the next step', (_, inside) => {
    const world = groundWorld();
    ball(world, 0, 5);
    let made = 0;
    let during: boolean | undefined;
    inside(world, () => {
      made = ball(world, 20, 5);
      during = isBody(world, made);
    });
    step(world, DT);
    expect(during).toBe(false);
    expect([isBody(world, made), world.components.Position.y[made]]).toEqual([true, 5]);
    step(world, DT);
    expect(world.components.Position.y[made]).toBeLessThan(5);
  });

  it('56 a body created and removed in the same step leaves no trace', () => {
    const world = groundWorld();
    ball(world, 0, 5);
    world.phases.events.push(() => despawn(world, ball(world, 20, 5)));
    const before = bodies(world).count;
    step(world, DT);
    expect([bodies(world).count, world.internal.counts.Mass]).toEqual([before, 1]);
  });

  it('56 a body removed raw whose id is reused in the same step: only the new body remains', () => {
    const world = groundWorld();
    const eid = ball(world, 0, 5, { x: 3 });
    const last = ball(world, 9, 5);
    let heir = 0;
    world.phases.input.push(() => {
      if (heir !== 0) return;
      addComponent(world, eid, set(world.components.Velocity, { x: 8 }));
      despawn(world, eid);
      removeEntity(world, eid);
      heir = spawn(world, { position: { x: 50, y: 5 } });
    });
    step(world, DT);
    expect(heir).toBe(eid);
    expect(bodyState(world, heir)).toBe('Position.x=50 Position.y=5');
    expect(isBody(world, last)).toBe(true);
  });

  it('57 a velocity set in a handler takes effect in the next step', () => {
    const world = emptySpace();
    const eid = ball(world, 0, 0, { x: 1 });
    inHandler(world, () => addComponent(world, eid, set(world.components.Velocity, { x: 5 })));
    const { Position, Velocity } = world.components;
    step(world, 0.5);
    expect([Position.x[eid], Velocity.x[eid]]).toEqual([0.5, 5]);
    step(world, 0.5);
    expect(Position.x[eid]).toBe(3);
  });

  it('57 edits of a body that is being removed leave no trace', () => {
    const world = groundWorld();
    const eid = ball(world, 0, 1);
    const last = ball(world, 1, 1);
    world.phases.input.push(() => {
      if (!isBody(world, eid)) return;
      despawn(world, eid);
      addComponent(world, eid, set(world.components.Position, { x: 3 }));
      addComponent(world, eid, set(world.components.LinearDrag, 2));
      removeComponent(world, eid, world.components.Mass);
      despawn(world, eid);
    });
    step(world, DT);
    expect([bodyState(world, eid), world.internal.counts.LinearDrag, world.lastId]).toEqual(['', 0, last]);
  });

  it('58 a nested step is refused with E_REENTRANT, also while edits take effect', () => {
    const world = groundWorld();
    const eid = ball(world, 0, 1);
    const codes: string[] = [];
    const attempt = () => codes.push(refusal(() => step(world, DT)).code);
    world.phases.input.push(attempt);
    observe(world, onRemove(world.components.Position), attempt);
    world.phases.input.push(() => isBody(world, eid) && despawn(world, eid));
    step(world, DT);
    // The observer runs at the removal by bitECS, or when the edit takes effect: during the step in both cases.
    expect(codes).toEqual(['E_REENTRANT', 'E_REENTRANT']);
    expect(world.tick).toBe(1);
    assertWorldAlive(emptied(world));
  });

  function emptied(world: PhysicsWorld): PhysicsWorld {
    world.phases.input.length = 0;
    return world;
  }

  it('59 a handler that throws: the step completes, other handlers run, and the world continues', () => {
    const world = groundWorld();
    const eid = ball(world, 0, 1);
    const heard: string[] = [];
    on(world, 'fault', () => {
      throw new Error('first');
    });
    on(world, 'fault', ({ field }) => heard.push(field));
    world.phases.events.push(() => {
      throw new Error('second');
    });
    world.components.Position.x[eid] = NaN;
    expect(thrownBy(world).map(String)).toEqual(['Error: first', 'Error: second']);
    expect(heard).toEqual(['Position.x']);
    expect([world.tick, world.state]).toEqual([1, 'idle']);
    world.phases.events.pop();
    assertWorldAlive(world);
  });

  it('59 handlers can be added and removed during dispatch', () => {
    const world = groundWorld();
    const heard: string[] = [];
    const offFirst = on(world, 'fault', () => {
      heard.push('first');
      offFirst();
      offThird();
      on(world, 'fault', () => heard.push('late'));
    });
    on(world, 'fault', () => heard.push('second'));
    const offThird = on(world, 'fault', () => heard.push('third'));
    const poison = (x: number) => {
      world.components.Position.x[ball(world, x, 1)] = NaN;
    };
    poison(0);
    step(world, DT);
    expect(heard).toEqual(['first', 'second']);
    poison(9);
    step(world, DT);
    expect(heard).toEqual(['first', 'second', 'second', 'late']);
  });

  it('59 an observer that throws leaves no partial body', () => {
    const world = groundWorld();
    const { Position, Velocity } = world.components;
    const kept = ball(world, 3, 1);
    const offAdd = observe(world, onAdd(Velocity), () => {
      throw new Error('no');
    });
    const before = worldState(world);
    expect(() => ball(world, 0, 1)).toThrow('no');
    expect(worldState(world)).toEqual(before);
    offAdd();
    observe(world, onRemove(Position), () => {
      throw new Error('stay');
    });
    observe(world, onRemove(Velocity, Position), () => {
      throw new Error('stay too');
    });
    expect(() => despawn(world, kept)).toThrow('stay');
    expect([entityExists(world, kept), bodyState(world, kept), world.internal.counts.Mass]).toEqual([false, '', 0]);
  });

  it('59 with onFault "throw" the step throws the fault as well', () => {
    const world = groundWorld({ onFault: 'throw' });
    const eid = ball(world, 0, 1);
    world.components.Velocity.y[eid] = NaN;
    expect(thrownBy(world)).toMatchObject([{ code: 'E_NONFINITE', entity: eid, field: 'Velocity.y' }]);
    expect(thrownBy(world)).toEqual([]);
    assertWorldAlive(world);
  });
});

describe('what games do in handlers', () => {
  it('63 a body that was removed through bitECS in this step cannot be pinned', () => {
    const world = groundWorld();
    const eid = ball(world, 0, 1);
    world.phases.input.push(() => {
      if (!isBody(world, eid)) return;
      removeEntity(world, eid);
      expect(refusal(() => pin(world, eid)).code).toBe('E_STALE');
    });
    step(world, DT);
    expect(isBody(world, eid)).toBe(false);
  });

  it('a bullet that touches two bodies in one step is removed by the handlers of both contacts', () => {
    const world = createPhysicsWorld({ preset: particleContacts, capacity: 10 });
    const bullet = spawn(world, { position: {}, mass: 1, collider: 0.5 });
    for (const x of [-0.9, 0.9]) spawn(world, { position: { x }, mass: 1, collider: 0.5 });
    const ref = entityRef(world, bullet);
    const alive: boolean[] = [];
    on(world, 'contact', () => {
      alive.push(isAlive(world, ref));
      despawn(world, bullet);
    });
    step(world, DT);
    expect(alive).toEqual([true, false]);
    expect([isBody(world, bullet), bodies(world).count]).toEqual([false, 2]);
  });

  it('a list that names a body six times makes a game split it once', () => {
    const world = createPhysicsWorld({ preset: particleContacts, capacity: 10 });
    const crate = spawn(world, { position: {}, velocity: {}, mass: 1 });
    world.phases.events.push(() => {
      for (const id of [crate, crate, crate, crate, crate, crate]) {
        if (!isBody(world, id)) continue;
        despawn(world, id);
        for (const x of [-1, 1]) spawn(world, { position: { x }, mass: 0.5 });
      }
    });
    step(world, DT);
    expect(bodies(world).count).toBe(2);
  });

  it('a body spawned during a step can be used only after it, and the error says so', () => {
    const world = createPhysicsWorld({ capacity: 10 });
    const made: number[] = [];
    const refusals: unknown[] = [];
    world.phases.input.push(() => {
      if (made.length > 0) return;
      made.push(spawn(world, { position: { x: 3 }, velocity: {}, mass: 1 }));
      try {
        entityRef(world, made[0]);
      } catch (error) {
        refusals.push(error);
      }
    });
    step(world, DT);
    expect(refusals).toEqual([expect.objectContaining({ code: 'E_STALE', value: made[0] })]);
    expect(String(refusals[0])).toMatch(/was spawned during this step.*Pass its values to `spawn`/s);
    expect(resolve(world, entityRef(world, made[0]))).toBe(made[0]);
  });

  it('an index into the wall contacts is given to handlers of wallContact', () => {
    const world = createPhysicsWorld({ preset: particleContacts, capacity: 10 });
    const wall = spawn(world, { segmentWall: { ax: -1, bx: 1 } });
    const ball = spawn(world, { position: { y: 0.5 }, velocity: { y: -2 }, mass: 3, collider: { radius: 0.5 } });
    const seen: number[][] = [];
    on(world, 'wallContact', (index) => {
      const list = wallContacts(world);
      seen.push([list.body[index], list.wall[index], list.ny[index], list.impulse[index]]);
    });
    step(world, DT);
    // A dead ball of 3 kg at 2 m/s gives up 6 N s.
    expect(seen).toEqual([[ball, wall, 1, 6]]);
  });
});
