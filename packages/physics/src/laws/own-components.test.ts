import { addComponent, addEntity, addPrefab, hasComponent, IsA, removeComponent, removeEntity, set } from 'bitecs';
import { describe, expect, test } from 'vitest';
import {
  COMPONENTS,
  columnsOf,
  createPhysicsWorld,
  defineComponent,
  defineLaw,
  despawn,
  PhysicsError,
  realField,
  restore,
  select,
  snapshot,
  spawn,
  step,
  vec3,
  type Warning,
} from '../index.ts';

const Glow = defineComponent({ fields: { strength: realField('N', { bounds: { min: 0 } }), tilt: realField('') } });

const radiate = defineLaw({
  name: 'radiation',
  reads: { glow: Glow },
  force: ({ velocity, glow }) => velocity.mul(glow.strength.add(glow.tilt)),
});

function worldWithGlow(precision: 'f32' | 'f64' = 'f64') {
  const world = createPhysicsWorld({ precision, capacity: 100, components: [Glow], forces: [radiate()] });
  return { world, glow: columnsOf(world, Glow) };
}

describe('a custom component', () => {
  test.each(['f32', 'f64'] as const)(
    'is inherited from a prefab with its values, as built-in ones are, %s',
    (precision) => {
      const { world, glow } = worldWithGlow(precision);
      const { Position, Velocity, Mass } = world.components;
      const prefab = addPrefab(world);
      for (const each of [set(Position, { x: 4 }), set(Velocity, { x: 1 }), set(Mass, { value: 3 })]) {
        addComponent(world, prefab, each);
      }
      addComponent(world, prefab, set(glow, { strength: 9 }));
      const [same, own] = [addEntity(world), addEntity(world)];
      addComponent(world, same, IsA(prefab));
      addComponent(world, own, IsA(prefab));
      addComponent(world, own, set(glow, { strength: 2 }));
      expect([Mass.value[same], glow.strength[same], glow.strength[own]]).toEqual([3, 9, 2]);
      // v' = k v / m with k = 9 and m = 3, so v grows by e^(0.003) in a step of 1 ms, of which a step of second order misses 5e-9 and f32 6e-8.
      step(world, 1e-3);
      expect(Math.abs(Velocity.x[same] - Math.exp(3e-3))).toBeLessThan(1e-6);
    },
  );

  test.each(['f32', 'f64'] as const)('drives a law, %s: v′ = k v grows as e^(k t)', (precision) => {
    const { world, glow } = worldWithGlow(precision);
    const [bright, dark] = [1, 2].map(() => spawn(world, { position: {}, velocity: { x: 1 }, mass: 1 }));
    addComponent(world, bright, set(glow, { strength: 0.25 }));
    glow.tilt[bright] = 0.25;
    for (let i = 0; i < 100; i++) step(world, 0.01);
    // Velocity Verlet has a relative error of (k dt)²/6 per unit of k t.
    expect(world.components.Velocity.x[bright]).toBeCloseTo(Math.exp(0.5), 5);
    expect(world.components.Velocity.x[dark]).toBe(1);
  });

  test('is zero for bodies that lost it, and is restored by a snapshot', () => {
    const { world, glow } = worldWithGlow();
    const eid = spawn(world, { position: {}, velocity: { x: 1 }, mass: 1 });
    addComponent(world, eid, set(glow, { strength: 2 }));
    const before = snapshot(world);
    removeComponent(world, eid, glow);
    expect(glow.strength[eid]).toBe(0);
    restore(world, before);
    expect([glow.strength[eid], hasComponent(world, eid, glow)]).toEqual([2, true]);
    despawn(world, eid);
    expect(glow.strength[eid]).toBe(0);
    expect(hasComponent(world, spawn(world, { position: {} }), glow)).toBe(false);
  });

  test('is validated, and must be one of the components of the world', () => {
    const { world, glow } = worldWithGlow();
    const eid = spawn(world, { position: {} });
    expect(() => addComponent(world, eid, set(glow, { strength: -1 }))).toThrow(PhysicsError);
    expect(() => addComponent(world, eid, set(glow, { brightness: 1 } as never))).toThrow(/no field "brightness"/);
    expect(() => addComponent(world, eid, set(Glow, { strength: 1 }))).toThrow(/columnsOf\(world, MyComponent\)/);
    expect(() => addComponent(world, spawn(world, { position: {} }), Glow)).toThrow(PhysicsError);
    const other = createPhysicsWorld({ forces: [radiate()] });
    expect(() => columnsOf(other, Glow)).toThrow(/components: \[MyComponent\]/);
    expect(() => step(other, 0.01)).toThrow(/was created without the component/);
    expect(other.tick).toBe(0);
    expect(() => createPhysicsWorld({ components: [{} as never] })).toThrow(/components\[0\] must be a component/);
  });
});

const Windy = defineComponent({ fields: { f: realField('', { initial: 3 }) } });
const Marked = defineComponent({ fields: {} });

const wind = defineLaw({
  name: 'wind',
  acceleration: ({ has }) => vec3(select(has(Windy), 1, 0), select(has(Windy).and(has(Marked)), 2, 0)),
});

/** A world where `has` asks for two components, of which one is without fields, and as many bodies of 1 kg as asked for. */
function windyWorld(count: number) {
  const world = createPhysicsWorld({ capacity: 10, components: [Windy, Marked], forces: [wind()] });
  const ids = Array.from({ length: count }, () => spawn(world, { position: {}, velocity: {}, mass: 1 }));
  return { world, ids, windy: columnsOf(world, Windy), marked: columnsOf(world, Marked) };
}

describe('has(component) of a custom component', () => {
  test('holds for bodies that have it, whatever its values: 1 m/s² for half a second is 0.5 m/s', () => {
    const { world, ids, windy, marked } = windyWorld(4);
    const [none, one, both, lost] = ids;
    addComponent(world, one, set(windy, { f: 0 }));
    for (const id of [both, lost]) for (const columns of [windy, marked]) addComponent(world, id, columns);
    removeComponent(world, lost, windy);
    expect([windy.f[one], windy.f[both]]).toEqual([0, 3]);
    step(world, 0.5);
    const { x, y } = world.components.Velocity;
    expect([none, one, both, lost].map((id) => [x[id], y[id]])).toEqual([
      [0, 0],
      [0.5, 0],
      [0.5, 1],
      [0, 0],
    ]);
  });

  test('ends with the body, whose row is clean for the next one', () => {
    const { world, ids, windy } = windyWorld(1);
    addComponent(world, ids[0], windy);
    for (const name of ['Position', 'Velocity', 'Mass'] as const)
      removeComponent(world, ids[0], world.components[name]);
    expect(world.lastId).toBe(0);
    removeEntity(world, ids[0]);
    const next = spawn(world, { position: {}, velocity: {}, mass: 1 });
    step(world, 0.5);
    expect([next, world.components.Velocity.x[next]]).toEqual([ids[0], 0]);
  });

  test('is restored by a snapshot, also for a body that was removed', () => {
    const { world, ids, windy, marked } = windyWorld(3);
    addComponent(world, ids[0], windy);
    addComponent(world, ids[1], set(windy, { f: 7 }));
    const before = snapshot(world);
    removeComponent(world, ids[0], windy);
    despawn(world, ids[1]);
    addComponent(world, ids[2], marked);
    restore(world, before);
    expect(ids.map((id) => hasComponent(world, id, windy))).toEqual([true, true, false]);
    expect([hasComponent(world, ids[2], marked), windy.f[ids[1]]]).toEqual([false, 7]);
    step(world, 0.5);
    expect(ids.map((id) => world.components.Velocity.x[id])).toEqual([0.5, 0.5, 0]);
  });

  test('is not the same for two components, though laws of equal structure share their code', () => {
    const pushed = [Windy, Marked].map((component) =>
      defineLaw({ name: 'push', acceleration: ({ has }) => select(has(component), vec3(1, 0), vec3(0, 0)) })(),
    );
    const speeds = pushed.map((force) => {
      const { world, ids, marked } = windyWorld(1);
      world.forces.splice(0, 1, force);
      addComponent(world, ids[0], marked);
      step(world, 1);
      return world.components.Velocity.x[ids[0]];
    });
    expect(speeds).toEqual([0, 1]);
  });

  test('needs a world that was created with it, and a place among the first 31', () => {
    const bare = createPhysicsWorld({ capacity: 4, forces: [wind()] });
    spawn(bare, { position: {}, velocity: {}, mass: 1 });
    expect(() => step(bare, 0.1)).toThrow(/created without the component \{f\}.*components: \[MyComponent\]/);
    const others = Array.from({ length: 31 }, () => defineComponent({ fields: {} }));
    const full = createPhysicsWorld({ capacity: 4, components: [...others, Windy, Marked], forces: [wind()] });
    spawn(full, { position: {}, velocity: {}, mass: 1 });
    expect(() => step(full, 0.1)).toThrow(/E_RANGE.*list it among the first 31\./);
  });

  test('counts as reading: a built-in component that a law asks for has an effect', () => {
    const law = defineLaw({
      name: 'charged',
      acceleration: ({ has }) => select(has(COMPONENTS.Charge), vec3(1, 0), vec3(0, 0)),
    })();
    expect(law.reads).toContain('Charge');
    const onWarning = (warning: Warning) => warnings.push(warning.message);
    const warnings: string[] = [];
    const world = createPhysicsWorld({ capacity: 4, forces: [law], onWarning });
    spawn(world, { position: {}, velocity: {}, mass: 1, charge: 1 });
    step(world, 0.1);
    expect(warnings).toEqual([]);
  });
});
