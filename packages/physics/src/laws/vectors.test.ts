// Vectors of laws in 2D and 3D.
import { describe, expect, test } from 'vitest';
import { crowd, expectSameBits, forcesNow, lawOf, rounderOf, WORLD_KINDS } from '../../../../test/support/law-lab.ts';
import {
  axial3,
  axialVector,
  type BodySymbols,
  cos,
  createPhysicsWorld,
  defineLaw,
  select,
  semiImplicitEuler,
  sin,
  spawn,
  step,
  type VectorSymbol,
  vec3,
  vector,
} from '../index.ts';

type Kind = (typeof WORLD_KINDS)[number];
type Made = (body: BodySymbols) => VectorSymbol;

const flat = WORLD_KINDS.filter(({ dimensions }) => dimensions === 2);
const deep = WORLD_KINDS.filter(({ dimensions }) => dimensions === 3);
const none: Made = ({ velocity }) => velocity.mul(0);

/** Applies a law to position and velocity, for bodies that differ in both; the third is at rest. */
function onVectors(kind: Kind, force: Made, torque: Made = none) {
  const { world, eids } = crowd([lawOf({ force, torque })], kind);
  const { Position, Velocity } = world.components;
  const axes = (['x', 'y', 'z'] as const).slice(0, kind.dimensions);
  eids.forEach((eid, i) => {
    axes.forEach((axis, n) => {
      Position[axis][eid] = (i - 4) * 0.3 + n;
      Velocity[axis][eid] = i === 2 ? 0 : 1.7 - i * (n + 1) * 0.21;
    });
  });
  const of = ({ x, y, z }: Record<'x' | 'y' | 'z', ArrayLike<number>>, eid: number) => [x[eid], y[eid], z[eid]];
  const got = forcesNow(world);
  return eids.map((eid) => ({
    r: of(Position, eid),
    v: of(Velocity, eid),
    force: of(got, eid),
    torque: of(world.scratch.torque, eid),
  }));
}

function expectVector(got: readonly number[], wanted: readonly number[]): void {
  for (const [i, value] of wanted.entries()) expectSameBits(got[i], value, `component ${i}`);
}

describe.each(WORLD_KINDS)('in $dimensions dimensions, $precision', (kind) => {
  const round = rounderOf(kind.precision);
  const isFlat = kind.dimensions === 2;

  test('dot sums the products in the order of the axes', () => {
    for (const { r, v, force } of onVectors(kind, ({ position, velocity }) => vec3(position.dot(velocity), 0))) {
      const plane = round(round(r[0] * v[0]) + round(r[1] * v[1]));
      expectSameBits(force[0], isFlat ? plane : round(plane + round(r[2] * v[2])), 'r·v');
    }
  });

  test('the cross product of two vectors is about z in the plane, and along all axes in space', () => {
    for (const { r, v, torque } of onVectors(kind, none, ({ position, velocity }) => position.cross(velocity))) {
      const minor = (i: number, j: number) => round(round(r[i] * v[j]) - round(r[j] * v[i]));
      if (isFlat) expectSameBits(torque[2], minor(0, 1), 'z');
      else expectVector(torque, [minor(1, 2), minor(2, 0), minor(0, 1)]);
    }
  });

  test('normalising keeps a zero vector zero and gives any other vector length 1', () => {
    const made = onVectors(kind, ({ velocity }) => velocity.normalize());
    expect(made[2].force).toEqual([0, 0, 0]);
    for (const { force } of made.filter((_, i) => i !== 2)) {
      expect(Math.hypot(...force)).toBeCloseTo(1, kind.precision === 'f32' ? 6 : 14);
    }
  });

  test('an axial vector is about z alone in the plane: a magnetic force turns to the right', () => {
    const law = defineLaw({
      name: 'gyration',
      parameters: { field: axialVector('T') },
      force: ({ velocity }, { field }) => velocity.cross(field),
    });
    const { world, eids } = crowd([law({ field: { x: 5, y: 7, z: 2 } })], kind);
    world.components.Velocity.x[eids[3]] = 3;
    const { x, y, z } = forcesNow(world);
    const wanted = isFlat ? [0, -6, 0] : [0, -6, 21];
    expect([x[eids[3]], y[eids[3]], z[eids[3]]].map((value) => value + 0)).toEqual(wanted);
  });
});

describe.each(flat)('in the plane, $precision', (kind) => {
  const round = rounderOf(kind.precision);

  test('polar vectors have no z component in any operation', () => {
    const law = defineLaw({
      name: 'z of everything',
      parameters: { wind: vector('m/s') },
      force: ({ position, velocity, startVelocity, force }, { wind }) =>
        vec3(
          [vec3(1, 2, 3), position, velocity, startVelocity, force, wind].reduce((sum, v) => sum.add(v.z), velocity.z),
          4,
          5,
        ),
    });
    const { world, eids } = crowd([law({ wind: { z: 9 } })], kind);
    world.components.Position.z[eids[1]] = 7;
    const { x, y, z } = forcesNow(world);
    expect([x[eids[1]], y[eids[1]], z[eids[1]]]).toEqual([0, 4, 0]);
  });

  test('axial3 keeps its z, and its product with a vector stays in the plane', () => {
    for (const { v, force } of onVectors(kind, ({ velocity }) => axial3(0, 0, 2).cross(velocity))) {
      expect(force.map((value) => value + 0)).toEqual([round(-2 * v[1]) + 0, round(2 * v[0]) + 0, 0]);
    }
  });

  test('rotate uses the angle of the body', () => {
    const { world, eids } = crowd([lawOf({ force: ({ rotate }: BodySymbols) => rotate(vec3(3, 4, 5)) })], kind);
    eids.forEach((eid, i) => {
      world.components.Rotation.angle[eid] = i * 0.7 - 3;
    });
    const { x, y } = forcesNow(world);
    for (const eid of eids) {
      const angle = world.components.Rotation.angle[eid];
      const [c, s] = [round(cos(angle)), round(sin(angle))];
      expectSameBits(x[eid], round(round(3 * c) - round(4 * s)), `x at ${angle}`);
      expectSameBits(y[eid], round(round(3 * s) + round(4 * c)), `y at ${angle}`);
    }
  });
});

describe.each(deep)('in space, $precision', (kind) => {
  const digits = kind.precision === 'f32' ? 6 : 14;

  test('rotate uses the orientation: a quarter revolution about z maps x to y, and lengths do not change', () => {
    const body = vec3(3, 4, 12);
    const law = lawOf({
      force: ({ rotate }: BodySymbols) => rotate(body),
      torque: ({ rotate }: BodySymbols) => rotate(vec3(1, 0, 0)),
    });
    const { world, eids } = crowd([law], kind);
    const { Orientation: q } = world.components;
    eids.forEach((eid, i) => {
      const [a, b] = [i * 0.4, i * 0.3];
      q.x[eid] = Math.sin(a) * Math.cos(b);
      q.y[eid] = Math.sin(a) * Math.sin(b);
      q.z[eid] = 0;
      q.w[eid] = Math.cos(a);
    });
    [q.x[eids[1]], q.y[eids[1]], q.z[eids[1]], q.w[eids[1]]] = [0, 0, Math.SQRT1_2, Math.SQRT1_2];
    const force = forcesNow(world);
    const { torque } = world.scratch;
    [-4, 3, 12].forEach((wanted, i) => {
      expect(force['xyz'[i] as 'x'][eids[1]]).toBeCloseTo(wanted, digits - 1);
    });
    [0, 1, 0].forEach((wanted, i) => {
      expect(torque['xyz'[i] as 'x'][eids[1]]).toBeCloseTo(wanted, digits);
    });
    for (const eid of eids) {
      expect(Math.hypot(force.x[eid], force.y[eid], force.z[eid]) / 13).toBeCloseTo(1, digits);
      expect(Math.hypot(torque.x[eid], torque.y[eid], torque.z[eid])).toBeCloseTo(1, digits);
    }
  });
});

describe('one law in the plane and in space', () => {
  /** Drag, an attraction to the origin and a rotation about z, for bodies that stay at z = 0. */
  const law = defineLaw({
    name: 'a bit of everything',
    parameters: { wind: vector('m/s'), field: axialVector('T') },
    force: ({ position, velocity }, { wind, field }) => {
      const u = velocity.sub(wind);
      return u.mul(u.length()).add(position.normalize()).negate().add(velocity.cross(field));
    },
  });

  test.each(['f32', 'f64'] as const)('moves a body in the plane bitwise equally in 2D and 3D, %s', (precision) => {
    const [plane, space] = ([2, 3] as const).map((dimensions) => {
      const forces = [law({ wind: { x: 0.3, y: -0.1 }, field: { z: 0.7 } })];
      const world = createPhysicsWorld({ capacity: 10, dimensions, precision, integrator: semiImplicitEuler, forces });
      const eid = spawn(world, { position: { x: 1, y: 0.2 }, velocity: { y: 1.1 }, mass: 2 });
      for (let i = 0; i < 100; i++) step(world, 0.01);
      const { Position: p, Velocity: v } = world.components;
      return [p.x[eid], p.y[eid], p.z[eid], v.x[eid], v.y[eid], v.z[eid]].map((value) => value + 0);
    });
    expect(space).toEqual(plane);
    expect(plane[0]).not.toBe(1);
  });
});

describe('a torque of vec3 in two dimensions', () => {
  const made = {
    plain: () => vec3(0, 0, 2),
    scaled: () => vec3(1, 1, 1).mul(4).div(2),
    chosen: ({ position }: BodySymbols) => select(position.x.less(1e9), vec3(0, 0, 2), vec3(0, 0, 0)),
    ofTheBody: ({ rotate }: BodySymbols) => rotate(vec3(0, 0, 2)),
    summed: () =>
      vec3(0, 0, 3)
        .sub(vec3(0, 0, 1))
        .add(vec3(5, 5, 0))
        .negate()
        .negate(),
  };

  test.each(Object.entries(made))('turns the body: %s', (name, torque) => {
    const world = createPhysicsWorld({ forces: [defineLaw({ name, torque })()] });
    const body = spawn(world, { position: {}, velocity: {}, mass: 1, inertia: 0.5, rotation: 0, angularVelocity: 0 });
    step(world, 0.25);
    // T dt / I; powers of two are not rounded.
    expect(world.components.AngularVelocity.z[body]).toBe(1);
  });

  test('which has no length in z where it is not the torque itself', () => {
    const lever = defineLaw({ name: 'lever', torque: () => vec3(1, 0, 7).cross(vec3(0, 2, 9)) });
    const world = createPhysicsWorld({ forces: [lever()] });
    const body = spawn(world, { position: {}, velocity: {}, mass: 1, inertia: 0.5, rotation: 0, angularVelocity: 0 });
    step(world, 0.25);
    expect(world.components.AngularVelocity.z[body]).toBe(1);
  });
});
