/** What users can do to a world through bitECS's own functions. */
import {
  burst,
  clothWind,
  createCloth,
  createEmitter,
  createPattern,
  createPhysicsWorld,
  createSoftBody,
  energy,
  entityRef,
  isAlive,
  resolve,
  restore,
  snapshot,
  spawn,
  spawnMany,
  springs,
  stateHash,
  step,
  totalMass,
} from '@principia/physics';
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
  it('are refused, so that they cannot write to columns of that world', () => {
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

  it('and their references are refused, for each pair of twenty worlds', () => {
    const worlds = Array.from({ length: 20 }, () => createPhysicsWorld({ capacity: 1, arenaBytes: 0 }));
    const refs = worlds.map((world) => entityRef(world, spawn(world, { position: {} })));
    expect(new Set(refs).size).toBe(20);
    const [here, there] = worlds;
    expect(isAlive(there, refs[0])).toBe(false);
    assertRefused(there, () => resolve(there, refs[0]), { code: 'E_STALE' });
    expect(resolve(here, refs[0])).toBe(1);
  });

  it('53 lists of ids and objects of another world are refused: faces, ends of springs, patterns, snapshots', () => {
    const make = () => createPhysicsWorld({ dimensions: 3, capacity: 1000, forces: [springs()] });
    const [here, there] = [make(), make()];
    const cloth = { corner: {}, columns: 3, rows: 3, spacing: 0.1, mass: 1, structural: 10 };
    const [own, foreign] = [createCloth(here, cloth), createCloth(there, cloth)];
    const ids = /Ids belong to one world/;
    const springsBetween = (a: Uint32Array, b: Uint32Array) =>
      spawnMany(here, 9, { spring: { a, b, stiffness: 1, length: 1 } });
    assertRefused(here, () => springsBetween(own.nodes, foreign.nodes), { code: 'E_TYPE', hint: ids });
    const ball = createSoftBody(there, { centre: {}, radius: 1, detail: 0, mass: 1, stiffness: 1, pressure: 1 });
    for (const force of [clothWind({ triangles: foreign.triangles }), ball.gas]) {
      here.forces.push(force);
      assertRefused(here, () => step(here, DT), { code: 'E_TYPE', hint: ids });
      here.forces.pop();
    }
    const emitter = createEmitter(here, { capacity: 5 });
    const pattern = createPattern(there, [{ x: 1 }]);
    expect(refusal(() => burst(emitter, 1, { pattern })).code).toBe('E_RANGE');
    expect(() => restore(here, snapshot(there))).toThrow(/another world/);
    here.forces.push(clothWind({ triangles: own.triangles }));
    step(here, DT);
    step(there, DT);
  });

  it('a user-defined component can be in several worlds', () => {
    const tag = { value: [] as number[] };
    for (const world of [groundWorld(), groundWorld()]) {
      const eid = ball(world, 0, 1);
      addComponent(world, eid, tag);
      expect([...query(world, [tag, world.components.Position])]).toEqual([eid]);
    }
  });

  it('more components than a bitECS mask holds do not affect built-in ones', () => {
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

describe('a world that was reset or deleted by bitECS', () => {
  it.each([
    ['resetWorld', resetWorld],
    ['deleteWorld', deleteWorld],
  ])('%s: every call throws E_DESTROYED with a hint', (_, end) => {
    const world = groundWorld();
    ball(world, 0, 1);
    end(world);
    expect(refusal(() => step(world, DT))).toMatchObject({
      code: 'E_DESTROYED',
      hint: expect.stringMatching(/destroyWorld/),
    });
    expect(refusal(() => spawn(world, {})).code).toBe('E_DESTROYED');
  });

  it.each([[createWorld()], [{}], [null], [undefined], [5], ['world']])('%s is not a physics world', (world) => {
    expect(refusal(() => step(world as never, DT)).code).toBe('E_TYPE');
    expect(refusal(() => spawn(world as never, {})).code).toBe('E_TYPE');
  });
});

describe('prefabs', () => {
  it('are not bodies: they use no row, do not move and have no mass', () => {
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

  it('pass their values on to their instances', () => {
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

  it('refuse invalid values like bodies', () => {
    const world = groundWorld();
    const prefab = addPrefab(world);
    expect(refusal(() => addComponent(world, prefab, set(world.components.LinearDrag, -1))).code).toBe('E_RANGE');
    const eid = addEntity(world);
    addComponent(world, eid, IsA(prefab));
    expect(world.components.LinearDrag.coefficient[eid]).toBe(0);
  });
});

describe('invalid values', () => {
  it('remove their component, even if user observers acted in between', () => {
    const world = groundWorld();
    const { Position, Velocity } = world.components;
    const other = ball(world, 0, 1);
    observe(world, onAdd(Velocity), () => void addComponent(world, other, set(world.components.LinearDrag, 1)));
    const eid = spawn(world, { position: { y: 1 } });
    expect(refusal(() => addComponent(world, eid, set(Velocity, { x: NaN }))).code).toBe('E_NONFINITE');
    expect([hasComponent(world, eid, Velocity), world.internal.counts.Velocity]).toEqual([false, 1]);
    expect([...query(world, [Position])]).toEqual([other, eid]);
  });

  it('leave no component behind during a step either', () => {
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

describe('keys inherited from Object', () => {
  const HOSTILE = ['constructor', 'toString', 'hasOwnProperty', '__proto__', 'valueOf'];

  it.each(HOSTILE)('"%s" is not a field, component or option', (key) => {
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

describe('rows without a body', () => {
  it('can hold any values without effect, and the next body starts clean', () => {
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
