// What a column holds is accepted where values are given: a level that was read from columns can be spawned again.
import {
  box,
  COMPONENT_NAMES,
  COMPONENTS,
  type ComponentName,
  columnsOf,
  createJoint,
  createPhysicsWorld,
  defineComponent,
  type FieldSpec,
  on,
  type PhysicsWorld,
  type Precision,
  realField,
  revolute,
  rigidBodies,
  spawn,
  spawnMany,
  step,
} from '@principia/physics';
import { addComponent, addEntity, set } from 'bitecs';
import { describe, expect, test } from 'vitest';

type Values = Record<string, number>;
type Columns = Readonly<Record<string, ArrayLike<number>>>;

const PRECISIONS: readonly Precision[] = ['f32', 'f64'];

const worldOf = (precision: Precision) =>
  createPhysicsWorld({ preset: rigidBodies, precision, capacity: 1000, onWarning: () => {} });

/** The bounds of a field, and its default. */
function extremesOf({ bounds, initial, kind }: FieldSpec): number[] {
  const { min, max, above } = bounds;
  const least = above === undefined || min !== undefined ? min : above + (kind === 'real' ? 1e-30 : 1);
  return [least, max, initial].filter((value) => value !== undefined);
}

/** Other fields that the component needs in order to take the value. */
function othersOf(name: ComponentName, field: string, value: number, bodies: readonly number[]): Values {
  if (name === 'Joint' || name === 'Spring') {
    const [a, b] = bodies;
    return { a, b, ...(field === 'lower' && { upper: value }), ...(field === 'upper' && { lower: value }) };
  }
  if (name === 'Attachment') return { body: bodies[0] };
  if (name === 'InertiaTensor') return { x: value, y: value, z: value };
  return {};
}

/** Sets a component on a new entity and returns its row. */
function setOnNew(world: PhysicsWorld, name: ComponentName, values: Values): Values {
  const columns = world.components[name] as unknown as Columns;
  const id = addEntity(world);
  addComponent(world, id, set(columns as never, values as never));
  return Object.fromEntries(Object.keys(values).map((field) => [field, columns[field][id]]));
}

const isReference = ({ generationField }: FieldSpec) => generationField !== undefined;

/** All fields but ids. */
const FIELDS = COMPONENT_NAMES.flatMap((name) =>
  Object.entries<FieldSpec>(COMPONENTS[name].fields)
    .filter(([, spec]) => !isReference(spec))
    .map(([field, spec]) => [name, field, spec] as const),
);

describe.each(PRECISIONS)('%s', (precision) => {
  test('every field of every component takes back its least, greatest and default value', () => {
    const worlds = { 2: worldOf(precision), 3: createPhysicsWorld({ dimensions: 3, precision, capacity: 1000 }) };
    for (const world of Object.values(worlds)) for (const x of [0, 1]) spawn(world, { position: { x }, collider: 0.1 });
    const bodies = [1, 2] as const;
    for (const [name, field, spec] of FIELDS) {
      const world = worlds[spec.spatial === true ? 3 : 2];
      for (const value of extremesOf(spec)) {
        const others = othersOf(name, field, value, bodies);
        const stored = setOnNew(world, name, { ...others, [field]: value });
        expect(() => setOnNew(world, name, stored), `${name}.${field} = ${value}`).not.toThrow();
      }
    }
  });

  test('a joint is spawned again from its columns', () => {
    const world = worldOf(precision);
    const [a, b] = [0, 1].map((x) => spawn(world, { position: { x }, collider: { shape: box(1, 1), density: 1 } }));
    const joint = createJoint(world, revolute({ a, b, anchor: {} }));
    const { started, aGeneration, bGeneration, ...columns } = Object.fromEntries(
      Object.entries(world.components.Joint).map(([field, column]) => [field, column[joint]]),
    );
    const copy = spawn(world, { joint: columns as never });
    expect(world.components.Joint.maxForce[copy]).toBe(world.components.Joint.maxForce[joint]);
  });

  test('a bad value in one row is no fault of rows that hold a bound', () => {
    const world = worldOf(precision);
    const bodies = [0, 1, 2].map((x) =>
      spawn(world, { position: { x }, collider: { shape: box(0.2, 0.2), density: 1 } }),
    );
    const joints = [0, 1].map((i) =>
      createJoint(world, revolute({ a: bodies[i], b: bodies[i + 1], anchor: { x: i } })),
    );
    const faults: unknown[] = [];
    on(world, 'fault', ({ entity }) => void faults.push(entity));
    world.components.Joint.maxForce[joints[1]] = -1;
    for (let i = 0; i < 128; i++) step(world, 1 / 60);
    expect(faults).toEqual([joints[1]]);
  });

  test('a component of one’s own, and many bodies at once, take back what they hold', () => {
    const Own = defineComponent({ fields: { share: realField('', { initial: 0.2, bounds: { min: 0.1, max: 0.3 } }) } });
    const world = createPhysicsWorld({ precision, capacity: 10, components: [Own] });
    const { share } = columnsOf(world, Own);
    const [first, second] = spawnMany(world, 2, { position: { x: [0, 1] }, mass: 1e-37 });
    addComponent(world, first, set(columnsOf(world, Own), { share: 0.3 }));
    addComponent(world, second, set(columnsOf(world, Own), { share: share[first] }));
    expect(share[second]).toBe(share[first]);
    const mass = world.components.Mass.value[first];
    const [third] = spawnMany(world, 1, { position: {}, mass: [mass] });
    expect(world.components.Mass.value[third]).toBe(mass);
    expect(() => addComponent(world, second, set(columnsOf(world, Own), { share: 0.3001 }))).toThrow(/at most 0.3/);
  });
});

test('a number that a column of f32 would hold as 0 is refused where 0 is', () => {
  const moment = { inertiaTensor: { x: 1e-46, y: 1e-46, z: 1e-46 } };
  const bodyIn = (precision: Precision) => () => spawn(createPhysicsWorld({ dimensions: 3, precision }), moment);
  expect(bodyIn('f32')).toThrow(/greater than 0 as a number of f32/);
  expect(bodyIn('f64')).not.toThrow();
});
