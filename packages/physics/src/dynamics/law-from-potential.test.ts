import { describe, expect, test } from 'vitest';
import { type Body, forceOn, lawOn, single, slope } from '../../../../test/support/laws.ts';
import { Charge } from '../components/charge.ts';
import {
  axial3,
  type Force,
  lawFromPotential,
  lennardJones,
  PhysicsError,
  type PhysicsWorld,
  powerLaw,
  type ScalarSymbol,
  scalar,
  select,
  table,
  uniformGravity,
  type VectorSymbol,
  vec3,
  vector,
  yukawa,
} from '../index.ts';
import { allocate } from '../memory/arena.ts';
import { resource } from '../memory/resource.ts';

const POSITION_BOUNDS = [
  { x: 0.7, y: -0.4, z: 0.3 },
  { x: -1.6, y: 0.2, z: 0.9 },
  { x: 0.3, y: 1.9, z: -1.1 },
];

const bodyAt = (at: { x: number; y: number; z: number }, dimensions: 2 | 3): Body => ({
  mass: 3,
  charge: -0.5,
  position: dimensions === 2 ? { x: at.x, y: at.y } : at,
  ...(dimensions === 2 ? { rotation: 0.3 } : { orientation: { x: 0.3, y: -0.2, z: 0.5, w: 1 } }),
});

/** The two forces are derived differently, so they differ by some tens of roundings of the largest term. */
function expectSame(derived: Force, written: Force): void {
  for (const dimensions of [2, 3] as const) {
    for (const at of POSITION_BOUNDS) {
      const [a, b] = [derived, written].map((law) => lawOn(law, bodyAt(at, dimensions), { dimensions }));
      const size = Math.hypot(b.x, b.y, b.z);
      expect(Math.hypot(a.x - b.x, a.y - b.y, a.z - b.z)).toBeLessThan(1e-13 * size);
      expect(size).toBeGreaterThan(0);
    }
  }
}

describe('the law of a potential equals the hand-written law', () => {
  test('gravity', () => {
    const law = lawFromPotential({
      name: 'gravity',
      parameters: { g: vector('m/s²') },
      potential: ({ position, mass }, { g }) => mass.mul(g.dot(position)).negate(),
    });
    const g = { x: 1, y: -9, z: 2 };
    expectSame(law({ g }), uniformGravity(g));
  });

  test('a spring to a point', () => {
    const law = lawFromPotential({
      name: 'spring',
      parameters: { k: scalar('N/m'), centre: vector('m') },
      potential: ({ position, mass }, { k, centre }) => mass.mul(k).mul(position.sub(centre).lengthSquared()).mul(0.5),
    });
    const centre = { x: 0.2, y: 0.1, z: -0.4 };
    expectSame(law({ k: 7, centre }), powerLaw({ strength: -7, exponent: 1, centre }));
  });

  test('Lennard-Jones', () => {
    const law = lawFromPotential({
      name: 'Lennard-Jones',
      parameters: { depth: scalar('J/kg'), diameter: scalar('m') },
      potential({ position, mass }, { depth, diameter }) {
        const u = diameter.div(position.length()).pow(6);
        return mass.mul(depth).mul(4).mul(u.square().sub(u));
      },
    });
    const given = { depth: 2, diameter: 1.1 };
    expectSame(law(given), lennardJones(given));
  });

  test('Yukawa', () => {
    const law = lawFromPotential({
      name: 'Yukawa',
      reads: { q: Charge },
      parameters: { strength: scalar('N m²/C'), range: scalar('m') },
      potential({ position, q }, { strength, range }) {
        const r = position.length();
        return q.mul(strength).mul(r.div(range).negate().exp()).div(r);
      },
    });
    const given = { strength: 5, range: 0.8 };
    expectSame(law(given), yukawa(given));
  });
});

describe('the derivative of', () => {
  const rowsAt = resource((world: PhysicsWorld) => {
    const at = allocate(world.internal.arena, 48, 'rows');
    new Float64Array(world.memory.buffer, at, 6).set([0.1, 0.9, 2, -1.1, 0.4, -3]);
    return { at, count: 2 };
  });
  const parameters = { a: vector('m'), k: scalar(''), rows: table(['x', 'y', 'q'], rowsAt) };

  interface Symbols {
    readonly a: VectorSymbol;
    readonly k: ScalarSymbol;
    readonly rows: {
      sum(term: (row: { x: ScalarSymbol; y: ScalarSymbol; q: ScalarSymbol }) => VectorSymbol): VectorSymbol;
      sum(term: (row: { x: ScalarSymbol; y: ScalarSymbol; q: ScalarSymbol }) => ScalarSymbol): ScalarSymbol;
    };
  }

  function potentialLaw(
    potential: (r: VectorSymbol, given: Symbols, rotate: (v: VectorSymbol) => VectorSymbol) => ScalarSymbol,
  ): Force {
    const law = lawFromPotential({
      name: 'potential',
      parameters,
      potential: ({ position, rotate }, given) => potential(position, given, rotate),
    });
    return law({ a: { x: 0.4, y: -0.3, z: 0.8 }, k: 1.3 });
  }

  const POTENTIALS: Record<string, Parameters<typeof potentialLaw>[0]> = {
    'sums and products': (r, { a, k }) => r.x.mul(r.y).add(r.z.mul(k)).sub(r.dot(a).negate()).mul(r.x.sub(2)),
    quotients: (r, { a, k }) => r.x.add(k).div(r.sub(a).lengthSquared().add(1)),
    'roots and sizes': (r, { k }) => r.lengthSquared().add(k).sqrt().add(r.x.abs()).add(r.y.abs().mul(2)),
    'elementary functions': (r) => r.x.sin().mul(r.y.cos()).add(r.x.mul(0.3).exp()).add(r.lengthSquared().log()),
    powers: (r, { k }) => r.length().pow(1.5).add(r.length().pow(k)).add(k.pow(r.x)).add(r.x.pow(2)).add(r.y.pow(1)),
    angles: (r) => r.y.atan2(r.x).mul(r.x),
    'smaller and larger': (r, { k }) => r.x.min(r.y.mul(k)).add(r.x.square().max(r.y)),
    choices: (r) => select(r.x.less(0), r.x.square(), select(r.y.greater(0), r.length(), r.x.mul(3))),
    'chosen vectors': (r, { a }) => select(r.x.less(0), r.mul(2), a.sub(r)).dot(vec3(r.y, 1, r.x)),
    'choices within choices': (r, { k }) => {
      let u = r.x.square();
      for (let i = 0; i < 4; i++) u = u.min(u.mul(2).sub(r.y.mul(0.1 * i))).add(r.z.mul(k));
      return u.max(u.square());
    },
    'chosen vectors within others': (r, { a }) => {
      let v = r;
      for (let i = 0; i < 3; i++) v = select(r.x.less(i - 1), v.mul(r.y), v.cross(a));
      return v.dot(a).add(select(r.y.less(0), v.x, v.lengthSquared()));
    },
    'steps, which have none': (r, { k }) => r.x.floor().add(r.y.round()).mul(r.x).mul(k),
    'lengths and directions': (r, { a }) => r.sub(a).normalize().dot(a).add(r.sub(a).length()),
    'vector products': (r, { a }) =>
      r
        .cross(a)
        .lengthSquared()
        .add(r.cross(vec3(r.y, r.x, 1)).z),
    'scaled vectors': (r, { a }) => r.mul(r.x).div(r.y.square().add(1)).negate().dot(a.add(r)),
    'vectors from numbers': (r, { a }) => vec3(r.x.mul(r.y), r.y, r.x).dot(axial3(r.y, 2, r.x).add(a)),
    'turned vectors': (r, { a }, rotate) => rotate(r.mul(r.x)).dot(a),
    'sums over tables': (r, { rows, k }) =>
      rows.sum(({ x, y, q }) => q.div(r.sub(vec3(x, y)).length())).mul(r.x.mul(k)),
    'squares of sums of vectors': (r, { rows }) => rows.sum(({ x, y, q }) => r.sub(vec3(x, y)).mul(q)).lengthSquared(),
    'products of sums of vectors': (r, { rows }) => {
      const [a, b] = [0.3, 2].map((k) => rows.sum(({ x, y, q }) => vec3(r.x.mul(x), r.y.mul(k), r.z.mul(q)).mul(y)));
      return a.dot(b).add(a.length());
    },
    'sums of vectors': (r, { rows }) => rows.sum(({ x, y, q }) => r.sub(vec3(x, y)).mul(q.mul(r.x))).dot(r),
  };

  test.each(Object.keys(POTENTIALS))('%s', (name) => {
    for (const dimensions of [2, 3] as const) {
      for (const at of POSITION_BOUNDS) {
        const { world, eid } = single([potentialLaw(POTENTIALS[name])], bodyAt(at, dimensions), { dimensions });
        const force = forceOn(world, eid);
        const fall = slope(world, eid, 1e-5);
        // Central differences err by h² times the third derivative, which is at most some hundreds here.
        expect(Math.abs(force.x - fall.x), `x in ${dimensions}D`).toBeLessThan(1e-7);
        expect(Math.abs(force.y - fall.y), `y in ${dimensions}D`).toBeLessThan(1e-7);
        if (dimensions === 3) expect(Math.abs(force.z - fall.z)).toBeLessThan(1e-7);
      }
    }
  });

  test('choices shared by many branches', () => {
    // Without sharing this would differentiate 2^60 branches.
    const folded = potentialLaw((r) => {
      let u = r.x;
      for (let i = 0; i < 60; i++) u = u.max(u.negate()).sub(1 + i / 64);
      return u;
    });
    for (const x of [0.3, -7.7]) {
      let [u, slope] = [x, 1];
      for (let i = 0; i < 60; i++) {
        if (u < 0) slope = -slope;
        u = Math.abs(u) - (1 + i / 64);
      }
      expect(lawOn(folded, { position: { x } }).x).toBe(-slope);
    }
  });

  test('the gradient is zero where no derivative exists', () => {
    const cusps = potentialLaw((r) => r.length().add(r.lengthSquared().sqrt()).add(r.x.abs()));
    expect(lawOn(cusps, { position: {} })).toMatchObject({ x: 0, y: 0 });
  });

  test('powers of a distance have no gradient at distance 0', () => {
    const square = (r: VectorSymbol) => r.lengthSquared();
    for (const exponent of [0, 0.5, 0.7, 0.75, 1, 1.2]) {
      expect(
        lawOn(
          potentialLaw((r) => square(r).pow(exponent).add(r.x)),
          { position: {} },
        ),
      ).toMatchObject({ x: -1, y: 0 });
      const byParameter = potentialLaw((r, { k }) =>
        square(r)
          .pow(k.mul(exponent / 1.3))
          .add(r.x),
      );
      expect(lawOn(byParameter, { position: {} })).toMatchObject({ x: -1, y: 0 });
    }
    const byPosition = potentialLaw((r) => r.x.pow(r.y.add(2)).add(r.y));
    expect(lawOn(byPosition, { position: {} })).toMatchObject({ x: 0, y: -1 });
    expect(
      lawOn(
        potentialLaw((r) => r.x.pow(-1)),
        { position: { x: -2 } },
      ).x,
    ).toBeCloseTo(0.25, 14);
  });

  test('the unselected branch may be infinite', () => {
    const core = potentialLaw((r) => select(r.length().less(1), r.lengthSquared(), r.length().log()));
    expect(lawOn(core, { position: {} })).toMatchObject({ x: 0, y: 0 });
    expect(lawOn(core, { position: { x: 2 } }).x).toBeCloseTo(-0.5, 14);
  });
});

test('invalid potentials are rejected', () => {
  const of = (potential: never) => () => lawFromPotential({ name: 'bad', potential });
  expect(of((({ velocity }: { velocity: VectorSymbol }) => velocity.lengthSquared()) as never)).toThrow(
    /depend on velocity/,
  );
  expect(of((({ mass }: { mass: ScalarSymbol }) => mass) as never)).toThrow(/does not depend on position/);
  expect(of((({ position }: { position: VectorSymbol }) => position) as never)).toThrow(PhysicsError);
  expect(of(3 as never)).toThrow(PhysicsError);
});
