// The gradient of an expression with respect to the body's position, as another expression.
//
// The algorithm is reverse-mode differentiation: one sweep from the result to the leaves, in which each operation
// passes the derivative of the result to its arguments. Everything else that a law reads, such as columns, parameters
// and time, is constant. Where a root or length has no derivative, as |r| at r = 0, the gradient is zero instead of
// NaN. Source: Griewank, Walther: Evaluating Derivatives, 2nd ed., section 3.2.
import { PhysicsError } from '../errors/physics-error.ts';
import { axial3, constant, Expression, type Scalar, select, Vector, vec3 } from './expression.ts';
import { containsSum, sumApart } from './rename-rows.ts';
import type { SumScope } from './table.ts';

/** Returns the gradient of `potential` times a factor. @throws PhysicsError E_TYPE if it is not differentiable */
export function gradientOf(potential: Scalar, factor: Scalar): Vector {
  const { x, y, z } = new Gradient().of(potential, factor);
  // In 2D the z component is dropped.
  return vec3(x, y, z);
}

/** The derivative of the result with respect to an expression: terms per axis and terms of the whole vector. */
interface Adjoint {
  vector: Expression | undefined;
  readonly axes: (Scalar | undefined)[];
}

const NONE = axial3(0, 0, 0);
const AXES = [axial3(1, 0, 0), axial3(0, 1, 0), axial3(0, 0, 1)];

class Gradient {
  readonly #dependence = new Map<Expression, boolean>();
  readonly #metJoints = new Set<Expression>();
  /** Gradients of joints that several branches share: of a scalar, or of each axis of a vector. */
  readonly #shared = new Map<Expression, readonly Vector[]>();

  /** Returns the gradient of a scalar times a factor, or of the scalar product of a vector and a constant vector. */
  of(result: Expression, factor: Expression): Vector {
    if (!this.#depends(result)) return NONE;
    const adjoints = new Map<Expression, Adjoint>([[result, { vector: factor, axes: [] }]]);
    let total: Vector | undefined;
    const add = (contribution: Vector) => {
      total = total?.add(contribution) ?? contribution;
    };
    for (const expression of this.#inOrder(result)) {
      const adjoint = combinedAdjoint(adjoints.get(expression) as Adjoint);
      if (expression.op === 'position') add(adjoint as Vector);
      else if (isJoint(expression)) add(this.#ofEachJoint(expression, adjoint));
      else {
        const contributions = contributionsToArgs(expression, adjoint);
        for (const [i, arg] of expression.args.entries()) this.#contribute(adjoints, arg, contributions[i]);
      }
    }
    return total as unknown as Vector;
  }

  #contribute(adjoints: Map<Expression, Adjoint>, to: Expression, contribution: Contribution): void {
    if (!this.#depends(to)) return;
    const adjoint = adjoints.get(to) ?? { vector: undefined, axes: [] };
    adjoints.set(to, adjoint);
    if (contribution instanceof Expression) adjoint.vector = plus(adjoint.vector, contribution);
    else adjoint.axes[contribution[0]] = plus(adjoint.axes[contribution[0]], contribution[1]) as Scalar;
  }

  /**
   * A joint in both branches of another is differentiated once for all branches after the first, and then multiplied by the
   * adjoint: branches within branches would otherwise double the work at each level. Sums of vectors are left out, because that
   * takes three sums in place of one.
   */
  #ofEachJoint(joint: Expression, adjoint: Expression): Vector {
    if (!this.#metJoints.has(joint) || (joint.op === 'sum' && joint.shape === 'vector')) {
      this.#metJoints.add(joint);
      return this.#ofJoint(joint, adjoint);
    }
    let shared = this.#shared.get(joint);
    if (shared === undefined) {
      shared = (joint.shape === 'vector' ? AXES : [constant(1)]).map((unit) => this.#ofJoint(joint, unit));
      this.#shared.set(joint, shared);
    }
    if (adjoint instanceof Vector) {
      const [x, y, z] = shared;
      return x.mul(adjoint.x).add(y.mul(adjoint.y)).add(z.mul(adjoint.z));
    }
    return scaled(shared[0], adjoint as Scalar);
  }

  /**
   * The gradient of a selection is selected last, because the gradient of the branch not taken may be NaN. The gradient
   * of a sum is the sum of the gradients.
   */
  #ofJoint({ op, args, data }: Expression, adjoint: Expression): Vector {
    const [a, b, c] = args;
    switch (op) {
      case 'select':
        return select(a as never, this.of(b, adjoint), this.of(c, adjoint));
      case 'min':
        return select((b as Scalar).less(a as Scalar), this.of(b, adjoint), this.of(a, adjoint));
      case 'max':
        return select((a as Scalar).less(b as Scalar), this.of(b, adjoint), this.of(a, adjoint));
      default:
        if (a.shape === 'vector') return this.#ofVectorSum(a, adjoint, data as SumScope);
        return scaled(new Vector('sum', [this.of(a, constant(1))], data as SumScope), adjoint as Scalar);
    }
  }

  /** As part of the term, the derivative with respect to the sum may depend on this sum itself, which is computed before. */
  #ofVectorSum(term: Expression, adjoint: Expression, scope: SumScope): Vector {
    const gradient = this.of(term, adjoint);
    return containsSum(adjoint) ? sumApart(gradient, scope) : new Vector('sum', [gradient], scope);
  }

  /** Returns whether an expression depends on the position. */
  #depends(expression: Expression): boolean {
    let depends = this.#dependence.get(expression);
    if (depends === undefined) {
      const { op, args } = expression;
      depends = op === 'position' || (!STEPS.has(op) && args.some((arg) => this.#depends(arg)));
      this.#dependence.set(expression, depends);
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

/** Contribution to one argument: to all axes, or to one axis of a vector. */
type Contribution = Expression | readonly [axis: number, Scalar];

/** Returns the derivative with respect to each argument, given the derivative with respect to the expression. */
function contributionsToArgs(expression: Expression, adjoint: Expression): readonly Contribution[] {
  switch (expression.op) {
    case 'add':
      return [adjoint, adjoint];
    case 'sub':
      return [adjoint, negative(adjoint)];
    case 'negate':
      return [negative(adjoint)];
    default:
      return adjoint instanceof Vector
        ? contributionsToVectorArgs(expression as Vector, adjoint)
        : contributionsToScalarArgs(expression as Scalar, adjoint as Scalar);
  }
}

function contributionsToScalarArgs(f: Scalar, adjoint: Scalar): readonly Contribution[] {
  const [a, b] = f.args as [Scalar, Scalar];
  switch (f.op) {
    case 'mul':
      return [product(b, adjoint), product(a, adjoint)];
    case 'div':
      return [adjoint.div(b), product(f.div(b), adjoint).negate()];
    case 'abs':
      return [product(select(a.less(0), -1, select(a.greater(0), 1, 0)), adjoint)];
    case 'sqrt':
      return [select(f.greater(0), adjoint.div(f.mul(2)), 0)];
    case 'sin':
      return [product(a.cos(), adjoint)];
    case 'cos':
      return [product(a.sin(), adjoint).negate()];
    case 'exp':
      return [product(f, adjoint)];
    case 'log':
      return [adjoint.div(a)];
    case 'pow': {
      const byExponent = select(f.equals(0), 0, f.mul(a.log()));
      return [product(powerSlope(a, b), adjoint), product(byExponent, adjoint)];
    }
    case 'atan2': {
      const square = a.square().add(b.square());
      const slope = select(square.greater(0), adjoint.div(square), 0);
      return [b.mul(slope), a.mul(slope).negate()];
    }
    default:
      return contributionsToProductArgs(f, adjoint);
  }
}

/** Derivatives of scalars that are functions of vectors. */
function contributionsToProductArgs({ op, args, data }: Scalar, adjoint: Scalar): readonly Contribution[] {
  const [a, b] = args as [Vector, Vector];
  switch (op) {
    case 'component':
      return [[data as number, adjoint]];
    case 'dot':
      return [scaled(b, adjoint), scaled(a, adjoint)];
    case 'length':
      return [scaled(a.normalize(), adjoint)];
    default:
      throw notDifferentiable(op);
  }
}

function contributionsToVectorArgs(f: Vector, adjoint: Vector): readonly Contribution[] {
  const [a, b] = f.args as [Vector, Vector];
  const factor = f.args[1] as Scalar;
  switch (f.op) {
    case 'mul':
      return [adjoint.mul(factor), adjoint.dot(a)];
    case 'div':
      return [adjoint.div(factor), adjoint.dot(f).div(factor).negate()];
    case 'cross':
      return [b.cross(adjoint), adjoint.cross(a)];
    case 'normalize': {
      const length = a.length();
      const across = adjoint.sub(f.mul(f.dot(adjoint)));
      return [select(length.greater(0), across.div(length), NONE)];
    }
    case 'rotate':
      // The inverse of a rotation is its transpose.
      return [axialOf(AXES.map((axis) => new Vector('rotate', [axis]).dot(adjoint)))];
    case 'vec3': {
      const { x, y, z } = vec3(adjoint.x, adjoint.y, adjoint.z);
      return [x, y, z];
    }
    case 'axial3':
      return [adjoint.x, adjoint.y, adjoint.z];
    default:
      throw notDifferentiable(f.op);
  }
}

function notDifferentiable(op: string): PhysicsError {
  return new PhysicsError('E_TYPE', `${op} has no derivative with respect to the position.`, { field: op });
}

function combinedAdjoint({ vector, axes }: Adjoint): Expression {
  if (axes.length === 0) return vector as Expression;
  const byAxes = axialOf(axes);
  return vector === undefined ? byAxes : (vector as Vector).add(byAxes);
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

/** Returns the derivative b a^(b - 1) of a power; zero at a = 0 for exponents from 0 to 1, as for a root. */
function powerSlope(a: Scalar, b: Scalar): Scalar {
  if (b.op !== 'constant') {
    const isCusp = a.equals(0).and(b.greaterOrEqual(0)).and(b.less(1));
    return select(isCusp, 0, b.mul(a.pow(b.sub(1))));
  }
  const exponent = b.data as number;
  if (exponent === 0 || exponent === 1) return b;
  const slope = b.mul(exponent === 2 ? a : a.pow(exponent - 1));
  return exponent > 0 && exponent < 1 ? select(a.equals(0), 0, slope) : slope;
}

/** Omits a factor of 1, with which a sweep begins. */
function product(a: Scalar, adjoint: Scalar): Scalar {
  if (adjoint.op !== 'constant') return a.mul(adjoint);
  return adjoint.data === 1 ? a : adjoint.data === -1 ? a.negate() : a.mul(adjoint);
}

function scaled(a: Vector, adjoint: Scalar): Vector {
  if (adjoint.op !== 'constant') return a.mul(adjoint);
  return adjoint.data === 1 ? a : adjoint.data === -1 ? a.negate() : a.mul(adjoint);
}
