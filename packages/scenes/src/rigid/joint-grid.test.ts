// The net is the same as in Box2D's benchmark of joints; box2d3-wasm, single-threaded, was measured in it.
import { type PhysicsWorld, step } from '@principia/physics';
import { query } from 'bitecs';
import { expect, test } from 'vitest';
import { jointGrid } from './joint-grid.ts';

/** Largest gap of a hinge in Box2D in the first 300 steps, and after them, m. */
const BOX2D = { largest: 0.159, last: 0.077 };

test('hinges of a net give way at most a quarter as far as those of Box2D', () => {
  const { world, dt } = jointGrid.create({ count: 2500 });
  let largest = 0;
  for (let s = 0; s < 300; s++) {
    step(world, dt);
    largest = Math.max(largest, largestGap(world));
  }
  expect(largest).toBeLessThan(BOX2D.largest / 4);
  expect(largestGap(world)).toBeLessThan(BOX2D.last / 4);
});

/** The largest distance between the two anchors of a hinge, m. */
function largestGap(world: PhysicsWorld): number {
  const { Joint } = world.components;
  let largest = 0;
  for (const joint of query(world, [Joint])) {
    const a = anchor(world, Joint.a[joint], Joint.ax[joint], Joint.ay[joint]);
    const b = anchor(world, Joint.b[joint], Joint.bx[joint], Joint.by[joint]);
    largest = Math.max(largest, Math.hypot(b.x - a.x, b.y - a.y));
  }
  return largest;
}

/** Where a point of a body is in the world. */
function anchor({ components: { Position, Rotation } }: PhysicsWorld, body: number, x: number, y: number) {
  const [c, s] = [Math.cos(Rotation.angle[body]), Math.sin(Rotation.angle[body])];
  return { x: Position.x[body] + c * x - s * y, y: Position.y[body] + s * x + c * y };
}
