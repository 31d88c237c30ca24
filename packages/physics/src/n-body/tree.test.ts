import { describe, expect, test } from 'vitest';
import { type Cloud, cloud, fieldAt, SHAPES, type Shape } from '../../../../test/support/point-clouds.ts';
import { spawnMany } from '../bodies/spawn-many.ts';
import { energy } from '../diagnostics/energy.ts';
import { stateHash } from '../diagnostics/hash.ts';
import { createPhysicsWorld, type PhysicsWorldOptions } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { mutualCoulomb } from './mutual-coulomb.ts';
import type { MutualForce, MutualOptions } from './mutual-force.ts';
import { mutualGravity } from './mutual-gravity.ts';

type Options = Pick<PhysicsWorldOptions, 'precision' | 'dimensions'>;

function worldOf(force: MutualForce, made: Cloud, { precision = 'f64', dimensions = 3 }: Options = {}): PhysicsWorld {
  const { x, y, z, mass } = made;
  const capacity = x.length;
  const world = createPhysicsWorld({
    dimensions,
    precision,
    capacity,
    forces: [force],
    arenaBytes: 2 ** 20 + 400 * capacity,
  });
  spawnMany(world, capacity, { position: { x, y, ...(dimensions === 3 ? { z } : {}) }, velocity: {}, mass });
  return world;
}

/** Returns the accelerations of all bodies, from one short step from rest. */
function accelerations(world: PhysicsWorld): [number, number, number][] {
  const dt = 2 ** -30;
  const force = world.forces[0] as MutualForce;
  // A step moves the bodies; the force is read from an evaluation at rest.
  force.rmsError(world);
  const { x, y, z } = world.components.Position;
  const before = [x.slice(), y.slice(), z.slice()];
  step(world, dt);
  for (const [axis, column] of [x, y, z].entries()) column.set(before[axis] as Float32Array);
  const { Velocity } = world.components;
  return Array.from({ length: world.lastId }, (_, i) => [
    (Velocity.x[i + 1] as number) / dt,
    (Velocity.y[i + 1] as number) / dt,
    (Velocity.z[i + 1] as number) / dt,
  ]);
}

const gravityTree = (options: MutualOptions = {}) => mutualGravity({ G: 1, method: 'tree', ...options });

describe('the error of the tree', () => {
  const cases = [
    { dimensions: 3, law: 'inverse-square' },
    { dimensions: 2, law: 'inverse-square' },
    { dimensions: 2, law: 'inverse-distance' },
  ] as const;

  test.each(cases)('is as requested for every distribution: $dimensions dimensions, $law', ({ dimensions, law }) => {
    for (const shape of SHAPES) {
      const made = cloud(shape, 4000, dimensions);
      for (const [precision, relativeError] of [
        ['f32', 0.02],
        ['f32', 0.005],
        ['f64', 0.001],
      ] as const) {
        const force = gravityTree({ law, relativeError });
        const world = worldOf(force, made, { precision, dimensions });
        const error = force.rmsError(world);
        expect(error, `${shape} ${precision} ${relativeError}`).toBeLessThan(relativeError);
        expect(force.report(world).method).toBe('tree');
      }
    }
  });

  test.each(cases)('is as requested for few bodies: $dimensions dimensions, $law', (options) => {
    const { dimensions, law } = options;
    for (const count of [500, 1000, 2000, 10_000]) {
      const force = gravityTree({ law, relativeError: 0.005, softening: 0.01 });
      const world = worldOf(force, cloud('plummer', count, dimensions), { dimensions });
      for (let s = 0; s < 5; s++) {
        expect(force.rmsError(world), `${count} bodies, step ${s}`).toBeLessThan(0.005);
        step(world, 1e-3);
      }
      expect(force.report(world).method).toBe('tree');
    }
  });

  test.each([2, 3] as const)('is unaffected by a close pair without softening: %s dimensions', (dimensions) => {
    for (const count of [500, 1000]) {
      const force = gravityTree({ relativeError: 0.005 });
      const world = worldOf(force, cloud('plummer', count, dimensions), { dimensions });
      let beyond = 0;
      for (let s = 0; s < 40; s++) {
        const error = force.rmsError(world);
        // One body with an error of a half contributes 0.5/√500 in such a small sample, and the error is measured only
        // every 32 steps.
        expect(error, `${count} bodies, step ${s}`).toBeLessThan(0.025);
        if (error > 0.005) beyond++;
        step(world, 1e-3);
      }
      expect(beyond).toBeLessThanOrEqual(4);
    }
  });

  test('is relative to the typical field, not to that of a close pair', () => {
    const made = cloud('plummer', 1000, 2);
    const error = () => {
      const force = gravityTree({ relativeError: 0.005 });
      return force.rmsError(worldOf(force, made, { dimensions: 2 }));
    };
    const apart = error();
    // They are a millionth of a metre apart, so their fields are 10⁹ times the others.
    made.x[1] = (made.x[0] as number) + 1e-6;
    made.y[1] = made.y[0] as number;
    const close = error();
    expect(close).toBeLessThan(0.005);
    expect(close / apart).toBeGreaterThan(0.5);
    expect(close / apart).toBeLessThan(2);
  });

  test.each(cases)('is only rounding if no cell is accepted: $dimensions dimensions, $law', (options) => {
    const { dimensions, law } = options;
    const power = law === 'inverse-square' ? 2 : 1;
    for (const shape of ['plummer', 'line'] as const) {
      const made = cloud(shape, 700, dimensions);
      const force = gravityTree({ law, relativeError: 0, softening: 0.01 });
      const found = accelerations(worldOf(force, made, { dimensions }));
      for (let i = 0; i < 700; i += 13) {
        const wanted = fieldAt(made, i, power, 0.01);
        const error = Math.hypot(...wanted.map((a, k) => a - ((found[i] as number[])[k] as number)));
        expect(error / Math.hypot(...wanted)).toBeLessThan(1e-10);
      }
    }
  });

  test('measured internally agrees with direct summation', () => {
    const made = cloud('plummer', 3000, 3);
    const force = gravityTree({ relativeError: 0.02 });
    const world = worldOf(force, made);
    const reported = force.rmsError(world);
    const found = accelerations(world);
    const wanted = Array.from({ length: 1000 }, (_, k) => fieldAt(made, 3 * k));
    const sizes = wanted.map((field) => Math.hypot(...field)).sort((a, b) => a - b);
    const minField = 0.1 * (sizes[500] as number);
    let sum = 0;
    for (const [k, field] of wanted.entries()) {
      const off = field.map((a, axis) => a - ((found[3 * k] as number[])[axis] as number));
      sum += (Math.hypot(...off) / Math.max(minField, Math.hypot(...field))) ** 2;
    }
    // The two measurements sample different bodies.
    expect(reported / Math.sqrt(sum / 1000)).toBeGreaterThan(0.5);
    expect(reported / Math.sqrt(sum / 1000)).toBeLessThan(2);
  });

  test('stays as requested while bodies move', () => {
    const made = cloud('two clusters', 3000, 3);
    const force = gravityTree({ relativeError: 0.003, softening: 0.02 });
    const world = worldOf(force, made, { precision: 'f32' });
    for (let i = 0; i < 60; i++) {
      step(world, 2e-5);
      if (i % 10 === 0) expect(force.rmsError(world)).toBeLessThan(0.003);
    }
  });
});

test('what a body alone far from all others feels does not depend on its own mass', () => {
  const count = 4000;
  const made = cloud('uniform', count + 1, 3);
  const positive = (column: Float64Array, to: number) => column.set(column.map((value) => 0.5 * to * (1 + value)));
  positive(made.x, 0.49);
  positive(made.y, 0.9);
  positive(made.z, 0.9);
  made.mass.fill(1);
  // The half of the first cell in which nothing else is.
  [made.x[count], made.y[count], made.z[count]] = [0.505, 0.41, 0.47];
  const felt = [1, 1.1, 1.3, 1.7, 0.3, 0.7].map((mass) => {
    made.mass[count] = mass;
    return accelerations(worldOf(gravityTree({ relativeError: 1e-3 }), made)).at(-1) as number[];
  });
  const [first = []] = felt;
  const size = Math.hypot(...first);
  for (const other of felt) {
    // Another mass may change the cells that are accepted, within the error.
    expect(Math.hypot(...other.map((value, i) => value - (first[i] as number))) / size).toBeLessThan(1e-3);
  }
});

describe('the tree', () => {
  test('costs N log N', () => {
    const pairs = [2000, 4000, 8000, 16_000, 32_000].map((count) => {
      const force = gravityTree({ relativeError: 0.01 });
      const world = worldOf(force, cloud('uniform', count, 3), { precision: 'f32' });
      step(world, 1e-6);
      const { cellPairs, bodyPairs } = force.report(world);
      return (cellPairs + bodyPairs) / count;
    });
    // The number of pairs per body grows by about the same amount for each doubling, far less than in proportion to N.
    for (let i = 1; i < pairs.length; i++) expect((pairs[i] as number) / (pairs[i - 1] as number)).toBeLessThan(1.35);
    expect((pairs[4] as number) / 32_000).toBeLessThan(0.04);
  });

  test('of 30 000 coincident bodies is bounded, and they feel no force', () => {
    const made = cloud('one place', 30_000, 3);
    const force = gravityTree({ relativeError: 0.01 });
    const world = worldOf(force, made, { precision: 'f32' });
    step(world, 0.1);
    const { nodes, depth } = force.report(world);
    expect(nodes).toBe(1);
    expect(depth).toBe(0);
    expect(world.components.Velocity.x.every((v) => v === 0)).toBe(true);
  });

  test('gives a cluster separate keys if one body is far away', () => {
    const made = cloud('plummer', 10_000, 3);
    for (const column of [made.x, made.y, made.z])
      for (let i = 1; i < 10_000; i++) column[i] = (column[i] as number) * 1e-9;
    made.x[0] = 1;
    const force = gravityTree({ relativeError: 0.01 });
    const world = worldOf(force, made);
    expect(force.rmsError(world)).toBeLessThan(0.01);
    const { cellPairs, bodyPairs } = force.report(world);
    expect((cellPairs + bodyPairs) / 10_000).toBeLessThan(1500);
  });

  /** Pairs per body and error of the tree after some measurements of the error. */
  function settled(made: Cloud, options: Options): { pairs: number; error: number } {
    const force = gravityTree();
    const world = worldOf(force, made, options);
    for (let i = 0; i < 34; i++) step(world, 1e-9);
    const { cellPairs, bodyPairs } = force.report(world);
    return { pairs: (cellPairs + bodyPairs) / made.x.length, error: force.rmsError(world) };
  }

  // A tree of N bodies has some log N interactions for each. Far bodies and clusters add a few cells to that.
  test.each([
    ['f64', 3],
    ['f32', 2],
  ] as const)('costs as much for two distant clusters as for one: %s, %s dimensions', (precision, dimensions) => {
    const made = cloud('plummer', 6000, dimensions);
    const one = settled(made, { precision, dimensions });
    for (let i = 0; i < 6000; i += 2) made.x[i] = (made.x[i] as number) + 1000;
    const two = settled(made, { precision, dimensions });
    expect(two.pairs / one.pairs).toBeLessThan(1.35);
    expect(two.error).toBeLessThan(0.005);
  });

  test.each([
    ['f64', 1e12],
    ['f32', 1e6],
  ] as const)('costs as much if one body was thrown out: %s, to %s m', (precision, distance) => {
    const made = cloud('plummer', 6000, 2);
    const before = settled(made, { precision, dimensions: 2 });
    made.x[0] = distance;
    const after = settled(made, { precision, dimensions: 2 });
    expect(after.pairs / before.pairs).toBeLessThan(1.35);
    expect(after.error).toBeLessThan(0.005);
  });

  test('keeps the forces of all others if one body has the largest coordinate there is', () => {
    const made = cloud('plummer', 3000, 3);
    made.x[0] = 1e15;
    const { error } = settled(made, { precision: 'f32' });
    expect(error).toBeLessThan(0.005);
  });

  test('of a tight cluster far from one body is no deeper than its keys', () => {
    const made = cloud('uniform', 1000, 3);
    for (const column of [made.x, made.y, made.z])
      for (let i = 1; i < 1000; i++) column[i] = (column[i] as number) * 1e-5;
    made.x[0] = 1e3;
    const force = gravityTree();
    const world = worldOf(force, made);
    expect(force.rmsError(world)).toBeLessThan(0.005);
    expect(force.report(world).depth).toBeLessThan(21);
  });

  test('treats a uniform ball from outside as a point mass', () => {
    const made = cloud('uniform', 8000, 3);
    // A shell of test particles would move; one light body outside is enough.
    for (const column of [made.x, made.y, made.z]) column[0] = 0;
    made.x[0] = 8;
    made.mass[0] = 1e-6;
    const mass = made.mass.reduce((sum, m) => sum + m, 0) - 1e-6;
    const centre = (column: Float64Array) =>
      column.reduce((sum, v, i) => sum + (i ? v * (made.mass[i] as number) : 0), 0) / mass;
    const [x, y, z] = [centre(made.x), centre(made.y), centre(made.z)];
    const d = Math.hypot(8 - x, y, z);
    const [ax] = accelerations(worldOf(gravityTree({ relativeError: 0.005 }), made))[0] as [number, number, number];
    // A cube of side 2 differs from a ball only at the fourth power of 1/8; the tree may err by 0.5 %.
    expect(ax / ((-mass * (8 - x)) / d ** 3)).toBeCloseTo(1, 2);
  });

  test('gives the same forces within its error for any order of bodies', () => {
    const made = cloud('plummer', 5000, 3);
    const shuffled = { ...made };
    const order = Array.from({ length: 5000 }, (_, i) => (i * 1237 + 11) % 5000);
    for (const key of ['x', 'y', 'z', 'mass'] as const)
      shuffled[key] = Float64Array.from(order, (i) => made[key][i] as number);
    const one = accelerations(worldOf(gravityTree(), made));
    const other = accelerations(worldOf(gravityTree(), shuffled));
    for (const [place, i] of order.entries()) {
      const [a, b] = [one[i] as number[], other[place] as number[]];
      expect(Math.hypot(...a.map((v, k) => v - (b[k] as number))) / Math.hypot(...a)).toBeLessThan(1e-6);
    }
  });

  test('conserves energy within its error, and is deterministic', () => {
    const run = () => {
      const force = gravityTree({ relativeError: 0.002, softening: 0.05 });
      const world = worldOf(force, cloud('plummer', 3000, 3), { precision: 'f32' });
      const before = energy(world).potential;
      for (let i = 0; i < 30; i++) step(world, 5e-4);
      return {
        drift: (energy(world).total - before) / before,
        moved: energy(world).kinetic / -before,
        hash: stateHash(world),
      };
    };
    const [one, other] = [run(), run()];
    expect(one.moved).toBeGreaterThan(0.05);
    // Direct summation itself drifts by 3e-5 in this collapse from rest.
    expect(Math.abs(one.drift)).toBeLessThan(2e-4);
    expect(one.hash).toBe(other.hash);
  });

  test.each([
    [3, 'inverse-square'],
    [2, 'inverse-square'],
    [2, 'inverse-distance'],
  ] as const)('has the potential of direct summation: %s dimensions, %s', (dimensions, law) => {
    const made = cloud('plummer', 3000, dimensions);
    const [tree, direct] = (['tree', 'direct'] as const).map((method) => {
      const force = mutualGravity({ G: 1, law, method, softening: 0.02 });
      return force.potential(worldOf(force, made, { dimensions }));
    }) as [number, number];
    expect(tree / direct).toBeCloseTo(1, 3);
  });
});

describe('charges of both signs', () => {
  test.each(['plummer', 'uniform', 'two clusters'] as Shape[])('keep the requested error: %s', (shape) => {
    for (const [dimensions, law] of [
      [3, 'inverse-square'],
      [2, 'inverse-distance'],
    ] as const) {
      const made = cloud(shape, 3000, dimensions);
      const force = mutualCoulomb({ k: 1, law, method: 'tree', relativeError: 0.01 });
      const world = worldOf(force, made, { dimensions });
      const { x, y, z, mass } = made;
      const charge = mass.map((m, i) => (i % 2 ? m : -m));
      const charged = createPhysicsWorld({ dimensions, capacity: 3000, forces: [force] });
      spawnMany(charged, 3000, { position: { x, y, ...(dimensions === 3 ? { z } : {}) }, velocity: {}, mass, charge });
      expect(force.rmsError(charged)).toBeLessThan(0.01);
      expect(force.report(world).bodies).toBe(0);
    }
  });
});

test('the faster method is selected by the number of bodies', () => {
  const methods = [500, 20_000].map((count) => {
    const force = mutualGravity({ G: 1 });
    const world = worldOf(force, cloud('uniform', count, 3), { precision: 'f32' });
    step(world, 1e-6);
    return force.report(world).method;
  });
  expect(methods).toEqual(['direct', 'tree']);
});
