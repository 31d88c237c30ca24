/** Random expressions of laws, built twice: as symbols, and as the numbers of each body. */
import { axial3, type ConditionSymbol, type ScalarSymbol, select, type VectorSymbol, vec3 } from '@principia/physics';
import {
  type Arithmetic,
  type Binary,
  type Comparison,
  type Elementary,
  type Real,
  type Triple,
  type Truth,
  type Unary,
  ZERO,
} from './law-interpreter.ts';

/** A random operation on what there is already: three places in the list of earlier results. */
export interface Choice {
  readonly op: number;
  readonly args: readonly [number, number, number];
}

const MAX_DEPTH = 6;

/** A symbol of a law, and what it is for each body. */
export interface Made<Symbol, Value> {
  readonly symbol: Symbol;
  readonly values: readonly Value[];
  readonly depth: number;
}

export type MadeScalar = Made<ScalarSymbol, Real>;
export type MadeVector = Made<VectorSymbol, Triple>;
export type MadeCondition = Made<ConditionSymbol, Truth>;

const BINARY: readonly Binary[] = ['add', 'sub', 'mul', 'div', 'min', 'max'];
const UNARY: readonly Unary[] = ['negate', 'abs', 'sqrt', 'floor'];
const ELEMENTARY: readonly Elementary[] = ['sin', 'cos', 'exp', 'log', 'pow', 'atan2'];
const COMPARISONS: readonly Comparison[] = ['less', 'lessOrEqual', 'equals'];

/** Builds the same expression twice: as symbols, and as the numbers of each body. */
export class Twins {
  readonly scalars: MadeScalar[] = [];
  readonly vectors: MadeVector[] = [];
  readonly conditions: MadeCondition[] = [];

  constructor(readonly arithmetic: Arithmetic) {}

  /** Something of a list that is not too deep yet. */
  pick<T extends { readonly depth: number }>(list: readonly T[], place: number): T {
    const shallow = list.filter(({ depth }) => depth < MAX_DEPTH);
    // What was made last is asked for as often as all that came before it.
    return shallow[
      place % 2 === 0 ? shallow.length - 1 - ((place / 2) % Math.min(4, shallow.length)) : place % shallow.length
    ];
  }

  apply({ op, args: [i, j, k] }: Choice): void {
    const [a, b] = [this.pick(this.scalars, i), this.pick(this.scalars, j)];
    const [v, w] = [this.pick(this.vectors, i), this.pick(this.vectors, j)];
    const kinds = [
      () => this.#binary(BINARY[k % BINARY.length], a, b),
      () => this.#unary(UNARY[k % UNARY.length], a),
      () => this.#elementary(ELEMENTARY[k % ELEMENTARY.length], a, b),
      () => this.#compare(COMPARISONS[k % COMPARISONS.length], a, b),
      () => this.#logic(k, this.pick(this.conditions, i), this.pick(this.conditions, j)),
      () => this.#choose(this.pick(this.conditions, k), a, b),
      () => this.#chooseVector(this.pick(this.conditions, k), v, w),
      () => this.#vectorOf(k, a, b, this.pick(this.scalars, i + j)),
      () => this.#combine(k, v, w),
      () => this.#scale(k % 2 === 0 ? 'mul' : 'div', v, b),
      () => this.#measure(k, v, w),
    ];
    kinds[op % kinds.length]();
  }

  scalar(symbol: ScalarSymbol, values: readonly Real[], from: readonly { depth: number }[] = []): void {
    this.scalars.push({ symbol, values, depth: depthOver(from) });
  }

  vector(symbol: VectorSymbol, values: readonly Triple[], from: readonly { depth: number }[] = []): void {
    this.vectors.push({ symbol, values, depth: depthOver(from) });
  }

  condition(symbol: ConditionSymbol, values: readonly Truth[], from: readonly { depth: number }[] = []): void {
    this.conditions.push({ symbol, values, depth: depthOver(from) });
  }

  #binary(op: Binary, a: MadeScalar, b: MadeScalar): void {
    this.scalar(
      a.symbol[op](b.symbol),
      zip(a, b, (x, y) => this.arithmetic.binary(op, x, y)),
      [a, b],
    );
  }

  #unary(op: Unary, a: MadeScalar): void {
    this.scalar(
      a.symbol[op](),
      a.values.map((x) => this.arithmetic.unary(op, x)),
      [a],
    );
  }

  #elementary(op: Elementary, a: MadeScalar, b: MadeScalar): void {
    if (op === 'pow' || op === 'atan2') {
      this.scalar(
        a.symbol[op](b.symbol),
        zip(a, b, (x, y) => this.arithmetic.call(op, [x, y])),
        [a, b],
      );
    } else
      this.scalar(
        a.symbol[op](),
        a.values.map((x) => this.arithmetic.call(op, [x])),
        [a],
      );
  }

  #compare(op: Comparison, a: MadeScalar, b: MadeScalar): void {
    this.condition(
      a.symbol[op](b.symbol),
      zip(a, b, (x, y) => this.arithmetic.compare(op, x, y)),
      [a, b],
    );
  }

  #logic(kind: number, a: MadeCondition, b: MadeCondition): void {
    const join = (of: (x: boolean, y: boolean) => boolean) =>
      zip(a, b, (x, y) => ({ holds: of(x.holds, y.holds), isUniform: x.isUniform && y.isUniform }));
    if (kind % 3 === 0)
      this.condition(
        a.symbol.and(b.symbol),
        join((x, y) => x && y),
        [a, b],
      );
    else if (kind % 3 === 1)
      this.condition(
        a.symbol.or(b.symbol),
        join((x, y) => x || y),
        [a, b],
      );
    else
      this.condition(
        a.symbol.not(),
        a.values.map((x) => ({ ...x, holds: !x.holds })),
        [a],
      );
  }

  /** The first scalar and vector are a body's own: between two numbers that all share, equal ones would be one. */
  #choose(condition: MadeCondition, a: MadeScalar, given: MadeScalar): void {
    const isShared = !condition.values[0].isUniform && a.values[0].isUniform && given.values[0].isUniform;
    const b = isShared ? this.scalars[0] : given;
    const values = condition.values.map((c, i) => this.arithmetic.select(c, a.values[i], b.values[i]));
    this.scalar(select(condition.symbol, a.symbol, b.symbol), values, [condition, a, b]);
  }

  #chooseVector(condition: MadeCondition, v: MadeVector, given: MadeVector): void {
    const isShared = (axis: 0 | 1 | 2) => v.values[0][axis].isUniform && given.values[0][axis].isUniform;
    const w = ([0, 1, 2] as const).some(isShared) ? this.vectors[0] : given;
    const values = condition.values.map(
      (c, i) => [0, 1, 2].map((a) => this.arithmetic.select(c, v.values[i][a], w.values[i][a])) as unknown as Triple,
    );
    this.vector(select(condition.symbol, v.symbol, w.symbol), values, [condition, v, w]);
  }

  #vectorOf(kind: number, x: MadeScalar, y: MadeScalar, z: MadeScalar): void {
    const isAxial = kind % 2 === 0;
    const make = isAxial ? axial3 : vec3;
    const isFlat = this.vectors[0].values[0][2].isZero && !isAxial;
    const values = x.values.map((_, i): Triple => [x.values[i], y.values[i], isFlat ? ZERO : z.values[i]]);
    this.vector(make(x.symbol, y.symbol, z.symbol), values, [x, y, z]);
  }

  #combine(kind: number, v: MadeVector, w: MadeVector): void {
    const { arithmetic } = this;
    const from = [v, w];
    if (kind % 5 === 0)
      this.vector(
        v.symbol.add(w.symbol),
        zip(v, w, (a, b) => arithmetic.each('add', a, b)),
        from,
      );
    else if (kind % 5 === 1)
      this.vector(
        v.symbol.sub(w.symbol),
        zip(v, w, (a, b) => arithmetic.each('sub', a, b)),
        from,
      );
    else if (kind % 5 === 2)
      this.vector(
        v.symbol.cross(w.symbol),
        zip(v, w, (a, b) => arithmetic.cross(a, b)),
        from,
      );
    else if (kind % 5 === 3)
      this.vector(
        v.symbol.normalize(),
        v.values.map((a) => arithmetic.normalize(a)),
        [v],
      );
    else
      this.vector(
        v.symbol.negate(),
        v.values.map((a) => a.map((x) => arithmetic.unary('negate', x)) as unknown as Triple),
        [v],
      );
  }

  #scale(op: 'mul' | 'div', v: MadeVector, s: MadeScalar): void {
    this.vector(
      v.symbol[op](s.symbol),
      v.values.map((a, i) => this.arithmetic.scale(op, a, s.values[i])),
      [v, s],
    );
  }

  #measure(kind: number, v: MadeVector, w: MadeVector): void {
    if (kind % 3 === 0)
      this.scalar(
        v.symbol.dot(w.symbol),
        zip(v, w, (a, b) => this.arithmetic.dot(a, b)),
        [v, w],
      );
    else if (kind % 3 === 1)
      this.scalar(
        v.symbol.length(),
        v.values.map((a) => this.arithmetic.length(a)),
        [v],
      );
    else
      this.scalar(
        v.symbol[(['x', 'y', 'z'] as const)[((kind % 9) / 3) | 0]],
        v.values.map((a) => a[((kind % 9) / 3) | 0]),
        [v],
      );
  }
}

function depthOver(from: readonly { depth: number }[]): number {
  return 1 + from.reduce((most, { depth }) => Math.max(most, depth), -1);
}

export function zip<A, B, C>(a: { values: readonly A[] }, b: { values: readonly B[] }, of: (x: A, y: B) => C): C[] {
  return a.values.map((x, i) => of(x, b.values[i]));
}
