// Bodies that become lighter, or that forces begin to move, while others press them: what pressed before is not done to them again.
import { box, type PhysicsWorld, setDensity, spawn, step } from '@principia/physics';
import { addComponents, removeComponent, set } from 'bitecs';
import { describe, expect, test } from 'vitest';
import { DT, G, rigidWorld, run, SLOP } from '../../../../test/support/rigid-world.ts';

/** The speed at which contacts push apart what overlaps, m/s. */
const PUSH_OUT = 3;

/** The fastest that bodies are in a second, m/s. */
function fastest(world: PhysicsWorld, bodies: readonly number[]): number {
  const { Velocity } = world.components;
  let most = 0;
  for (let i = 0; i < 60; i++) {
    step(world, DT);
    for (const body of bodies) most = Math.max(most, Math.hypot(Velocity.x[body], Velocity.y[body]));
  }
  return most;
}

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  test.each([0.9, 0.1, 1e-2, 1e-3, 1e-4])('a tower of which all bodies get %d of their mass stands still', (factor) => {
    const world = rigidWorld({ precision });
    spawn(world, { position: { y: -0.5 }, collider: { shape: box(60, 1) } });
    const collider = { shape: box(1, 1), density: 1000 };
    const tower = [0, 1, 2, 3, 4].map((i) => spawn(world, { position: { y: 0.5 + i }, neverSleep: {}, collider }));
    run(world, 2);
    const top = world.components.Position.y[tower[4]];
    for (const body of tower) setDensity(world, body, 1000 * factor);
    // All is in proportion: not even what gravity does in a sub-step is left.
    expect(fastest(world, tower)).toBeLessThan((G * DT) / 4);
    expect(Math.abs(world.components.Position.y[tower[4]] - top)).toBeLessThan(SLOP);
  });

  test.each([0.05, 0.2, 0.4])('a press that is let go %d m deep in a crate is pushed out, and not flung', (depth) => {
    const world = rigidWorld({ precision });
    const { Kinematic, Velocity } = world.components;
    spawn(world, { position: { y: -0.5 }, collider: { shape: box(60, 1) } });
    spawn(world, { position: { x: 1.5, y: 2 }, collider: { shape: box(1, 4) } });
    const collider = { shape: box(1, 1), density: 100 };
    const crate = spawn(world, { position: { x: 0.5, y: 0.5 }, collider });
    const press = spawn(world, {
      position: { x: -0.6, y: 0.5 },
      velocity: { x: 0.5 },
      kinematic: {},
      collider,
    });
    run(world, (0.1 + depth) / 0.5);
    Velocity.x[press] = 0;
    run(world, 0.5);
    removeComponent(world, press, Kinematic);
    expect(fastest(world, [press, crate])).toBeLessThan(PUSH_OUT);
  });

  test('a block that stood in a crate and falls from now on is pushed out, and not flung', () => {
    const world = rigidWorld({ precision });
    const { AngularVelocity, Inertia, Mass, Position, Velocity } = world.components;
    spawn(world, { position: { y: -0.5 }, collider: { shape: box(60, 1) } });
    const block = spawn(world, { position: { y: 1.3 }, collider: { shape: box(1, 1) } });
    const crate = spawn(world, { position: { y: 0.5 }, collider: { shape: box(1, 1), density: 100 } });
    run(world, 1);
    addComponents(world, block, set(Mass, { value: 100 }), set(Inertia, { value: 100 / 6 }), Velocity, AngularVelocity);
    expect(fastest(world, [block, crate])).toBeLessThan(PUSH_OUT);
    run(world, 1);
    expect(Position.y[block]).toBeCloseTo(1.5, 2);
  });
});
