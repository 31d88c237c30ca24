import { describe, expect, test } from 'vitest';
import { forceOn, single } from '../../../../test/support/laws.ts';
import { defineLaw, type PhysicsWorld, rungeKutta4, scalar, step, table, vec3, velocityVerlet } from '../index.ts';
import { allocate } from '../memory/arena.ts';
import { resource } from '../memory/resource.ts';

/** Springs from points on the x axis. */
const springsFrom = (points: readonly number[]) => {
  const placeOf = resource((world: PhysicsWorld) => {
    const at = allocate(world.internal.arena, 8 * points.length, 'points');
    new Float64Array(world.memory.buffer, at, points.length).set(points);
    return { at, count: points.length };
  });
  return defineLaw({
    name: 'springs from points',
    parameters: { stiffness: scalar('N/m'), points: table(['x'], placeOf) },
    force: ({ position }, { stiffness, points }) => points.sum(({ x }) => vec3(x, 0).sub(position)).mul(stiffness),
  });
};

describe('sums over a table', () => {
  test('a sum may depend on another sum over the same table, in a later stage of the step', () => {
    // A body on the x axis between two springs of 1 N/m with midpoint 2 m: x'' = -2 (x - 2).
    for (const [integrator, within] of [
      [velocityVerlet, 1e-3],
      [rungeKutta4, 1e-8],
    ] as const) {
      const law = springsFrom([1, 3])({ stiffness: 1 });
      const { world, at } = single([law], { position: { x: 2.5 } }, { integrator });
      for (let i = 0; i < 100; i++) step(world, 0.01);
      expect(Math.abs(at().x - (2 + 0.5 * Math.cos(Math.SQRT2)))).toBeLessThan(within);
    }
  });

  test('tables of two forces are distinct, even if both are of one law', () => {
    const values = [[1], [10, 20]];
    // The first law evaluates it first, then the second.
    let asked = 0;
    const placeOf = (world: PhysicsWorld) => {
      const points = values[asked++ % 2];
      const at = allocate(world.internal.arena, 8 * points.length, 'points');
      new Float64Array(world.memory.buffer, at, points.length).set(points);
      return { at, count: points.length };
    };
    const law = defineLaw({
      name: 'sum of points',
      parameters: { points: table(['x'], placeOf) },
      acceleration: (_body, { points }) => points.sum(({ x }) => vec3(x, 0)),
    });
    const { world, eid } = single([law(), law()]);
    expect(forceOn(world, eid).x).toBe(31);
  });
});
