// Components of users: what is no component of this world is refused, and nothing is changed.
import {
  COMPONENTS,
  columnsOf,
  createPhysicsWorld,
  defineComponent,
  realField,
  spawn,
  wordField,
} from '@principia/physics';
import { addComponent, addEntity, hasComponent, query, set } from 'bitecs';
import { describe, expect, it } from 'vitest';

const Health = defineComponent({ fields: { points: realField('', { initial: 10, bounds: { min: 0 } }) } });

describe('a component of a user', () => {
  it('of another world is refused, as built-in ones are', () => {
    const world = createPhysicsWorld({ capacity: 4, components: [Health] });
    const others = columnsOf(createPhysicsWorld({ capacity: 4, components: [Health] }), Health);
    const id = spawn(world, { position: {} });
    expect(() => addComponent(world, id, set(others, { points: 5 }))).toThrow('belongs to another world');
    expect(hasComponent(world, id, others)).toBe(false);
    expect(hasComponent(world, id, columnsOf(world, Health))).toBe(false);
    expect(() => query(world, [others])).toThrow('belongs to another world');
  });

  it('is added by its columns: a definition is refused, and the entity does not have it afterwards', () => {
    const world = createPhysicsWorld({ capacity: 4, components: [Health] });
    const id = spawn(world, { position: {}, mass: 3 });
    expect(() => addComponent(world, id, Health)).toThrow('columnsOf(world, MyComponent)');
    expect(() => addComponent(world, id, COMPONENTS.Charge)).toThrow('world.components.Charge');
    expect(() => query(world, [COMPONENTS.Position])).toThrow('world.components.Position');
    expect(hasComponent(world, id, columnsOf(world, Health))).toBe(false);
    expect([...query(world, [world.components.Position])]).toEqual([id]);
  });

  it('is refused by an entity beyond the capacity', () => {
    const world = createPhysicsWorld({ capacity: 4, components: [Health] });
    const ids = Array.from({ length: 5 }, () => addEntity(world));
    const Points = columnsOf(world, Health);
    expect(() => addComponent(world, ids[4], set(Points, { points: 5 }))).toThrow('capacity');
    expect(hasComponent(world, ids[4], Points)).toBe(false);
  });

  it('says what is wrong with its fields', () => {
    const made = (fields: object) => () =>
      createPhysicsWorld({ capacity: 4, components: [defineComponent({ fields } as typeof Health)] });
    const options = (value: object) => () => realField('N', value);
    expect(options({ default: 3 })).toThrow('a field has no option "default"');
    expect(made({ v: realField('N', { bounds: { minimum: 0 } as object }) })).toThrow('has no bound "minimum"');
    expect(made({ v: realField('N', { initial: Number.NaN }) })).toThrow('E_NONFINITE');
    expect(made({ v: realField('N', { initial: 30, bounds: { max: 10 } }) })).toThrow('at most 10');
    expect(made({ v: wordField('', { initial: -1 }) })).toThrow('at least 0');
    expect(made({ v: 0 })).toThrow('realField or wordField');
  });

  it('has no options beside those that exist, and no scalar that is none of its fields', () => {
    const fields = { area: realField('m²') };
    expect(() => defineComponent({ fields, scalar: 'area' })).not.toThrow();
    // @ts-expect-error: no such option
    expect(() => defineComponent({ fields, scaler: 'area' })).toThrow('has no option "scaler"');
    // @ts-expect-error: no such field
    expect(() => defineComponent({ fields, scalar: 'b' })).toThrow('the component has no field "b"');
    // @ts-expect-error: no field at all
    expect(() => defineComponent({ fields: {}, scalar: 'b' })).toThrow('E_UNKNOWN');
    // @ts-expect-error: fields have names
    expect(() => defineComponent({ fields: 5 })).toThrow('E_TYPE');
    expect(() => defineComponent(undefined as never)).toThrow('E_TYPE');
  });

  it('is none of those that every world has', () => {
    expect(() => createPhysicsWorld({ capacity: 4, components: [COMPONENTS.Mass] })).toThrow('world.components.Mass');
    expect(() => columnsOf(createPhysicsWorld({ capacity: 4 }), COMPONENTS.Mass)).toThrow('world.components.Mass');
  });
});
