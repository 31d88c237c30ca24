// Sums over tables: the rows are in the world's memory and may change between steps.
import { afterEach, describe, expect, test, vi } from 'vitest';
import { crowd, expectSameBits, forcesNow, rounderOf, WORLD_KINDS } from '../../../../test/support/law-lab.ts';
import {
  createPhysicsWorld,
  defineForce,
  defineLaw,
  type Force,
  INTEGRATORS,
  type PhysicsWorld,
  rungeKutta4,
  spawn,
  step,
  type TableLocation,
  table,
  vec3,
  velocityVerlet,
} from '../index.ts';
import { allocate } from '../memory/arena.ts';
import { resource } from '../memory/resource.ts';

/** Stores the location of a table per world. */
function places(): (world: PhysicsWorld) => TableLocation & { at: number; count: number } {
  return resource(() => ({ at: 0, count: 0 }));
}

/** Writes rows of numbers to the world's memory. */
function putRows(
  world: PhysicsWorld,
  place: { at: number; count: number },
  rows: readonly (readonly number[])[],
): void {
  const numbers = rows.flat();
  place.at = allocate(world.internal.arena, Math.max(8, 8 * numbers.length), 'rows of a test');
  place.count = rows.length;
  new Float64Array(world.memory.buffer, place.at, numbers.length).set(numbers);
}

const springsAt = places();

/** Springs to many points: F = Σ s (c - r). */
const springs = defineLaw({
  name: 'springs to places',
  parameters: { centres: table(['x', 'y', 's'], springsAt) },
  force: ({ position }, { centres }) => centres.sum(({ x, y, s }) => vec3(x, y).sub(position).mul(s)),
}) as () => Force;

const ROWS = Array.from({ length: 1000 }, (_, i) => [i / 7 - 60, 3 - i / 9, 0.1 + (i % 3)]);

afterEach(() => void vi.restoreAllMocks());

describe.each(WORLD_KINDS)('in $dimensions dimensions, $precision', (kind) => {
  const round = rounderOf(kind.precision);

  test.each([0, 1, 2, 1000])('the sum of %i rows equals that of a loop in the order of the rows', (count) => {
    const { world, eids } = crowd([springs()], kind);
    putRows(world, springsAt(world), ROWS.slice(0, count));
    eids.forEach((eid, i) => {
      world.components.Position.x[eid] = i * 0.3;
    });
    const { x } = forcesNow(world);
    for (const eid of eids) {
      let wanted = 0;
      const here = world.components.Position.x[eid];
      for (const [centre, , s] of ROWS.slice(0, count))
        wanted = round(wanted + round(round(round(centre) - here) * round(s)));
      expectSameBits(x[eid], wanted, `sum of ${count}`);
    }
  });

  test('terms that depend only on rows are summed too, and several sums share a loop', () => {
    const at = places();
    const law = defineLaw({
      name: 'sums of sums',
      parameters: { rows: table(['p', 'q'], at) },
      force: ({ mass }, { rows }) => {
        const both = rows.sum(({ p, q }) => vec3(p.mul(p.add(q)).max(q), mass.mul(p), q));
        return both.add(
          vec3(
            rows.sum(() => 1),
            rows.sum(({ q }) => q).mul(mass),
          ),
        );
      },
    }) as () => Force;
    const { world, eids } = crowd([law()], kind);
    putRows(world, at(world), [
      [1, 2],
      [3, -1],
      [0.5, 4],
    ]);
    const { x, y } = forcesNow(world);
    for (const eid of eids) expect([x[eid], y[eid]]).toEqual([3 + 6 + 4 + 3, 4.5 + 5]);
  });
});

describe('a nested sum', () => {
  const [outer, inner] = [places(), places()];
  const world = createPhysicsWorld({ capacity: 20 });
  const eid = spawn(world, { position: { x: 0.5 }, velocity: {}, mass: 1 });
  putRows(world, outer(world), [[1], [2], [4]]);
  putRows(world, inner(world), [[10], [20]]);

  test('may read the row of the outer sum, which continues afterwards', () => {
    const law = defineLaw({
      name: 'nested',
      parameters: { a: table(['p'], outer), b: table(['q'], inner) },
      force: ({ position }, { a, b }) =>
        a.sum(({ p }) => vec3(b.sum(() => position.x.add(p)).add(p.mul(p.add(1).mul(p.add(1)))), 0)),
    }) as () => Force;
    world.forces.splice(0, 1, law());
    expect(forcesNow(world).x[eid]).toBe(2 * 1.5 + 1 * 4 + (2 * 2.5 + 2 * 9) + (2 * 4.5 + 4 * 25));
  });

  test('may not read the rows of both sums', () => {
    const define = () =>
      defineLaw({
        name: 'rows of two tables',
        parameters: { a: table(['p'], outer), b: table(['q'], inner) },
        force: (_body, { a, b }) =>
          a.sum(({ p }) =>
            vec3(
              b.sum(({ q }) => q.mul(p)),
              0,
            ),
          ),
      });
    expect(define).toThrow(/a sum inside a sum cannot read the rows of both/);
  });
});

describe('in a step', () => {
  const spring = (integrator: PhysicsWorld['integrator'], forces: readonly Force[]) => {
    const world = createPhysicsWorld({ capacity: 20, integrator, forces });
    putRows(world, springsAt(world), [
      [1, 0, 2],
      [4, 1, 1],
      [-2, 3, 0.5],
    ]);
    const eid = spawn(world, { position: { x: 0.3 }, velocity: { y: 1 }, mass: 1 });
    return { world, eid };
  };

  /** The same springs without a table: F = Σ s c - r Σ s. */
  const oneSpring = defineLaw({
    name: 'one spring',
    force: ({ position }) => vec3(2 + 4 - 1, 1 + 1.5).sub(position.mul(3.5)),
  })();

  test.each(
    Object.values(INTEGRATORS)
      .map(({ create }) => create())
      .filter(({ scheme }) => scheme !== undefined),
  )('$name asks for the sum in each of its stages', (integrator) => {
    const [many, one] = [spring(integrator, [springs()]), spring(integrator, [oneSpring])];
    for (let i = 0; i < 50; i++) for (const { world } of [many, one]) step(world, 0.01);
    const [p, q] = [many, one].map(({ world }) => world.components.Position);
    expect(p.x[many.eid]).toBeCloseTo(q.x[one.eid], 12);
    expect(p.y[many.eid]).toBeCloseTo(q.y[one.eid], 12);
    expect(p.x[many.eid]).not.toBe(0.3);
  });

  test('the same law listed twice gives twice the force', () => {
    const [once, twice] = [spring(rungeKutta4, [springs()]), spring(rungeKutta4, [springs(), springs()])];
    expect(forcesNow(twice.world).x[twice.eid]).toBe(2 * forcesNow(once.world).x[once.eid]);
    step(twice.world, 0.01);
    expect(twice.world.faults.faults).toEqual([]);
  });

  test('two laws with separate tables use their own rows', () => {
    const [first, second] = [places(), places()];
    const make = (name: string, at: typeof first) =>
      (
        defineLaw({
          name,
          parameters: { t: table(['p'], at) },
          force: (_body, { t }) => t.sum(({ p }) => vec3(p, 0)),
        }) as () => Force
      )();
    const world = createPhysicsWorld({ capacity: 20, forces: [make('first', first), make('second', second)] });
    putRows(world, first(world), [[1], [2]]);
    putRows(world, second(world), [[10]]);
    const eid = spawn(world, { position: {}, velocity: {}, mass: 1 });
    expect(forcesNow(world).x[eid]).toBe(13);
  });

  test('a table that moves and grows is summed at its new address without recompilation', () => {
    const { world, eid } = spring(velocityVerlet, [springs()]);
    step(world, 0.01);
    const spy = vi.spyOn(WebAssembly, 'Module');
    putRows(world, springsAt(world), ROWS);
    step(world, 0.01);
    expect(spy).not.toHaveBeenCalled();
    const fresh = spring(velocityVerlet, [springs()]);
    step(fresh.world, 0.01);
    const [{ Velocity: v }, { Velocity: w }] = [world.components, fresh.world.components];
    expect(Math.abs(v.x[eid] - w.x[fresh.eid])).toBeGreaterThan(1);
  });

  test('gives the same result beside a force that is not a law', () => {
    const [fused, cut] = [
      spring(velocityVerlet, [springs()]),
      spring(velocityVerlet, [springs(), defineForce({ name: 'nothing', accumulate() {} })]),
    ];
    for (let i = 0; i < 20; i++) for (const { world } of [fused, cut]) step(world, 0.01);
    expect(cut.world.components.Position.x[cut.eid]).toBeCloseTo(fused.world.components.Position.x[fused.eid], 13);
  });
});
