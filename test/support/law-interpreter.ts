/**
 * The arithmetic of laws on plain numbers, for one body at a time: what a compiled law must give to the last bit.
 *
 * What is the same for all bodies is computed in doubles, and rounded to the world's precision where it meets a body's
 * own number; everything else is rounded after each operation. Functions such as `sin` are told doubles in full. Zeros
 * that are there for the dimensions' sake take part in no product and no sum.
 */
import { atan2, cos, exp, log, pow, sin } from '@principia/physics';

/** A real number per body. */
export interface Real {
  readonly value: number;
  /** Whether it is the same for all bodies. */
  readonly isUniform: boolean;
  /** Whether it is a constant of the law. */
  readonly isConstant: boolean;
  /** Whether it is zero because the world is 2D. */
  readonly isZero: boolean;
}

/** A condition per body. */
export interface Truth {
  readonly holds: boolean;
  readonly isUniform: boolean;
}

export type Triple = readonly [x: Real, y: Real, z: Real];

export const ZERO: Real = { value: 0, isUniform: true, isConstant: false, isZero: true };

const plain = { isConstant: false, isZero: false } as const;
export const known = (value: number): Real => ({ value, isUniform: true, isConstant: true, isZero: false });
export const uniform = (value: number): Real => ({ value, isUniform: true, ...plain });
export const own = (value: number): Real => ({ value, isUniform: false, ...plain });

const BINARY = {
  add: (a: number, b: number) => a + b,
  sub: (a: number, b: number) => a - b,
  mul: (a: number, b: number) => a * b,
  div: (a: number, b: number) => a / b,
  min: (a: number, b: number) => (b < a ? b : a),
  max: (a: number, b: number) => (a < b ? b : a),
} as const;

const UNARY = {
  negate: (a: number) => -a,
  abs: (a: number) => Math.abs(a),
  sqrt: (a: number) => Math.sqrt(a),
  floor: (a: number) => Math.floor(a),
} as const;

const FUNCTIONS = { sin, cos, exp, log, pow, atan2 } as const;

const COMPARISONS = {
  less: (a: number, b: number) => a < b,
  lessOrEqual: (a: number, b: number) => a <= b,
  equals: (a: number, b: number) => a === b,
} as const;

export type Binary = keyof typeof BINARY;
export type Unary = keyof typeof UNARY;
export type Elementary = keyof typeof FUNCTIONS;
export type Comparison = keyof typeof COMPARISONS;

const isShort = (exponent: number) => (2 * exponent) % 1 === 0 && Math.abs(exponent) <= 8;

/** Arithmetic in a world of one precision. */
export class Arithmetic {
  constructor(readonly round: (value: number) => number) {}

  binary(op: Binary, a: Real, b: Real): Real {
    if (op === 'mul' && (a.isZero || b.isZero)) return ZERO;
    if (op === 'div' && a.isZero) return ZERO;
    if (op === 'add' && a.isZero) return b;
    if ((op === 'add' || op === 'sub') && b.isZero) return a;
    if (op === 'sub' && a.isZero) return this.unary('negate', b);
    return this.#apply(BINARY[op], [a, b]);
  }

  unary(op: Unary, a: Real): Real {
    return a.isZero && op !== 'floor' ? ZERO : this.#apply(UNARY[op], [a]);
  }

  call(name: Elementary, args: readonly Real[]): Real {
    if (name === 'pow' && !args[0].isUniform && args[1].isConstant && isShort(args[1].value)) {
      return this.#products(args[0], args[1].value);
    }
    const value = (FUNCTIONS[name] as (...numbers: number[]) => number)(...args.map((arg) => arg.value));
    return args.every((arg) => arg.isUniform) ? uniform(value) : own(this.round(value));
  }

  /** The square root first, then the base to the powers of two that its exponent consists of. */
  #products(base: Real, exponent: number): Real {
    let result = exponent % 1 === 0 ? undefined : this.unary('sqrt', base);
    let square = base;
    for (const bit of [1, 2, 4, 8]) {
      if ((Math.floor(Math.abs(exponent)) & bit) !== 0)
        result = result === undefined ? square : this.binary('mul', result, square);
      square = this.binary('mul', square, square);
    }
    return exponent < 0 ? this.binary('div', known(1), result ?? known(1)) : (result ?? known(1));
  }

  compare(op: Comparison, a: Real, b: Real): Truth {
    const isUniform = a.isUniform && b.isUniform;
    const [x, y] = isUniform ? [a.value, b.value] : [this.#inLane(a), this.#inLane(b)];
    return { holds: COMPARISONS[op](x, y), isUniform };
  }

  /** Not for a condition of bodies between two equal numbers that are the same for all: that is one number. */
  select(condition: Truth, a: Real, b: Real): Real {
    if (a.isZero && (b.isZero || (b.isConstant && Object.is(b.value, 0)))) return ZERO;
    const chosen = condition.holds ? a : b;
    if (condition.isUniform && a.isUniform && b.isUniform) return uniform(chosen.value);
    return own(this.#inLane(chosen));
  }

  each(op: Binary, a: Triple, b: Triple): Triple {
    return [0, 1, 2].map((i) => this.binary(op, a[i], b[i])) as unknown as Triple;
  }

  scale(op: 'mul' | 'div', a: Triple, factor: Real): Triple {
    return this.each(op, a, [factor, factor, factor]);
  }

  dot(a: Triple, b: Triple): Real {
    const [x, y, z] = this.each('mul', a, b);
    return this.binary('add', this.binary('add', x, y), z);
  }

  cross(a: Triple, b: Triple): Triple {
    const minor = (i: number, j: number) =>
      this.binary('sub', this.binary('mul', a[i], b[j]), this.binary('mul', a[j], b[i]));
    return [minor(1, 2), minor(2, 0), minor(0, 1)];
  }

  length(a: Triple): Real {
    return this.unary('sqrt', this.dot(a, a));
  }

  normalize(a: Triple): Triple {
    const length = this.length(a);
    const isLong = this.compare('less', known(0), length);
    return a.map((each) => this.select(isLong, this.binary('div', each, length), known(0))) as unknown as Triple;
  }

  #apply(of: (a: number, b: number) => number, args: readonly Real[]): Real {
    const [a, b] = args;
    if (!args.every((arg) => arg.isUniform)) return own(this.round(of(this.#inLane(a), b && this.#inLane(b))));
    const value = of(a.value, b?.value);
    return args.every((arg) => arg.isConstant) ? known(value) : uniform(value);
  }

  #inLane(a: Real): number {
    return this.round(a.value);
  }
}
