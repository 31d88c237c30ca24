// What a law may read of the body it acts on.
import { bitOf, COMPONENTS, type ComponentName } from '../components/all.ts';
import type { ComponentSpec, FieldSpec } from '../components/define.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { checkWhole, isRecord, mustBe, unknownName } from '../errors/validate.ts';
import { Condition, Scalar, type ScalarInput, scalarOf, Vector, vec3, vectorOf } from './expression.ts';

/** Where a column of a component is read. */
export interface ColumnData {
  /** A component of every world by its name, one of a user's own as it was defined. */
  readonly component: ComponentName | ComponentSpec;
  readonly field: string;
  readonly spec: FieldSpec;
}

/** Symbols that every law has. */
export interface BodySymbols {
  /** Centre of mass, m. */
  readonly position: Vector;
  /** m/s. */
  readonly velocity: Vector;
  /** Velocity when the step began, m/s: the same in every stage of an integrator. */
  readonly startVelocity: Vector;
  /** kg; zero of a body that forces do not move. */
  readonly mass: Scalar;
  /** rad/s; in two dimensions z alone. */
  readonly angularVelocity: Vector;
  /** The sum of all forces before this law, N: for laws that answer other forces. */
  readonly force: Vector;
  /** The acceleration that those forces give the body, m/s²; zero of a body that forces do not move. */
  readonly acceleration: Vector;
  /** Simulated time at which the force is evaluated, s. */
  readonly time: Scalar;
  /** Length of the step, s. */
  readonly dt: Scalar;
  /** Id of the entity. */
  readonly entity: Scalar;
  /** A vector of the body's own frame in world axes. */
  rotate(vector: Vector): Vector;
  /** Whether the entity has a component. */
  has(component: ComponentSpec): Condition;
  /** Normal noise of variance 1, drawn anew each step and the same in every stage of it; independent for each channel. */
  noise(seed: ScalarInput, channel: number): Scalar;
}

type IsUnion<T, U = T> = T extends U ? ([U] extends [T] ? false : true) : never;

/** A component as symbols: a vector of x, y and z, the one field that there is, or a record of its fields. */
export type ReadSymbol<Spec> = Spec extends { readonly fields: infer Fields }
  ? keyof Fields extends 'x' | 'y' | 'z'
    ? Vector
    : IsUnion<keyof Fields> extends true
      ? { readonly [Field in keyof Fields]: Scalar }
      : Scalar
  : never;

export type Reads = Readonly<Record<string, ComponentSpec>>;
export type ReadSymbols<R> = { readonly [Key in keyof R]: ReadSymbol<R[Key]> };

/** Largest number of a channel of noise. */
const MAX_CHANNEL = 2 ** 31 - 1;

const STATE = ['position', 'velocity', 'startVelocity', 'angularVelocity', 'force', 'acceleration'] as const;

/** The symbols a law gets: those of every body, and the components it said that it reads. */
export function bodySymbols(law: string, reads: Reads): BodySymbols & Readonly<Record<string, unknown>> {
  const symbols: Record<string, unknown> = {
    mass: columnOf('Mass', 'value'),
    time: new Scalar('time', []),
    dt: new Scalar('dt', []),
    entity: new Scalar('entity', []),
    rotate: (vector: Vector) => new Vector('rotate', [vectorOf(vector, 'rotate')]),
    has: (component: ComponentSpec) => new Condition('has', [], bitOf(nameOf(component, law))),
    noise: (seed: ScalarInput, channel: number) =>
      new Scalar('noise', [scalarOf(seed, 'noise')], checkWhole(channel, 'noise: channel', 0, MAX_CHANNEL)),
  };
  for (const name of STATE) symbols[name] = new Vector(name, []);
  for (const key of Object.keys(reads)) {
    if (key in symbols) {
      throw new PhysicsError('E_RANGE', `${law} reads a component as "${key}", which every law has already.`, {
        field: key,
        hint: 'Give it another name.',
      });
    }
    symbols[key] = componentSymbol(knownComponent(reads[key], law));
  }
  return refuseUnknown(symbols, law) as unknown as BodySymbols & Readonly<Record<string, unknown>>;
}

/** A misspelt name is an error that lists what there is, not `undefined`. */
export function refuseUnknown(symbols: Record<string, unknown>, what: string): Record<string, unknown> {
  return new Proxy(symbols, {
    get(target, key) {
      if (typeof key === 'symbol' || Object.hasOwn(target, key)) return Reflect.get(target, key);
      throw unknownName(what, 'symbol', key, Object.keys(target));
    },
  });
}

function componentSymbol(component: ComponentName | ComponentSpec): unknown {
  const fields = Object.keys(specOf(component).fields);
  if (fields.every((field) => 'xyz'.includes(field))) {
    const [x, y, z] = (['x', 'y', 'z'] as const).map((field) =>
      fields.includes(field) ? columnOf(component, field) : 0,
    );
    return vec3(x, y, z);
  }
  if (fields.length === 1) return columnOf(component, fields[0]);
  const record = Object.fromEntries(fields.map((field) => [field, columnOf(component, field)]));
  return refuseUnknown(record, typeof component === 'string' ? component : 'the component');
}

/** The symbol of one field of a component. */
export function columnOf(component: ComponentName | ComponentSpec, field: string): Scalar {
  const spec = specOf(component).fields[field];
  return new Scalar('column', [], { component, field, spec } satisfies ColumnData);
}

function specOf(component: ComponentName | ComponentSpec): ComponentSpec {
  return typeof component === 'string' ? COMPONENTS[component] : component;
}

/** @throws PhysicsError E_TYPE for what is no component */
function knownComponent(component: ComponentSpec, law: string): ComponentName | ComponentSpec {
  const isOwn = isRecord(component) && isRecord(component.fields);
  return componentName(component) ?? (isOwn ? component : nameOf(component, law));
}

/** @throws PhysicsError E_TYPE for what is no component of every world */
function nameOf(component: ComponentSpec, law: string): ComponentName {
  const name = componentName(component);
  if (name !== undefined) return name;
  throw mustBe(
    'a component, such as QuadraticDrag',
    component,
    `${law}.reads`,
    isRecord(component) ? 'E_UNKNOWN' : 'E_TYPE',
  );
}

/** The name of a component of every world. */
export function componentName(component: ComponentSpec): ComponentName | undefined {
  return (Object.keys(COMPONENTS) as ComponentName[]).find((name) => COMPONENTS[name] === component);
}
