import { createPhysicsWorld, keepState, spawn, stateHash, step, uniformGravity } from '@principia/physics';
import { expect, it } from 'vitest';
import { History } from './history.ts';

/** A stone that falls, and a count kept beside its world. */
function falling(clock = () => 0) {
  const world = createPhysicsWorld({ capacity: 9, forces: [uniformGravity()] });
  const stone = spawn(world, { position: {}, mass: 1 });
  const sim = { world, dt: 0.01 };
  const beside = { count: 0 };
  keepState(world, beside);
  const history = new History(sim, clock);
  const run = (steps: number) => {
    for (let i = 0; i < steps; i++) {
      step(world, sim.dt);
      beside.count++;
      history.record();
    }
  };
  return { world, stone, beside, history, run };
}

it('goes back to the last moment that is not too late', () => {
  const { world, stone, beside, history, run } = falling();
  run(100);
  const end = stateHash(world);
  expect(history.restoreTo(0.512)).toBe(true);
  // A moment is kept every twentieth of a second.
  expect(world.tick).toBe(50);
  expect(beside.count).toBe(50);
  // Velocity Verlet is exact in a constant field.
  expect(world.components.Position.y[stone]).toBeCloseTo(-0.5 * 9.80665 * 0.25, 12);
  expect(history.restoreTo(0.512)).toBe(false);
  run(50);
  expect(stateHash(world)).toBe(end);
});

it('keeps twenty seconds, and stops at the first moment', () => {
  const { world, history, run } = falling();
  run(3000);
  expect(history.length).toBeGreaterThan(19.5);
  expect(history.length).toBeLessThan(20.5);
  history.restoreTo(-1);
  expect(world.time).toBeCloseTo(10, 0);
  expect(history.restoreTo(-1)).toBe(false);
});

it('notes fewer moments where they cost much', () => {
  let now = 0;
  // Every look at the clock is 20 ms after the last: a moment takes 0.02 s, so one every half second.
  const { world, history, run } = falling(() => {
    now += 20;
    return now;
  });
  run(100);
  history.restoreTo(0.99);
  expect(world.tick).toBe(50);
});
