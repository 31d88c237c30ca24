// Compares every operation of the expression language in a world with the same operation on plain numbers, bitwise and
// in every lane.
import { describe, expect, test } from 'vitest';
import { Arithmetic, known, own } from '../../../../test/support/law-interpreter.ts';
import {
  columnsOfThree,
  crowd,
  expectSameBits,
  forcesNow,
  lawOf,
  rounderOf,
  THREE_READS,
  WORLD_KINDS,
} from '../../../../test/support/law-lab.ts';
import { atan2, cos, defineLaw, exp, log, pow, type ScalarSymbol, scalar, select, sin, vec3 } from '../index.ts';
import { Scalar } from './expression.ts';

type Symbols = Readonly<Record<'a' | 'b' | 'c', ScalarSymbol>>;

/** An operation on symbols, and the same operation on numbers. */
interface Operation {
  readonly of: (symbols: Symbols) => ScalarSymbol;
  readonly plain: (a: number, b: number, c: number) => number;
}

/** Rounds to the nearest integer, ties to even, as `f64.nearest` does. */
function nearest(x: number): number {
  const size = Math.abs(x);
  if (!(size < 2 ** 52)) return x;
  const rounded = size + 2 ** 52 - 2 ** 52;
  return x < 0 || Object.is(x, -0) ? -rounded : rounded;
}

const one = (condition: boolean) => (condition ? 1 : 0);

const OPERATIONS: Readonly<Record<string, Operation>> = {
  add: { of: ({ a, b }) => a.add(b), plain: (a, b) => a + b },
  sub: { of: ({ a, b }) => a.sub(b), plain: (a, b) => a - b },
  mul: { of: ({ a, b }) => a.mul(b), plain: (a, b) => a * b },
  div: { of: ({ a, b }) => a.div(b), plain: (a, b) => a / b },
  'division by a power of two': { of: ({ a }) => a.div(-8), plain: (a) => a / -8 },
  min: { of: ({ a, b }) => a.min(b), plain: (a, b) => (b < a ? b : a) },
  max: { of: ({ a, b }) => a.max(b), plain: (a, b) => (a < b ? b : a) },
  negate: { of: ({ a }) => a.negate(), plain: (a) => -a },
  'twice negated': { of: ({ a }) => a.negate().negate(), plain: (a) => a },
  'sum with a negative': { of: ({ a, b }) => a.add(b.negate()), plain: (a, b) => a - b },
  'negative and a sum': { of: ({ a, b }) => a.negate().add(b), plain: (a, b) => -a + b },
  'difference with a negative': { of: ({ a, b }) => a.sub(b.negate()), plain: (a, b) => a + b },
  'product of negatives': { of: ({ a, b }) => a.negate().mul(b.negate()), plain: (a, b) => a * b },
  'product with a negative': { of: ({ a, b }) => a.mul(b.negate()), plain: (a, b) => -(a * b) },
  abs: { of: ({ a }) => a.abs(), plain: (a) => Math.abs(a) },
  sqrt: { of: ({ a }) => a.sqrt(), plain: (a) => Math.sqrt(a) },
  floor: { of: ({ a }) => a.floor(), plain: (a) => Math.floor(a) },
  round: { of: ({ a }) => a.round(), plain: nearest },
  square: { of: ({ a }) => a.square(), plain: (a) => a * a },
  sin: { of: ({ a }) => a.sin(), plain: (a) => sin(a) },
  cos: { of: ({ a }) => a.cos(), plain: (a) => cos(a) },
  exp: { of: ({ a }) => a.exp(), plain: (a) => exp(a) },
  log: { of: ({ a }) => a.log(), plain: (a) => log(a) },
  pow: { of: ({ a, b }) => a.pow(b), plain: (a, b) => pow(a, b) },
  atan2: { of: ({ a, b }) => a.atan2(b), plain: (a, b) => atan2(a, b) },
  less: { of: ({ a, b }) => select(a.less(b), 1, 0), plain: (a, b) => one(a < b) },
  lessOrEqual: { of: ({ a, b }) => select(a.lessOrEqual(b), 1, 0), plain: (a, b) => one(a <= b) },
  greater: { of: ({ a, b }) => select(a.greater(b), 1, 0), plain: (a, b) => one(a > b) },
  greaterOrEqual: { of: ({ a, b }) => select(a.greaterOrEqual(b), 1, 0), plain: (a, b) => one(a >= b) },
  equals: { of: ({ a, b }) => select(a.equals(b), 1, 0), plain: (a, b) => one(a === b) },
  and: { of: ({ a, b, c }) => select(a.less(b).and(b.less(c)), 1, 2), plain: (a, b, c) => (a < b && b < c ? 1 : 2) },
  or: { of: ({ a, b, c }) => select(a.less(b).or(b.less(c)), 1, 2), plain: (a, b, c) => (a < b || b < c ? 1 : 2) },
  not: { of: ({ a, b }) => select(a.less(b).not(), 1, 2), plain: (a, b) => (a < b ? 2 : 1) },
  select: { of: ({ a, b, c }) => select(a.less(b), c, a), plain: (a, b, c) => (a < b ? c : a) },
  'select or zero': { of: ({ a, b, c }) => select(a.less(b), c, 0), plain: (a, b, c) => (a < b ? c : 0) },
  'select or minus zero': { of: ({ a, b, c }) => select(a.less(b), c, -0), plain: (a, b, c) => (a < b ? c : -0) },
};

const SPECIAL = [0, -0, 0.5, -0.5, 1.5, 2.5, -2.5, 1, -1, NaN, Infinity, -Infinity, 1e-30, -1e30, 0.1, 3, 1e6];

/** Fills the lanes with special values in every combination, then with values of long mantissas. */
function fill(world: Parameters<typeof columnsOfThree>[0], eids: readonly number[], round: number): void {
  const { a, b, c } = columnsOfThree(world);
  eids.forEach((eid, i) => {
    a[eid] = SPECIAL[i % SPECIAL.length];
    b[eid] = round < SPECIAL.length ? SPECIAL[(i + round) % SPECIAL.length] : (i + 1) / 7;
    c[eid] = (i - 5) / (3 + round);
    if (round >= SPECIAL.length) a[eid] = (i - 8) * (0.7 + round / 9);
  });
}

const ROUNDS = Array.from({ length: SPECIAL.length + 4 }, (_, round) => round);

describe.each(WORLD_KINDS)('in a world of $dimensions dimensions, $precision', (kind) => {
  const round = rounderOf(kind.precision);

  test.each(Object.keys(OPERATIONS))('%s of columns gives the bits of plain numbers in every lane', (name) => {
    const { of, plain } = OPERATIONS[name];
    // The operands are permuted along y and z, so that other lanes compute other pairs.
    const force = ({ a, b, c }: Symbols) => vec3(of({ a, b, c }), of({ a: b, b: c, c: a }), of({ a: c, b: a, c: b }));
    const { world, eids } = crowd([lawOf({ reads: THREE_READS, force })], kind);
    for (const r of ROUNDS) {
      fill(world, eids, r);
      const got = forcesNow(world);
      const columns = columnsOfThree(world);
      for (const eid of eids) {
        const [a, b, c] = [columns.a[eid], columns.b[eid], columns.c[eid]];
        const what = `${name} of ${a}, ${b}, ${c}`;
        expectSameBits(got.x[eid], round(plain(a, b, c)), what);
        expectSameBits(got.y[eid], round(plain(b, c, a)), `${what}, y`);
        expectSameBits(got.z[eid], kind.dimensions === 2 ? 0 : round(plain(c, a, b)), `${what}, z`);
      }
    }
  });

  test.each(Object.keys(OPERATIONS))('%s of parameters is computed in doubles and rounded once', (name) => {
    const { of, plain } = OPERATIONS[name];
    const make = defineLaw({
      name,
      parameters: { a: scalar('', {}), b: scalar('', {}), c: scalar('', {}) },
      force: (_body, { a, b, c }) => vec3(of({ a, b, c }), of({ a: b, b: a, c })),
    });
    for (const [a, b, c] of [
      [0.1, 0.7, -3.3],
      [2.5, -0.5, 1e-3],
      [-0, 0, 7],
      [1.1, 1.1, 5.7],
    ]) {
      const { world, eids } = crowd([make({ a, b, c })], kind);
      const got = forcesNow(world);
      expectSameBits(got.x[eids[3]], round(plain(a, b, c)), `${name} of ${a}, ${b}, ${c}`);
      expectSameBits(got.y[eids[4]], round(plain(b, a, c)), `${name} of ${b}, ${a}, ${c}`);
    }
  });

  test.each(Object.keys(OPERATIONS))('%s of constants is what a program would compute, rounded once', (name) => {
    const { of, plain } = OPERATIONS[name];
    const [a, b, c] = [0.7, -2.5, 1 / 3];
    const known = (value: number) => new Scalar('constant', [], value);
    const { world, eids } = crowd(
      [lawOf({ force: () => vec3(of({ a: known(a), b: known(b), c: known(c) }), 0) })],
      kind,
    );
    expectSameBits(forcesNow(world).x[eids[0]], round(plain(a, b, c)), name);
  });

  // A root and six products of a power of 7.5, and a division, are off by half a unit in the last place each, and products
  // of equal factors double what these are off.
  test.each([0.5, 1, 1.5, 2, 3, 4.5, 7.5, 8, -0.5, -1, -1.5, -3, -8])(
    'the power %s is made of products, and within five units in the last place',
    (exponent) => {
      const law = lawOf({ reads: THREE_READS, force: ({ a }: Symbols) => vec3(a.abs().pow(exponent), 0) });
      const { world, eids } = crowd([law], kind);
      fill(world, eids, 23);
      const got = forcesNow(world);
      const unit = kind.precision === 'f32' ? 2 ** -23 : 2 ** -52;
      for (const eid of eids) {
        const a = Math.abs(columnsOfThree(world).a[eid]);
        const products = new Arithmetic(round).call('pow', [own(a), known(exponent)]);
        expectSameBits(got.x[eid], products.value, `${a} to the power ${exponent}`);
        if (a > 0) expect(Math.abs(got.x[eid] / pow(a, exponent) - 1), `${a}`).toBeLessThan(5 * unit);
      }
    },
  );

  test('a number combined with a column is rounded first, but a function receives it in f64', () => {
    const p = 0.1;
    const force = ({ a }: Symbols, { p: k }: { p: ScalarSymbol }) => vec3(a.mul(k), a.abs().pow(k));
    const { world, eids } = crowd([lawOf({ reads: THREE_READS, parameters: { p: scalar('') }, force }, { p })], kind);
    fill(world, eids, 19);
    const got = forcesNow(world);
    for (const eid of eids) {
      const a = columnsOfThree(world).a[eid];
      expectSameBits(got.x[eid], round(a * round(p)), `${a} times ${p}`);
      expectSameBits(got.y[eid], round(pow(Math.abs(a), p)), `${a} to the power ${p}`);
    }
  });

  test('ids, time and membership are available for each body', () => {
    const { Charge, Inertia } = { Charge: THREE_READS.a, Inertia: THREE_READS.b };
    const force = (body: { entity: ScalarSymbol; time: ScalarSymbol; has: (spec: object) => never }) =>
      vec3(body.entity, select(body.has(Charge), body.time, select(body.has(Inertia), 7, 8)));
    const { world, eids } = crowd([lawOf({ force })], kind);
    const got = forcesNow(world, 0.3);
    for (const eid of eids) {
      expect(got.x[eid]).toBe(eid);
      expect(got.y[eid]).toBe(round(0.3));
    }
  });
});
