// What an impulse on one body does to all that joints hold to it: the columns of the projection that are measured for each body that is
// struck are those of the projection itself, and so a heap that lands does the same with them as without.
import { box, capsule, createJoint, type PhysicsWorld, revolute, spawn, step, weld } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, rigidWorld } from '../../../../test/support/rigid-world.ts';
import { JointTableWord as Word } from '../memory/layouts.gen.ts';
import { jointTable } from './joint-table.ts';

const BONES = 6;

interface Landing {
  readonly world: PhysicsWorld;
  readonly bodies: readonly number[];
  /** Numbers of the columns, at most. */
  readonly used: number;
}

/** Takes steps, with or without columns. */
function watch(world: PhysicsWorld, bodies: readonly number[], keepsColumns: boolean): Landing {
  const { words } = jointTable(world);
  if (!keepsColumns) words[Word.responseRoom] = 0;
  let used = 0;
  for (let i = 0; i < 12; i++) {
    step(world, DT);
    used = Math.max(used, words[Word.responseCount] as number);
  }
  return { world, bodies, used };
}

/** A track of links in a closed loop, of which some are heavy, that lands on an edge. */
function landTrack(precision: 'f32' | 'f64', keepsColumns: boolean): Landing {
  const world = rigidWorld({ precision });
  spawn(world, { position: { x: 0.7, y: 0.2 }, collider: { shape: box(0.2, 0.4) } });
  const sides = 2 * BONES;
  const corner = (i: number) => ({
    x: 2 * Math.cos((2 * Math.PI * i) / sides),
    y: 2.6 + 2 * Math.sin((2 * Math.PI * i) / sides),
  });
  const links = Array.from({ length: sides }, (_, i) => {
    const [a, b] = [corner(i), corner(i + 1)];
    return spawn(world, {
      position: { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 },
      rotation: Math.atan2(b.y - a.y, b.x - a.x),
      velocity: { x: 1, y: -6 },
      collider: { shape: capsule(0.7, 0.1), density: 10 + 90 * (i % 2) },
    });
  });
  links.forEach((b, i) => {
    createJoint(world, revolute({ a: links[(i + sides - 1) % sides] as number, b, anchor: corner(i) }));
  });
  return watch(world, links, keepsColumns);
}

/** A chain of bones that lands at an angle, on a plank that another holds, with limits that it reaches. */
function landChain(precision: 'f32' | 'f64', keepsColumns: boolean): Landing {
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
  return watch(world, [...bodies, plank, end], keepsColumns);
}

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  it.each([
    ['a chain', landChain],
    ['a closed track', landTrack],
  ] as const)('%s that lands moves as if each impulse were projected by itself', (_, land) => {
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
