// The gradient of an expression with respect to the body's position, as another expression.
//
// The algorithm is reverse-mode differentiation: one sweep from the result to the leaves, in which each operation
// passes the derivative of the result to its arguments. Everything else that a law reads, such as columns, parameters
// and time, is constant. Where a root or length has no derivative, as |r| at r = 0, the gradient is zero instead of
// NaN. Source: Griewank, Walther: Evaluating Derivatives, 2nd ed., section 3.2.
import { PhysicsError } from '../errors/physics-error.ts';
import { axial3, constant, Expression, type Scalar, select, Vector, vec3 } from './expression.ts';
import type { SumScope } from './table.ts';

/** Returns the gradient of `potential` times a factor. @throws PhysicsError E_TYPE if it is not differentiable */
export function gradientOf(potential: Scalar, factor: Scalar): Vector {
  const { x, y, z } = new Gradient().of(potential, factor);
  // In 2D the z component is dropped.
  return vec3(x, y, z);
}

/** The derivative of the result with respect to an expression: terms per axis and terms of the whole vector. */
interface Change {
  whole: Expression | undefined;
  readonly axes: (Scalar | undefined)[];
}

const NONE = axial3(0, 0, 0);
const AXES = [axial3(1, 0, 0), axial3(0, 1, 0), axial3(0, 0, 1)];

class Gradient {
  readonly #moves = new Map<Expression, boolean>();

  /** Returns the gradient of a scalar times a factor, or of the scalar product of a vector and a constant vector. */
  of(result: Expression, factor: Expression): Vector {
    if (!this.#depends(result)) return NONE;
    const changes = new Map<Expression, Change>([[result, { whole: factor, axes: [] }]]);
    let total: Vector | undefined;
    const add = (part: Vector) => {
      total = total?.add(part) ?? part;
    };
    for (const expression of this.#inOrder(result)) {
      const change = wholeOf(changes.get(expression) as Change);
      if (expression.op === 'position') add(change as Vector);
      else if (isJoint(expression)) add(this.#ofJoint(expression, change));
      else {
        const parts = partsOf(expression, change);
        for (const [i, arg] of expression.args.entries()) this.#hand(changes, arg, parts[i]);
      }
    }
    return total as unknown as Vector;
  }

  #hand(changes: Map<Expression, Change>, to: Expression, part: Part): void {
    if (!this.#depends(to)) return;
    const known = changes.get(to) ?? { whole: undefined, axes: [] };
    changes.set(to, known);
    if (part instanceof Expression) known.whole = plus(known.whole, part);
    else known.axes[part[0]] = plus(known.axes[part[0]], part[1]) as Scalar;
  }

  /**
   * The gradient of a selection is selected last, because the gradient of the branch not taken may be NaN. The gradient
   * of a sum is the sum of the gradients.
   */
  #ofJoint({ op, args, data }: Expression, change: Expression): Vector {
    const [a, b, c] = args;
    switch (op) {
      case 'select':
        return select(a as never, this.of(b, change), this.of(c, change));
      case 'min':
        return select((b as Scalar).less(a as Scalar), this.of(b, change), this.of(a, change));
      case 'max':
        return select((a as Scalar).less(b as Scalar), this.of(b, change), this.of(a, change));
      default:
        if (a.shape === 'vector') return new Vector('sum', [this.of(a, change)], data as SumScope);
        return scaled(new Vector('sum', [this.of(a, constant(1))], data as SumScope), change as Scalar);
    }
  }

  /** Returns whether an expression depends on the position. */
  #depends(expression: Expression): boolean {
    let depends = this.#moves.get(expression);
    if (depends === undefined) {
      const { op, args } = expression;
      depends = op === 'position' || (!STEPS.has(op) && args.some((arg) => this.#depends(arg)));
      this.#moves.set(expression, depends);
    }
    return depends;
  }

  /**
   * Returns the expressions that depend on the position, each before its arguments; joints handle theirs separately.
   */
  #inOrder(result: Expression): Expression[] {
    const seen = new Set<Expression>();
    const order: Expression[] = [];
    const visit = (expression: Expression) => {
      if (seen.has(expression) || !this.#depends(expression)) return;
      seen.add(expression);
      if (!isJoint(expression)) expression.args.forEach(visit);
      order.push(expression);
    };
    visit(result);
    return order.reverse();
  }
}

/** Operations whose result is piecewise constant. */
const STEPS = new Set(['floor', 'round', 'less', 'lessOrEqual', 'equal', 'noise']);

function isJoint({ op }: Expression): boolean {
  return op === 'select' || op === 'min' || op === 'max' || op === 'sum';
}

/** Contribution to one argument: to the whole of it, or to one axis of a vector. */
type Part = Expression | readonly [axis: number, Scalar];

/** Returns the derivative with respect to each argument, given the derivative with respect to the expression. */
function partsOf(expression: Expression, change: Expression): readonly Part[] {
  switch (expression.op) {
    case 'add':
      return [change, change];
    case 'sub':
      return [change, negative(change)];
    case 'negate':
      return [negative(change)];
    default:
      return change instanceof Vector
        ? partsOfVector(expression as Vector, change)
        : partsOfScalar(expression as Scalar, change as Scalar);
  }
}

function partsOfScalar(f: Scalar, change: Scalar): readonly Part[] {
  const [a, b] = f.args as [Scalar, Scalar];
  switch (f.op) {
    case 'mul':
      return [product(b, change), product(a, change)];
    case 'div':
      return [change.div(b), product(f.div(b), change).negate()];
    case 'abs':
      return [product(select(a.less(0), -1, select(a.greater(0), 1, 0)), change)];
    case 'sqrt':
      return [select(f.greater(0), change.div(f.mul(2)), 0)];
    case 'sin':
      return [product(a.cos(), change)];
    case 'cos':
      return [product(a.sin(), change).negate()];
    case 'exp':
      return [product(f, change)];
    case 'log':
      return [change.div(a)];
    case 'pow':
      return [product(b.mul(powerBelow(a, b)), change), product(f.mul(a.log()), change)];
    case 'atan2': {
      const square = a.square().add(b.square());
      const slope = select(square.greater(0), change.div(square), 0);
      return [b.mul(slope), a.mul(slope).negate()];
    }
    default:
      return partsOfProduct(f, change);
  }
}

/** Derivatives of scalars that are functions of vectors. */
function partsOfProduct({ op, args, data }: Scalar, change: Scalar): readonly Part[] {
  const [a, b] = args as [Vector, Vector];
  switch (op) {
    case 'component':
      return [[data as number, change]];
    case 'dot':
      return [scaled(b, change), scaled(a, change)];
    case 'length':
      return [scaled(a.normalize(), change)];
    default:
      throw without(op);
  }
}

function partsOfVector(f: Vector, change: Vector): readonly Part[] {
  const [a, b] = f.args as [Vector, Vector];
  const factor = f.args[1] as Scalar;
  switch (f.op) {
    case 'mul':
      return [change.mul(factor), change.dot(a)];
    case 'div':
      return [change.div(factor), change.dot(f).div(factor).negate()];
    case 'cross':
      return [b.cross(change), change.cross(a)];
    case 'normalize': {
      const length = a.length();
      const across = change.sub(f.mul(f.dot(change)));
      return [select(length.greater(0), across.div(length), NONE)];
    }
    case 'rotate':
      // The inverse of a rotation is its transpose.
      return [axialOf(AXES.map((axis) => new Vector('rotate', [axis]).dot(change)))];
    case 'vec3': {
      const { x, y, z } = vec3(change.x, change.y, change.z);
      return [x, y, z];
    }
    case 'axial3':
      return [change.x, change.y, change.z];
    default:
      throw without(f.op);
  }
}

function without(op: string): PhysicsError {
  return new PhysicsError('E_TYPE', `${op} has no derivative with respect to the position.`, { field: op });
}

function wholeOf({ whole, axes }: Change): Expression {
  if (axes.length === 0) return whole as Expression;
  const apart = axialOf(axes);
  return whole === undefined ? apart : (whole as Vector).add(apart);
}

function axialOf([x, y, z]: readonly (Scalar | undefined)[]): Vector {
  return axial3(x ?? 0, y ?? 0, z ?? 0);
}

function plus(a: Expression | undefined, b: Expression): Expression {
  if (a === undefined) return b;
  return a instanceof Vector ? a.add(b as Vector) : (a as Scalar).add(b as Scalar);
}

function negative(a: Expression): Expression {
  return a instanceof Vector ? a.negate() : (a as Scalar).negate();
}

/** Returns a to the power b - 1. */
function powerBelow(a: Scalar, b: Scalar): Scalar {
  if (b.op !== 'constant') return a.pow(b.sub(1));
  const below = (b.data as number) - 1;
  if (below === 0) return constant(1);
  return below === 1 ? a : a.pow(below);
}

/** Omits a factor of 1, with which a sweep begins. */
function product(a: Scalar, change: Scalar): Scalar {
  if (change.op !== 'constant') return a.mul(change);
  return change.data === 1 ? a : change.data === -1 ? a.negate() : a.mul(change);
}

function scaled(a: Vector, change: Scalar): Vector {
  if (change.op !== 'constant') return a.mul(change);
  return change.data === 1 ? a : change.data === -1 ? a.negate() : a.mul(change);
}
