// The symbols of laws and integrators: scalars, vectors and conditions.
//
// The function of a law is called once with symbols in place of numbers. Each method returns a new symbol that stores
// its operands, so the result is an expression, which `lower.ts` converts to arithmetic for a world.
import { describe, PhysicsError } from '../errors/physics-error.ts';

export type Shape = 'scalar' | 'vector' | 'condition';

/** A number, or a symbol for a number. */
export type ScalarInput = number | Scalar;

/** Base class of all symbols. `data` identifies a leaf. */
export abstract class Expression {
  abstract readonly shape: Shape;
  /** Number of operations on the longest path to a leaf. */
  readonly depth: number;

  constructor(
    readonly op: string,
    readonly args: readonly Expression[],
    readonly data?: unknown,
  ) {
    this.depth = 1 + args.reduce((max, arg) => Math.max(max, arg.depth), 0);
  }

  /**
   * Expressions such as `speed > 3` or `speed + 1` require a number, which does not exist while the law is recorded.
   */
  [Symbol.toPrimitive](): never {
    throw new PhysicsError('E_TYPE', 'a symbol of a law is not a number, so it has no value to compare or add.', {
      hint: 'Use its methods, such as a.add(b) and a.less(b), and select(condition, a, b) in place of if and ? :.',
    });
  }
}

/** A condition, such as `speed.less(3)`, for use in `select`. */
export class Condition extends Expression {
  readonly shape = 'condition';

  and(other: Condition): Condition {
    return new Condition('and', [this, conditionOf(other, 'and')]);
  }
  or(other: Condition): Condition {
    return new Condition('or', [this, conditionOf(other, 'or')]);
  }
  not(): Condition {
    return new Condition('not', [this]);
  }
}

/** A real number per body. */
export class Scalar extends Expression {
  readonly shape = 'scalar';

  add(b: ScalarInput): Scalar {
    return this.#with('add', b);
  }
  sub(b: ScalarInput): Scalar {
    return this.#with('sub', b);
  }
  mul(b: ScalarInput): Scalar {
    return this.#with('mul', b);
  }
  div(b: ScalarInput): Scalar {
    return this.#with('div', b);
  }
  /** The smaller of the two; this value if `b` is NaN. */
  min(b: ScalarInput): Scalar {
    return this.#with('min', b);
  }
  /** The larger of the two; this value if `b` is NaN. */
  max(b: ScalarInput): Scalar {
    return this.#with('max', b);
  }
  negate(): Scalar {
    return new Scalar('negate', [this]);
  }
  abs(): Scalar {
    return new Scalar('abs', [this]);
  }
  sqrt(): Scalar {
    return new Scalar('sqrt', [this]);
  }
  floor(): Scalar {
    return new Scalar('floor', [this]);
  }
  /** The nearest integer; of two equally near, the even one. */
  round(): Scalar {
    return new Scalar('round', [this]);
  }
  square(): Scalar {
    return this.mul(this);
  }
  sin(): Scalar {
    return new Scalar('sin', [this]);
  }
  cos(): Scalar {
    return new Scalar('cos', [this]);
  }
  exp(): Scalar {
    return new Scalar('exp', [this]);
  }
  /** Natural logarithm. */
  log(): Scalar {
    return new Scalar('log', [this]);
  }
  /** An exponent that is a whole or half number up to 8 costs a few products, any other some 120 ns a body. */
  pow(exponent: ScalarInput): Scalar {
    return this.#with('pow', exponent);
  }
  /** The angle of the direction (x, this), radians. */
  atan2(x: ScalarInput): Scalar {
    return this.#with('atan2', x);
  }
  less(b: ScalarInput): Condition {
    return new Condition('less', [this, scalarOf(b, 'less')]);
  }
  lessOrEqual(b: ScalarInput): Condition {
    return new Condition('lessOrEqual', [this, scalarOf(b, 'lessOrEqual')]);
  }
  greater(b: ScalarInput): Condition {
    return new Condition('less', [scalarOf(b, 'greater'), this]);
  }
  greaterOrEqual(b: ScalarInput): Condition {
    return new Condition('lessOrEqual', [scalarOf(b, 'greaterOrEqual'), this]);
  }
  equals(b: ScalarInput): Condition {
    return new Condition('equal', [this, scalarOf(b, 'equals')]);
  }

  #with(op: string, b: ScalarInput): Scalar {
    return new Scalar(op, [this, scalarOf(b, op)]);
  }
}

/** Three real numbers per body. In 2D z is zero, unless the vector is axial, such as a spin. */
export class Vector extends Expression {
  readonly shape = 'vector';

  get x(): Scalar {
    return new Scalar('component', [this], 0);
  }
  get y(): Scalar {
    return new Scalar('component', [this], 1);
  }
  get z(): Scalar {
    return new Scalar('component', [this], 2);
  }
  add(b: Vector): Vector {
    return new Vector('add', [this, vectorOf(b, 'add')]);
  }
  sub(b: Vector): Vector {
    return new Vector('sub', [this, vectorOf(b, 'sub')]);
  }
  mul(factor: ScalarInput): Vector {
    return new Vector('mul', [this, scalarOf(factor, 'mul')]);
  }
  div(divisor: ScalarInput): Vector {
    return new Vector('div', [this, scalarOf(divisor, 'div')]);
  }
  negate(): Vector {
    return new Vector('negate', [this]);
  }
  dot(b: Vector): Scalar {
    return new Scalar('dot', [this, vectorOf(b, 'dot')]);
  }
  cross(b: Vector): Vector {
    return new Vector('cross', [this, vectorOf(b, 'cross')]);
  }
  /** From the squares, which must fit: lengths from 1e-18 to 1.8e19 in f32, from 1e-153 to 1.3e154 in f64. */
  length(): Scalar {
    return new Scalar('length', [this]);
  }
  lengthSquared(): Scalar {
    return this.dot(this);
  }
  /** The unit vector in this direction; zero for a zero vector, and for one whose `length` overflows. */
  normalize(): Vector {
    return new Vector('normalize', [this]);
  }
}

/** A symbol for a constant. */
export function constant(value: number): Scalar {
  return new Scalar('constant', [], value);
}

/** `whenTrue` where the condition holds, `whenFalse` elsewhere. Both are computed. */
export function select(condition: Condition, whenTrue: Vector, whenFalse: Vector): Vector;
export function select(condition: Condition, whenTrue: ScalarInput, whenFalse: ScalarInput): Scalar;
export function select(
  condition: Condition,
  whenTrue: ScalarInput | Vector,
  whenFalse: ScalarInput | Vector,
): Scalar | Vector {
  conditionOf(condition, 'select');
  if (whenTrue instanceof Vector || whenFalse instanceof Vector) {
    return new Vector('select', [condition, vectorOf(whenTrue, 'select'), vectorOf(whenFalse, 'select')]);
  }
  return new Scalar('select', [condition, scalarOf(whenTrue, 'select'), scalarOf(whenFalse, 'select')]);
}

/** A vector of three components; in 2D z is dropped, except in the `torque` of a law and the field of `boris`. */
export function vec3(x: ScalarInput, y: ScalarInput, z: ScalarInput = 0): Vector {
  return new Vector('vec3', [scalarOf(x, 'vec3'), scalarOf(y, 'vec3'), scalarOf(z, 'vec3')]);
}

/** A vector that keeps z in 2D: the axis of a rotation, a magnetic field. */
export function axial3(x: ScalarInput, y: ScalarInput, z: ScalarInput): Vector {
  return new Vector('axial3', [scalarOf(x, 'axial3'), scalarOf(y, 'axial3'), scalarOf(z, 'axial3')]);
}

/**
 * @throws PhysicsError E_TYPE if the value is neither a number nor a scalar symbol
 */
export function scalarOf(value: unknown, method: string): Scalar {
  if (typeof value === 'number') return constant(value);
  if (value instanceof Scalar) return value;
  throw mismatch('a scalar or a number', value, method);
}

/**
 * @throws PhysicsError E_TYPE if the value is not a vector symbol
 */
export function vectorOf(value: unknown, method: string): Vector {
  if (value instanceof Vector) return value;
  throw mismatch('a vector', value, method);
}

/**
 * @throws PhysicsError E_TYPE if the value is not a condition
 */
export function conditionOf(value: unknown, method: string): Condition {
  if (value instanceof Condition) return value;
  throw mismatch('a condition', value, method);
}

function mismatch(expected: string, value: unknown, method: string): PhysicsError {
  return new PhysicsError('E_TYPE', `${method} takes ${expected}, got ${kindOf(value)}.`, { field: method, value });
}

/** Returns the kind of a value, for messages. */
export function kindOf(value: unknown): string {
  return value instanceof Expression ? `a ${value.shape}` : describe(value);
}
