// The value of a law for one body, computed from its expressions as they were written: slow, and exact enough to compare a
// force with the gradient of a potential.
import { atan2, cos, exp, log, pow, sin } from '../math/elementary.ts';
import type { Law, Parameter, PhysicsWorld } from '../world/types.ts';

/** An expression: those of laws have these fields. */
type Tree = NonNullable<Law['force'] | Law['potential']>;

type Triple = readonly [number, number, number];
type Value = number | boolean | Triple;

/** The body, at a place where it is not, and the parameters of its law. */
export interface Place {
  readonly world: PhysicsWorld;
  readonly id: number;
  readonly position: Triple;
  readonly parameters: ReadonlyMap<Parameter, Triple>;
}

/** What an expression may have that these values do not know of: sums over tables, noise, forces of other laws. */
class Unknown extends Error {}

/** Returns a force on a body at rest; undefined if it depends on more than its place. */
export function forceAt(law: Law, place: Place): Triple | undefined {
  return attempt(() => {
    const force = law.force === undefined ? ZERO : (evaluate(law.force, place) as Triple);
    if (law.acceleration === undefined) return force;
    const mass = place.world.components.Mass.value[place.id];
    return plus(force, times(evaluate(law.acceleration, place) as Triple, mass));
  });
}

/** Returns a potential energy; undefined if it depends on more than the place. */
export function potentialAt(law: Law, place: Place): number | undefined {
  const { potential } = law;
  return potential && attempt(() => evaluate(potential, place) as number);
}

function attempt<T>(compute: () => T): T | undefined {
  try {
    return compute();
  } catch (error) {
    if (error instanceof Unknown) return undefined;
    throw error;
  }
}

const ZERO: Triple = [0, 0, 0];

const plus = (a: Triple, b: Triple): Triple => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const times = (a: Triple, k: number): Triple => [a[0] * k, a[1] * k, a[2] * k];
const dot = (a: Triple, b: Triple) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

const SCALARS: Readonly<Record<string, (...args: number[]) => number | boolean>> = {
  add: (a, b) => a + b,
  sub: (a, b) => a - b,
  mul: (a, b) => a * b,
  div: (a, b) => a / b,
  min: (a, b) => Math.min(a, b),
  max: (a, b) => Math.max(a, b),
  negate: (a) => -a,
  abs: (a) => Math.abs(a),
  sqrt: (a) => Math.sqrt(a),
  floor: (a) => Math.floor(a),
  sin,
  cos,
  exp,
  log,
  pow,
  atan2,
  less: (a, b) => a < b,
  lessOrEqual: (a, b) => a <= b,
  equal: (a, b) => a === b,
};

const VECTORS: Readonly<Record<string, (...args: never[]) => Triple>> = {
  add: plus,
  sub: (a: Triple, b: Triple) => plus(a, times(b, -1)),
  mul: times,
  div: (a: Triple, k: number) => times(a, 1 / k),
  negate: (a: Triple) => times(a, -1),
  cross: (a: Triple, b: Triple) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]],
  normalize: (a: Triple) => (dot(a, a) > 0 ? times(a, 1 / Math.sqrt(dot(a, a))) : ZERO),
  vec3: (x: number, y: number, z: number) => [x, y, z],
  axial3: (x: number, y: number, z: number) => [x, y, z],
};

/** The motion of the body, which is at rest: what only resists motion has no part in a potential. */
const MOTION = ['velocity', 'startVelocity', 'angularVelocity'];

function evaluate(root: Tree, place: Place): Value {
  const known = new Map<object, Value>();
  const visit = (expression: Tree): Value => {
    const { op, args, shape } = expression;
    const before = known.get(expression);
    if (before !== undefined) return before;
    // The branch that is not taken may have no value.
    const taken = op === 'select' ? visit(args[visit(args[0] as Tree) ? 1 : 2] as Tree) : undefined;
    const value = taken ?? apply(expression, place, shape, () => args.map((arg) => visit(arg as Tree)));
    known.set(expression, value);
    return value;
  };
  return visit(root);
}

function apply({ op, data }: Tree, place: Place, shape: string, values: () => Value[]): Value {
  if (op === 'position') return place.position;
  if (MOTION.includes(op)) return ZERO;
  if (op === 'constant') return data as number;
  if (op === 'time') return place.world.time;
  if (op === 'column') return columnValue(data as Column, place);
  if (op === 'parameter') return parameterValue(data as Parameter, place);
  const args = values();
  if (op === 'component') return (args[0] as Triple)[data as number];
  if (op === 'dot') return dot(args[0] as Triple, args[1] as Triple);
  if (op === 'length') return Math.sqrt(dot(args[0] as Triple, args[0] as Triple));
  if (op === 'and') return args[0] === true && args[1] === true;
  if (op === 'or') return args[0] === true || args[1] === true;
  if (op === 'not') return args[0] !== true;
  const compute = (shape === 'vector' ? VECTORS : SCALARS)[op];
  if (compute === undefined) throw new Unknown(op);
  return compute(...(args as never[]));
}

interface Column {
  readonly component: string | object;
  readonly field: string;
}

function columnValue({ component, field }: Column, { world, id }: Place): number {
  const columns: unknown =
    typeof component === 'string'
      ? world.components[component as keyof typeof world.components]
      : world.internal.ownComponents.get(component as never)?.columns;
  return (columns as Readonly<Record<string, ArrayLike<number>>>)[field][id];
}

function parameterValue(parameter: Parameter, { parameters }: Place): number | Triple {
  const value = parameters.get(parameter);
  if (value === undefined) throw new Unknown(parameter.kind);
  return parameter.size === 1 ? value[0] : value;
}
