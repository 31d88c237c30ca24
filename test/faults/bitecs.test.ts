/** What else can be done to a world through bitECS's own functions. */
import { createPhysicsWorld, energy, spawn, stateHash, step, totalMass } from '@principia/physics';
import {
  addComponent,
  addEntity,
  addPrefab,
  createWorld,
  deleteWorld,
  hasComponent,
  IsA,
  observe,
  onAdd,
  query,
  resetWorld,
  set,
} from 'bitecs';
import { describe, expect, it } from 'vitest';
import {
  assertRefused,
  assertWorldAlive,
  ball,
  bodyState,
  DT,
  groundWorld,
  refusal,
  steps,
} from '../support/worlds.ts';

describe('components of another world', () => {
  it('are refused, so that nobody writes columns over there', () => {
    const [here, there] = [groundWorld(), groundWorld()];
    const other = ball(there, 0, 1);
    const eid = ball(here, 0, 1);
    const { Position } = there.components;
    const expected = { code: 'E_TYPE', field: 'Position', hint: /world\.components/ };
    assertRefused(here, () => addComponent(here, eid, set(Position, { x: 5 })), expected);
    assertRefused(here, () => addComponent(here, eid, Position), expected);
    assertRefused(here, () => query(here, [Position]), expected);
    expect(there.components.Position.x[other]).toBe(0);
    assertWorldAlive(here);
    assertWorldAlive(there);
  });

  it('a component of your own may be in as many worlds as you like', () => {
    const tag = { value: [] as number[] };
    for (const world of [groundWorld(), groundWorld()]) {
      const eid = ball(world, 0, 1);
      addComponent(world, eid, tag);
      expect([...query(world, [tag, world.components.Position])]).toEqual([eid]);
    }
  });

  it('more components than one of bitECS’s masks holds do not disturb ours', () => {
    const world = groundWorld();
    const tags = Array.from({ length: 70 }, () => ({}));
    const eid = addEntity(world);
    for (const tag of tags) addComponent(world, eid, tag);
    addComponent(world, eid, set(world.components.Position, { x: 3 }));
    expect(bodyState(world, eid)).toBe('Position.x=3');
    expect([...query(world, [tags[69], world.components.Position])]).toEqual([eid]);
    assertWorldAlive(world);
  });
});

describe('a world that bitECS was told to reset or delete', () => {
  it.each([
    ['resetWorld', resetWorld],
    ['deleteWorld', deleteWorld],
  ])('%s: every call says E_DESTROYED and how to do it', (_, end) => {
    const world = groundWorld();
    ball(world, 0, 1);
    end(world);
    expect(refusal(() => step(world, DT))).toMatchObject({
      code: 'E_DESTROYED',
      hint: expect.stringMatching(/destroyWorld/),
    });
    expect(refusal(() => spawn(world, {})).code).toBe('E_DESTROYED');
  });

  it.each([[createWorld()], [{}], [null], [undefined], [5], ['world']])('%s is no physics world', (world) => {
    expect(refusal(() => step(world as never, DT)).code).toBe('E_TYPE');
    expect(refusal(() => spawn(world as never, {})).code).toBe('E_TYPE');
  });
});

describe('prefabs', () => {
  it('are no bodies: they fill no row, move nothing and weigh nothing', () => {
    const world = groundWorld();
    const prefab = addPrefab(world);
    const { Position, Velocity, Mass } = world.components;
    addComponent(world, prefab, set(Position, { x: 1, y: 9 }));
    addComponent(world, prefab, set(Velocity, { x: 5 }));
    addComponent(world, prefab, set(Mass, 50));
    const eid = ball(world, 0, 1); // in the same block of rows
    steps(world, 5);
    expect(bodyState(world, prefab)).toBe('');
    expect([totalMass(world), world.internal.counts.Mass]).toEqual([1, 1]);
    expect(hasComponent(world, eid, Mass)).toBe(true);
    assertWorldAlive(world);
  });

  it('hand their values on to what is an instance of them', () => {
    const world = groundWorld();
    const prefab = addPrefab(world);
    const { Position, Mass, Collider } = world.components;
    addComponent(world, prefab, set(Position, { x: 1, y: 9 }));
    addComponent(world, prefab, set(Position, { y: 8 }));
    addComponent(world, prefab, set(Mass, Infinity));
    addComponent(world, prefab, Collider);
    const eid = addEntity(world);
    addComponent(world, eid, IsA(prefab));
    expect(bodyState(world, eid)).toBe(
      'Position.x=1 Position.y=8 Collider.radius=0.5 Collider.layers=1 Collider.mask=4294967295',
    );
    expect(world.internal.counts.Mass).toBe(1);
    step(world, DT);
    expect(world.components.Position.y[eid]).toBe(8); // infinite mass stays put
  });

  it('refuse bad values like bodies do', () => {
    const world = groundWorld();
    const prefab = addPrefab(world);
    expect(refusal(() => addComponent(world, prefab, set(world.components.LinearDrag, -1))).code).toBe('E_RANGE');
    const eid = addEntity(world);
    addComponent(world, eid, IsA(prefab));
    expect(world.components.LinearDrag.coefficient[eid]).toBe(0);
  });
});

describe('refused values', () => {
  it('take the component they came with, also when observers of the user did something in between', () => {
    const world = groundWorld();
    const { Position, Velocity } = world.components;
    const other = ball(world, 0, 1);
    observe(world, onAdd(Velocity), () => void addComponent(world, other, set(world.components.LinearDrag, 1)));
    const eid = spawn(world, { position: { y: 1 } });
    expect(refusal(() => addComponent(world, eid, set(Velocity, { x: NaN }))).code).toBe('E_NONFINITE');
    expect([hasComponent(world, eid, Velocity), world.internal.counts.Velocity]).toEqual([false, 1]);
    expect([...query(world, [Position])]).toEqual([other, eid]);
  });

  it('inside a step leave no component behind either', () => {
    const world = groundWorld();
    const eid = spawn(world, { position: { y: 1 } });
    const { Velocity } = world.components;
    world.phases.input.push(() => addComponent(world, eid, set(Velocity, { x: NaN })));
    expect(() => step(world, DT)).toThrow(/E_NONFINITE/);
    expect([hasComponent(world, eid, Velocity), world.internal.counts.Velocity]).toEqual([false, 0]);
    world.phases.input.pop();
    assertWorldAlive(world);
  });
});

describe('keys that every object has', () => {
  const HOSTILE = ['constructor', 'toString', 'hasOwnProperty', '__proto__', 'valueOf'];

  it.each(HOSTILE)('"%s" is no field, no component and no option', (key) => {
    const world = groundWorld();
    const eid = ball(world, 0, 1);
    const object = JSON.parse(`{ "${key}": 5 }`);
    const unknown = { code: 'E_UNKNOWN' };
    assertRefused(world, () => spawn(world, { position: object }), unknown);
    assertRefused(world, () => spawn(world, object), unknown);
    assertRefused(world, () => addComponent(world, eid, set(world.components.Mass, object)), unknown);
    expect(refusal(() => createPhysicsWorld(object)).code).toBe('E_UNKNOWN');
    expect(Object.hasOwn(Object, eid)).toBe(false);
    expect(({} as Record<string, unknown>).x).toBeUndefined();
  });
});

describe('columns of rows that nobody has', () => {
  it('row 0 and rows of no body may hold anything: no body notices, and the next tenant starts clean', () => {
    const world = groundWorld();
    const control = groundWorld();
    const [eid, same] = [world, control].map((w) => ball(w, 0, 1, { x: 1 }));
    const { Position, Velocity, Mass } = world.components;
    for (const row of [0, 5, 9]) {
      Position.x[row] = NaN;
      Velocity.y[row] = Infinity;
      Mass.value[row] = -3;
    }
    steps(world, 30);
    steps(control, 30);
    expect(bodyState(world, eid)).toBe(bodyState(control, same));
    expect(world.faults.faults).toEqual([]);
    for (let i = 0; i < 9; i++) spawn(world, { position: {} });
    expect(energy(world).kinetic).toBe(energy(control).kinetic);
    expect(stateHash(world)).toMatch(/^[0-9a-f]{16}$/);
  });
});
