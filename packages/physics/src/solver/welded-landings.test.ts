// What is welded of many blocks lands as what is of one piece: nothing bounces without restitution, and the welds hold it in shape.
import { box, createJoint, type PhysicsWorld, spawn, step, weld } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, G, rigidWorld, run, SLOP } from '../../../../test/support/rigid-world.ts';

const SIZE = 0.2;
const HEIGHT = 1;

/** Blocks welded to all their neighbours, the lowest of them 1 m above a floor. */
function lattice(world: PhysicsWorld, rows: number, columns: number, restitution = 0): number[] {
  spawn(world, { position: { y: -0.5 }, collider: { shape: box(200, 1), friction: 0.6 } });
  const middle = (row: number, column: number) => ({ x: column * SIZE, y: HEIGHT + (row + 0.5) * SIZE });
  const ids: number[] = [];
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      const at = middle(row, column);
      const collider = { shape: box(SIZE, SIZE), density: 500, friction: 0.6, restitution };
      const b = spawn(world, { position: at, collider });
      if (column > 0) {
        createJoint(world, weld({ a: ids.at(-1) as number, b, anchor: { x: at.x - SIZE / 2, y: at.y } }));
      }
      if (row > 0) {
        const a = ids[ids.length - columns] as number;
        createJoint(world, weld({ a, b, anchor: { x: at.x, y: at.y - SIZE / 2 } }));
      }
      ids.push(b);
    }
  }
  return ids;
}

/** Mean velocity upwards, m/s: all blocks have one mass. */
function climb(world: PhysicsWorld, ids: readonly number[]): number {
  return ids.reduce((sum, id) => sum + (world.components.Velocity.y[id] as number), 0) / ids.length;
}

/** The diagonal over what it was. */
function stretch(world: PhysicsWorld, ids: readonly number[], rows: number, columns: number): number {
  const { x, y } = world.components.Position;
  const [first, last] = [ids[0] as number, ids.at(-1) as number];
  const diagonal = Math.hypot((x[last] as number) - (x[first] as number), (y[last] as number) - (y[first] as number));
  return diagonal / (SIZE * Math.hypot(rows - 1, columns - 1));
}

describe.each(['f32', 'f64'] as const)('a lattice of welded blocks, %s', (precision) => {
  it.each([
    [14, 8],
    [8, 14],
    [16, 20],
  ])('of %d × %d blocks lands without a bounce, keeps its shape and falls asleep', (rows, columns) => {
    const world = rigidWorld({ precision, capacity: 1200 });
    const ids = lattice(world, rows, columns);
    const before = world.components.Position.y[ids[0] as number] as number;
    run(world, Math.sqrt((2 * HEIGHT) / G) - DT);
    expect(before - (world.components.Position.y[ids[0] as number] as number)).toBeGreaterThan(0.8 * HEIGHT);
    let fastest = 0;
    let widest = 0;
    for (let i = 0; i < 30; i++) {
      step(world, DT);
      fastest = Math.max(fastest, climb(world, ids));
      widest = Math.max(widest, Math.abs(stretch(world, ids, rows, columns) - 1));
    }
    // Contacts slower than 0.5 m/s are no landings: they are left to the sub-steps, which may return half of that.
    expect(fastest).toBeLessThan(0.25);
    // As much as contacts overlap, 5 mm, on the shortest diagonal, 3 m.
    expect(widest).toBeLessThan(SLOP / 3);
    run(world, 9);
    for (const id of ids) expect(world.components.Velocity.y[id]).toBe(0);
  });

  it.each([
    [14, 8],
    [16, 20],
  ])('of %d × %d blocks comes back with e v', (rows, columns) => {
    const world = rigidWorld({ precision, capacity: 1200 });
    const ids = lattice(world, rows, columns, 0.5);
    let fastest = 0;
    for (let i = 0; i < 40; i++) {
      step(world, DT);
      fastest = Math.max(fastest, climb(world, ids));
    }
    const expected = 0.5 * Math.sqrt(2 * G * HEIGHT);
    // Gravity acts on in the step in which it bounces, and welds that the blow squeezed may give as much back.
    expect(Math.abs(fastest - expected)).toBeLessThan(G * DT);
  });

  it('lies still where 200 blocks in a row fall flat', () => {
    const world = rigidWorld({ precision, capacity: 1200 });
    const ids = lattice(world, 1, 200);
    run(world, Math.sqrt((2 * HEIGHT) / G) + 2 * DT);
    // A hundredth of the speed of 4.4 m/s at which they met the floor.
    for (const id of ids) expect(Math.abs(world.components.Velocity.y[id] as number)).toBeLessThan(0.044);
  });
});
