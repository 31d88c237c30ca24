// Compares random compiled laws with an interpreter on plain numbers: the bits must be equal for every body.
import fc from 'fast-check';
import { describe, test } from 'vitest';
import {
  Arithmetic,
  known,
  own,
  type Real,
  type Triple,
  uniform,
  ZERO,
} from '../../../../test/support/law-interpreter.ts';
import {
  columnsOfThree,
  crowd,
  expectSameBits,
  forcesNow,
  lawOf,
  rounderOf,
  THREE_READS,
  WORLD_KINDS,
  type WorldKind,
} from '../../../../test/support/law-lab.ts';
import { type Choice, type MadeScalar, type MadeVector, Twins, zip } from '../../../../test/support/law-twins.ts';
import {
  axial3,
  axialVector,
  type PhysicsWorld,
  type ScalarSymbol,
  scalar,
  type VectorSymbol,
  vector,
} from '../index.ts';
import { Scalar } from './expression.ts';

const PARAMETERS = { p: 0.1, q: -2.7, u: { x: 0.3, y: -1.7, z: 0.9 }, w: { x: 1.3, y: 0, z: -0.7 } } as const;
const CONSTANTS = [0.1, -1.25, 3, 1, 0.5, -0] as const;

interface Body {
  readonly position: VectorSymbol;
  readonly velocity: VectorSymbol;
  readonly mass: ScalarSymbol;
  readonly a: ScalarSymbol;
  readonly b: ScalarSymbol;
  readonly c: ScalarSymbol;
}

interface Given {
  readonly p: ScalarSymbol;
  readonly q: ScalarSymbol;
  readonly u: VectorSymbol;
  readonly w: VectorSymbol;
}

/** The leaves of every law: columns first, then parameters and constants. */
function leaves(twins: Twins, world: PhysicsWorld, eids: readonly number[], body: Body, given: Given): void {
  const { Position, Velocity, Mass } = world.components;
  const columns = columnsOfThree(world);
  const isFlat = world.dimensions === 2;
  const each = (of: (eid: number) => Real) => eids.map(of);
  const triples = (of: Record<'x' | 'y' | 'z', ArrayLike<number>>) =>
    eids.map((eid): Triple => [own(of.x[eid]), own(of.y[eid]), isFlat ? ZERO : own(of.z[eid])]);
  const { p, q, u, w } = PARAMETERS;
  twins.vector(body.position, triples(Position));
  twins.vector(body.velocity, triples(Velocity));
  for (const name of ['a', 'b', 'c'] as const)
    twins.scalar(
      body[name],
      each((eid) => own(columns[name][eid])),
    );
  twins.scalar(
    body.mass,
    each((eid) => own(Mass.value[eid])),
  );
  twins.scalar(
    given.p,
    each(() => uniform(p)),
  );
  twins.scalar(
    given.q,
    each(() => uniform(q)),
  );
  for (const value of CONSTANTS)
    twins.scalar(
      new Scalar('constant', [], value),
      each(() => known(value)),
    );
  // A zero axis of a constant vector is omitted, like z in 2D; an axial vector has only z in 2D.
  const flatU: Triple = [uniform(u.x), uniform(u.y), isFlat ? ZERO : uniform(u.z)];
  const axialW: Triple = [isFlat ? ZERO : uniform(w.x), ZERO, uniform(w.z)];
  twins.vector(
    given.u,
    eids.map(() => flatU),
  );
  twins.vector(
    given.w,
    eids.map(() => axialW),
  );
  twins.condition(
    body.a.less(body.b),
    eids.map((eid) => ({ holds: columns.a[eid] < columns.b[eid], isUniform: false })),
  );
  twins.condition(
    given.p.less(given.q),
    eids.map(() => ({ holds: p < q, isUniform: true })),
  );
}

/** Numbers of all kinds, different in each lane: most are ordinary, some are special. */
function fill(world: PhysicsWorld, eids: readonly number[]): void {
  const { Position, Velocity, Mass } = world.components;
  const { a, b, c } = columnsOfThree(world);
  eids.forEach((eid, i) => {
    for (const [n, axis] of (world.dimensions === 2 ? (['x', 'y'] as const) : (['x', 'y', 'z'] as const)).entries()) {
      Position[axis][eid] = ((i * 7 + n * 3) % 11) / 3 - 1.7;
      Velocity[axis][eid] = i === 5 ? 0 : ((i * 5 + n) % 13) / 7 - 0.9;
    }
    Mass.value[eid] = (i + 1) / 3;
    a[eid] = [-0.3, 0, -0, 2.6, NaN, 1e20, -7.1, Infinity][i % 8];
    b[eid] = [1.1, -0.3, 0, 40.3, -2.2, 1e-20][i % 6];
    c[eid] = (i - 6) * 0.37;
  });
}

function checkLaw(kind: WorldKind, choices: readonly Choice[]): void {
  const stage = crowd([], kind);
  const { world, eids } = stage;
  fill(world, eids);
  const twins = new Twins(new Arithmetic(rounderOf(kind.precision)));
  const last = { force: undefined as MadeVector | undefined, torque: undefined as MadeVector | undefined };
  const force = (body: Body, given: Given) => {
    leaves(twins, world, eids, body, given);
    for (const choice of choices) twins.apply(choice);
    last.force = twins.vectors.at(-1);
    last.torque = twins.vectors.at(-2);
    // The result also depends on the conditions and scalars.
    const [s, t] = [twins.scalars.at(-1), twins.scalars.at(-2)] as [MadeScalar, MadeScalar];
    const made = axial3(s.symbol, t.symbol, s.symbol);
    last.torque = { symbol: made, values: zip(s, t, (x, y): Triple => [x, y, x]), depth: 0 };
    return (last.force as MadeVector).symbol;
  };
  const { p, q, u, w } = PARAMETERS;
  const torque = () => (last.torque as MadeVector).symbol;
  const parameters = { p: scalar(''), q: scalar(''), u: vector(''), w: axialVector('') };
  world.forces.push(lawOf({ reads: THREE_READS, parameters, force, torque }, { p, q, u, w }));
  const got = forcesNow(world);
  const { round } = twins.arithmetic;
  eids.forEach((eid, i) => {
    for (const [n, axis] of (['x', 'y', 'z'] as const).entries()) {
      const wanted = round((last.force as MadeVector).values[i][n].value);
      if (n < kind.dimensions) expectSameBits(got[axis][eid], wanted, `force.${axis} of body ${i}`);
      const turning = round((last.torque as MadeVector).values[i][n].value);
      if (n === 2 || kind.dimensions === 3) {
        expectSameBits(world.scratch.torque[axis][eid], turning, `torque.${axis} of body ${i}`);
      }
    }
  });
}

const place = fc.nat(1000);
const choice: fc.Arbitrary<Choice> = fc.record({ op: place, args: fc.tuple(place, place, place) });

describe.each(WORLD_KINDS)('in a world of $dimensions dimensions, $precision', (kind) => {
  test('random laws give the bits of an interpreter', () => {
    const choices = fc.array(choice, { minLength: 3, maxLength: 30, size: 'max' });
    fc.assert(
      fc.property(choices, (list) => checkLaw(kind, list)),
      { seed: 20250611, numRuns: 150 },
    );
  });
});
