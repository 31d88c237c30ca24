// The symbols of the body on which a law acts.
import { COMPONENTS, type ComponentName } from '../components/all.ts';
import { type ComponentSpec, type FieldSpec, isComponent } from '../components/define.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { checkWhole, isRecord, mustBe, unknownName } from '../errors/validate.ts';
import { Condition, Scalar, type ScalarInput, scalarOf, Vector, vec3, vectorOf } from './expression.ts';

/** Identifies a column of a component. */
export interface ColumnData {
  /** A built-in component by its name, a custom one by its definition. */
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
  /** Velocity at the start of the step, m/s: equal in every stage of an integrator. */
  readonly startVelocity: Vector;
  /** Mass, kg; zero for a body that forces do not move. */
  readonly mass: Scalar;
  /** Angular velocity, rad/s; in 2D only z. */
  readonly angularVelocity: Vector;
  /** The sum of all forces before this law, N: for laws that depend on other forces. */
  readonly force: Vector;
  /** The acceleration by those forces, m/s²; zero for a body that forces do not move. */
  readonly acceleration: Vector;
  /** Simulated time at which the force is evaluated, s. */
  readonly time: Scalar;
  /** Length of the step, s; of the whole one where an impact on a wall divides it. */
  readonly dt: Scalar;
  /** Id of the entity. */
  readonly entity: Scalar;
  /** Rotates a vector from the body's frame to world axes. */
  rotate(vector: Vector): Vector;
  /** True if the entity has the component: one of `COMPONENTS`, or one of your own that the world was created with. */
  has(component: ComponentSpec): Condition;
  /**
   * Normal noise of variance 1, drawn once per step and equal in every stage; independent for each channel.
   * @param seed whole number from 0 to 2³² - 1; what a symbol has beyond that counts as the nearest of these, and is cut to whole
   */
  noise(seed: ScalarInput, channel: number): Scalar;
}

type IsUnion<T, U = T> = T extends U ? ([U] extends [T] ? false : true) : never;

/** A component as symbols: a vector for x, y and z, a scalar for a single field, otherwise a record of its fields. */
export type ReadSymbol<Spec> = Spec extends { readonly fields: infer Fields }
  ? keyof Fields extends 'x' | 'y' | 'z'
    ? Vector
    : IsUnion<keyof Fields> extends true
      ? { readonly [Field in keyof Fields]: Scalar }
      : Scalar
  : never;

/** The components that a law reads, by names of your choice. */
export type Reads = Readonly<Record<string, ComponentSpec>>;
/** The symbols of the components that a law reads, by the names it gave them. */
export type ReadSymbols<R> = { readonly [Key in keyof R]: ReadSymbol<R[Key]> };

/** Largest index of a noise channel. */
const MAX_CHANNEL = 2 ** 31 - 1;

/** Largest seed of noise. */
const MAX_SEED = 2 ** 32 - 1;

const STATE = ['position', 'velocity', 'startVelocity', 'angularVelocity', 'force', 'acceleration'] as const;

/** Creates the symbols of a law: those of every body, and the components that it declares to read. */
export function bodySymbols(law: string, reads: Reads): BodySymbols & Readonly<Record<string, unknown>> {
  const symbols: Record<string, unknown> = {
    mass: columnOf('Mass', 'value'),
    time: new Scalar('time', []),
    dt: new Scalar('dt', []),
    entity: new Scalar('entity', []),
    rotate: (vector: Vector) => new Vector('rotate', [vectorOf(vector, 'rotate')]),
    has: (component: ComponentSpec) => new Condition('has', [], knownComponent(component, 'has(component)')),
    noise: (seed: ScalarInput, channel: number) => {
      const given = scalarOf(seed, 'noise');
      if (given.op === 'constant') checkWhole(given.data, 'noise: seed', 0, MAX_SEED);
      return new Scalar('noise', [given], checkWhole(channel, 'noise: channel', 0, MAX_CHANNEL));
    },
  };
  for (const name of STATE) symbols[name] = new Vector(name, []);
  for (const key of Object.keys(reads)) {
    if (key in symbols) {
      throw new PhysicsError(
        'E_RANGE',
        `${law} reads a component as "${key}", the name of a symbol that every law has.`,
        {
          field: key,
          hint: 'Choose another name.',
        },
      );
    }
    symbols[key] = componentSymbol(knownComponent(reads[key], `${law}.reads`));
  }
  return rejectUnknown(symbols, law) as unknown as BodySymbols & Readonly<Record<string, unknown>>;
}

/** Makes access to an unknown name an error that lists the valid names, instead of `undefined`. */
export function rejectUnknown(symbols: Record<string, unknown>, what: string): Record<string, unknown> {
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
  return rejectUnknown(record, typeof component === 'string' ? component : 'the component');
}

/** Creates the symbol of one field of a component. */
export function columnOf(component: ComponentName | ComponentSpec, field: string): Scalar {
  const spec = specOf(component).fields[field];
  return new Scalar('column', [], { component, field, spec } satisfies ColumnData);
}

function specOf(component: ComponentName | ComponentSpec): ComponentSpec {
  return typeof component === 'string' ? COMPONENTS[component] : component;
}

/**
 * @throws PhysicsError E_TYPE if the argument is not a component
 */
function knownComponent(component: ComponentSpec, field: string): ComponentName | ComponentSpec {
  const known = componentName(component) ?? (isComponent(component) ? component : undefined);
  if (known !== undefined) return known;
  const expected = 'a component, such as COMPONENTS.QuadraticDrag or one made by defineComponent';
  const isName = typeof component === 'string' && Object.hasOwn(COMPONENTS, component);
  const hint = isName ? `Import COMPONENTS and write COMPONENTS.${component}.` : undefined;
  throw mustBe(expected, component, field, isRecord(component) ? 'E_UNKNOWN' : 'E_TYPE', undefined, hint);
}

/** Returns the name of a built-in component. */
export function componentName(component: ComponentSpec): ComponentName | undefined {
  return (Object.keys(COMPONENTS) as ComponentName[]).find((name) => COMPONENTS[name] === component);
}
