import { addComponent, hasComponent, removeComponent, set } from 'bitecs';
import { describe, expect, test } from 'vitest';
import {
  columnsOf,
  createPhysicsWorld,
  defineComponent,
  defineLaw,
  despawn,
  PhysicsError,
  realField,
  restore,
  snapshot,
  spawn,
  step,
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
    expect(glow.strength[eid]).toBe(2);
    addComponent(world, eid, glow);
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
