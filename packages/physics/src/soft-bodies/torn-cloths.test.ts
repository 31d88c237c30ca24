// Wind on cloths whose springs break or are cut: no wind acts on what they no longer hold.
import { removeEntity } from 'bitecs';
import { expect, test } from 'vitest';
import {
  type Cloth,
  clothWind,
  createCloth,
  createPhysicsWorld,
  decodeSnapshot,
  encodeSnapshot,
  type PhysicsWorld,
  replaceForce,
  restore,
  snapshot,
  spawn,
  spawnMany,
  step,
  uniformGravity,
  xpbd,
} from '../index.ts';

const COLUMNS = 12;

function makeSheet(precision: 'f32' | 'f64' = 'f64', options = {}) {
  const world = createPhysicsWorld({ dimensions: 3, capacity: 2000, precision });
  const sheet = createCloth(world, {
    corner: {},
    columns: COLUMNS,
    rows: 9,
    spacing: 0.1,
    mass: 1,
    structural: 10,
    shear: 10,
    ...options,
  });
  return { world, sheet };
}

const rowOf = (sheet: Cloth, node: number) => Math.floor(sheet.nodes.indexOf(node) / COLUMNS);

/** Removes the springs of some ends. */
function cut({ world, sheet }: { world: PhysicsWorld; sheet: Cloth }, isCut: (a: number, b: number) => boolean) {
  const { a, b } = world.components.Spring;
  for (const spring of sheet.springs) if (isCut(a[spring], b[spring])) removeEntity(world, spring);
}

/** Cuts the sheet between its rows 4 and 5. */
function cutInTwo(made: ReturnType<typeof makeSheet>) {
  cut(made, (a, b) => rowOf(made.sheet, a) < 5 !== rowOf(made.sheet, b) < 5);
}

/** The forces across the sheet, N, of a step so short that it moves nothing. */
function forces({ world, sheet }: ReturnType<typeof makeSheet>): number[] {
  step(world, 1e-9);
  return Array.from(sheet.nodes, (node) => world.scratch.force.z[node]);
}

/** Forces of some 0.1 N, N: each step of `forces` changes the velocities, and them, by some 1e-8. */
function expectNear(found: readonly number[], expected: readonly number[]) {
  found.forEach((force, node) => {
    expect(Math.abs(force - expected[node])).toBeLessThan(1e-6);
  });
}

test.each(['f32', 'f64'] as const)(
  'wind acts on both halves of a cut sheet, and not between them, in %s',
  (precision) => {
    const [made, other] = [makeSheet(precision), makeSheet(precision)];
    made.world.forces.push(clothWind({ triangles: made.sheet.triangles, velocity: { z: 3 } }));
    const whole = forces(made);
    cutInTwo(made);
    const torn = forces(made);
    const triangles = other.sheet.triangles.filter((_, i, all) => {
      const rows = [0, 1, 2].map((k) => rowOf(other.sheet, all[i - (i % 3) + k]));
      return Math.max(...rows) < 5 || Math.min(...rows) > 4;
    });
    other.world.forces.push(clothWind({ triangles, velocity: { z: 3 } }));
    const halves = forces(other);
    expectNear(torn, halves);
    torn.forEach((force, node) => {
      const row = Math.floor(node / COLUMNS);
      if (row === 4 || row === 5) expect(force).toBeLessThan(0.9 * whole[node]);
    });
  },
);

test('the lower half of a curtain that is cut falls, instead of hanging from a sail that is not there', () => {
  const world = createPhysicsWorld({
    dimensions: 3,
    capacity: 9000,
    integrator: xpbd({ substeps: 4, iterations: 1 }),
    forces: [uniformGravity({ y: -10 })],
  });
  const options = { columns: COLUMNS, rows: 12, spacing: 0.05, mass: 0.08, shear: 200, bend: 1 };
  const sheet = createCloth(world, { corner: {}, ...options });
  world.forces.push(clothWind({ triangles: sheet.triangles, velocity: { z: 5 } }));
  cutInTwo({ world, sheet });
  for (let i = 0; i < 60; i++) step(world, 1 / 60);
  const upper = [...sheet.nodes].filter((node) => rowOf(sheet, node) < 5);
  const lower = [...sheet.nodes].filter((node) => rowOf(sheet, node) > 4);
  const { y } = world.components.Position;
  const mean = (nodes: readonly number[]) => nodes.reduce((sum, node) => sum + y[node], 0) / nodes.length;
  // From -0.4 m: a free fall would be 5 m, and the air brakes what turns its flat side down.
  expect(mean(lower)).toBeLessThan(-2);
  expect(mean(upper)).toBeGreaterThan(-0.1);
});

test('a sheet without shear springs is a whole one, and one that lost its shear springs still is', () => {
  const [net, woven] = [makeSheet('f64', { shear: 0 }), makeSheet()];
  for (const { world, sheet } of [net, woven]) {
    world.forces.push(clothWind({ triangles: sheet.triangles, velocity: { z: 3 } }));
  }
  const before = forces(woven);
  cut(woven, (a, b) => rowOf(woven.sheet, a) !== rowOf(woven.sheet, b) && Math.abs(a - b) % COLUMNS !== 0);
  expectNear(forces(woven), before);
  expectNear(forces(net), before);
});

test('what is torn stays torn under another wind, and is whole again in a snapshot from before', () => {
  const made = makeSheet();
  const { world, sheet } = made;
  const wind = (z: number) => clothWind({ triangles: sheet.triangles, velocity: { z } });
  world.forces.push(wind(3));
  const whole = forces(made);
  const before = snapshot(world);
  cutInTwo(made);
  const torn = forces(made);
  expect(Math.max(...whole.map((force, node) => force - torn[node]))).toBeGreaterThan(0.01);
  const after = snapshot(world);
  restore(world, before);
  expectNear(forces(made), whole);
  restore(world, after);
  expectNear(forces(made), torn);
  replaceForce(world, wind(6));
  expectNear(
    forces(made).map((force) => force / 4),
    torn,
  );
});

test('another program that takes an encoded snapshot knows which triangles are torn', () => {
  const [made, loaded] = [makeSheet(), makeSheet()];
  for (const { world, sheet } of [made, loaded]) {
    world.forces.push(clothWind({ triangles: Uint32Array.from(sheet.triangles), velocity: { z: 3 } }));
    forces({ world, sheet });
  }
  cutInTwo(made);
  const torn = forces(made);
  restore(loaded.world, decodeSnapshot(loaded.world, encodeSnapshot(snapshot(made.world))));
  expect(forces(loaded)).toEqual(forces(made));
  expect(torn.some((force) => force > 0)).toBe(true);
});

/** The force across a single triangle, N, with springs along its sides as far as given, and what `change` removes. */
function onTriangle(sides: readonly (readonly [number, number])[], removed: readonly number[]): number {
  const world = createPhysicsWorld({ dimensions: 3, capacity: 20 });
  const corners = spawnMany(world, 3, { position: { x: [0, 1, 0], y: [0, 0, 1] }, velocity: {}, mass: 1 });
  const springs = sides.map(([a, b]) =>
    spawn(world, { spring: { a: corners[a], b: corners[b], stiffness: 1, length: 1 } }),
  );
  world.forces.push(clothWind({ triangles: corners, velocity: { z: 1 } }));
  step(world, 1e-9);
  for (const side of removed) removeEntity(world, springs[side]);
  step(world, 1e-9);
  return world.scratch.force.z[corners[0]];
}

test('a triangle of its own is torn when fewer than two of its sides are left', () => {
  // rho A c_n u^2 / 2 = 1.2 * 0.5 * 2 / 2 = 0.6 N, a third on each corner.
  const sides = [
    [0, 1],
    [1, 2],
    [2, 0],
  ] as const;
  expect(onTriangle(sides, [])).toBeCloseTo(0.2, 6);
  expect(onTriangle(sides, [1])).toBeCloseTo(0.2, 6);
  expect(onTriangle(sides, [1, 0])).toBe(0);
  // Another spring along a side holds it, too.
  expect(onTriangle([...sides, [0, 2]], [1, 2])).toBeCloseTo(0.2, 6);
  // Something else than springs holds these.
  expect(onTriangle([], [])).toBeCloseTo(0.2, 6);
  expect(onTriangle([[0, 1]], [0])).toBeCloseTo(0.2, 6);
});
