// What an impulse on one body does to all that joints hold to it: the columns of the projection that are measured for each body that is
// struck are those of the projection itself, and so a heap that lands does the same with them as without.
import { box, capsule, createJoint, type PhysicsWorld, revolute, spawn, step, weld } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, rigidWorld } from '../../../../test/support/rigid-world.ts';
import { JointTableWord as Word } from '../memory/layouts.gen.ts';
import { jointTable } from './joint-table.ts';

const BONES = 6;

/** A chain of bones that lands at an angle, on a plank that another holds, with limits that it reaches. */
function land(
  precision: 'f32' | 'f64',
  keepsColumns: boolean,
): { world: PhysicsWorld; bodies: readonly number[]; used: number } {
  const world = rigidWorld({ precision });
  const bodies = Array.from({ length: BONES }, (_, i) => {
    const position = { x: i, y: 1 + 0.4 * i };
    const rotation = 0.4;
    return spawn(world, {
      position,
      rotation,
      velocity: { y: -6 },
      collider: { shape: capsule(0.8, 0.1), density: 10 + 90 * (i % 2) },
    });
  });
  const pairs = bodies.slice(1).map((b, i) => [bodies[i] as number, b] as const);
  pairs.forEach(([a, b], i) => {
    const anchor = { x: i + 0.5, y: 1.2 + 0.4 * i };
    createJoint(
      world,
      i === 2 ? weld({ a, b, anchor }) : revolute({ a, b, anchor, limits: { lower: -0.1, upper: 0.1 } }),
    );
  });
  const plank = spawn(world, { position: { x: 0, y: 0.1 }, collider: { shape: box(1, 0.2), density: 5 } });
  const end = spawn(world, { position: { x: 1, y: 0.1 }, collider: { shape: box(1, 0.2), density: 5 } });
  createJoint(world, revolute({ a: plank, b: end, anchor: { x: 0.5, y: 0.1 } }));
  const { words } = jointTable(world);
  if (!keepsColumns) words[Word.responseRoom] = 0;
  let used = 0;
  for (let i = 0; i < 12; i++) {
    step(world, DT);
    used = Math.max(used, words[Word.responseCount] as number);
  }
  return { world, bodies: [...bodies, plank, end], used };
}

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  it('what lands moves as if each impulse were projected by itself', () => {
    const columns = land(precision, true);
    const projections = land(precision, false);
    expect(columns.used).toBeGreaterThan(0);
    expect(projections.used).toBe(0);
    // What the passes of the rounds leave, 1 cm/s, is at another place in the last digits, but no more than that.
    for (const [i, body] of columns.bodies.entries()) {
      const other = projections.bodies[i] as number;
      for (const axis of ['x', 'y'] as const) {
        const speed = columns.world.components.Velocity[axis][body] as number;
        expect(Math.abs(speed - (projections.world.components.Velocity[axis][other] as number))).toBeLessThan(0.01);
      }
    }
  });
});
