// A ground of many tiles, of which single ones come and go: what is there bears, and what is gone does not.
import { box, circle, createRandom, despawn, type PhysicsWorld, rayCast, spawn, step } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, rigidWorld } from '../../../../test/support/rigid-world.ts';
import { RigidTableWord as Word } from '../memory/layouts.gen.ts';
import { rigidTable } from './rigid-table.ts';

/** So many columns of tiles of 1 m, three deep. */
const WIDTH = 250;
const DEPTH = 3;

function tile(world: PhysicsWorld, x: number, y: number): number {
  return spawn(world, { position: { x, y }, collider: { shape: box(1, 1), friction: 0.6 } });
}

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  it('a ground that is dug and built step by step is where its tiles are', () => {
    const world = rigidWorld({ precision, capacity: 1000 });
    const random = createRandom(7);
    const columns = Array.from({ length: WIDTH }, (_, x) =>
      Array.from({ length: DEPTH }, (_, i) => tile(world, x, i - DEPTH + 0.5)),
    );
    step(world, DT);
    // More than so many changes, after which the tree of tiles is made anew.
    for (let i = 0; i < 150; i++) {
      const x = Math.floor(random.uniform(0, WIDTH));
      const column = columns[x] as number[];
      if (i % 3 > 0 && column.length > 0) despawn(world, column.pop() as number);
      else column.push(tile(world, x, column.length - DEPTH + 0.5));
      step(world, DT);
      step(world, DT);
      for (const at of [x, Math.floor(random.uniform(0, WIDTH))]) {
        const { length } = columns[at] as number[];
        const hit = rayCast(world, { x: at, y: 9 }, { x: at, y: -9 });
        expect(hit?.body).toBe((columns[at] as number[])[length - 1]);
      }
    }
    // Single changes do not make the tree anew.
    expect(rigidTable(world).words[Word.staticChanges]).toBeGreaterThan(0);
  });

  it('a ball that gets the id of a tile falls, and lands on the tile that is built below it', () => {
    const world = rigidWorld({ precision, capacity: 1000 });
    const tiles = Array.from({ length: 3 * WIDTH }, (_, x) => tile(world, x, -0.5));
    step(world, DT);
    const gone = tiles[100] as number;
    despawn(world, gone);
    const ball = spawn(world, {
      position: { x: 100, y: 2 },
      collider: { shape: circle(0.25), density: 1, friction: 0.6 },
    });
    expect(ball).toBe(gone);
    for (let i = 0; i < 10; i++) step(world, DT);
    tile(world, 100, -1.5);
    for (let i = 0; i < 200; i++) step(world, DT);
    const { Position } = world.components;
    expect(Position.y[ball]).toBeGreaterThan(-1 + 0.25 - 0.005);
    expect(Position.y[ball]).toBeLessThan(-1 + 0.25 + 0.005);
  });
});
