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
  // The first one runs cold and does not count: the second comes after a twentieth of a second.
  run(100);
  history.restoreTo(0.99);
  expect(world.tick).toBe(55);
});

it('leaves no gap after a moment that was interrupted', () => {
  let now = 0;
  let cost = 20;
  const { world, history, run } = falling(() => {
    now += cost;
    return now;
  });
  cost = 0.1;
  run(20);
  cost = 500;
  run(10);
  cost = 0.1;
  run(70);
  const ticks = Array.from({ length: history.count }, (_, i) => Math.round(history.timeAt(i) / 0.01));
  expect(ticks).toEqual(Array.from({ length: 21 }, (_, i) => 5 * i));
  expect(world.tick).toBe(100);
});

it('goes to and fro among the moments, each with the bits that it had', () => {
  const { world, beside, history, run } = falling();
  const hashes = new Map<number, string>();
  for (let i = 0; i < 103; i++) {
    hashes.set(world.tick, stateHash(world));
    run(1);
  }
  hashes.set(world.tick, stateHash(world));
  const at = () => [world.tick, beside.count, history.hasLater, stateHash(world) === hashes.get(world.tick)];
  expect(history.seek(0.512)).toBe(true);
  expect(at()).toEqual([50, 50, true, true]);
  expect(history.seek(0.86)).toBe(true);
  expect(at()).toEqual([85, 85, true, true]);
  expect(history.seek(-1)).toBe(true);
  expect(at()).toEqual([0, 0, true, true]);
  expect(history.seek(0)).toBe(false);
  // The present is kept too, though it lies between two moments of the recording.
  expect(history.seek(9)).toBe(true);
  expect(at()).toEqual([103, 103, false, true]);
  expect([history.count, history.index, history.timeAt(0)]).toEqual([22, 21, 0]);
});

it('forgets what was recorded later once the world steps on from the past', () => {
  const { world, history, run } = falling();
  run(100);
  history.seek(0.5);
  expect([history.count, history.index]).toEqual([21, 10]);
  run(1);
  expect([history.count, history.hasLater]).toEqual([11, false]);
  run(49);
  history.seek(9);
  expect(world.tick).toBe(100);
  // A rewind keeps what lies after it as well.
  history.restoreTo(0.3);
  expect([world.tick, history.hasLater]).toEqual([30, true]);
  history.seek(1);
  expect(world.tick).toBe(100);
});

it('does not come back to a present that is not kept', () => {
  const { world, history, run } = falling();
  run(53);
  history.seek(0.2, false);
  history.seek(9);
  expect(world.tick).toBe(50);
});

it('records as many moments in any span', () => {
  const world = createPhysicsWorld({ capacity: 9 });
  const history = new History({ world, dt: 0.1 }, () => 0, 200);
  for (let i = 0; i < 3000; i++) {
    step(world, 0.1);
    history.record();
    if (i % 700 === 0) history.seek(world.time - 3);
  }
  expect([history.count, history.timeAt(0)]).toEqual([400, expect.closeTo(world.time - 200, -1)]);
});

it('goes back step by step, to the bits that the world had, and on again', () => {
  const { world, history } = falling();
  const hashes = [stateHash(world)];
  for (let i = 0; i < 64; i++) {
    step(world, 0.01);
    history.record();
    hashes.push(stateHash(world));
  }
  for (let tick = 63; tick >= 50; tick--) {
    expect(history.stepBack()).toBe(true);
    expect([world.tick, stateHash(world)]).toEqual([tick, hashes[tick]]);
  }
  step(world, 0.01);
  history.record();
  expect(stateHash(world)).toBe(hashes[51]);
  history.seek(-1);
  expect(history.stepBack()).toBe(false);
});

it('goes back to the last moment where the steps since then cannot be repeated', () => {
  const { world, stone, history, run } = falling();
  run(62);
  world.components.Velocity.y[stone] = 3;
  run(2);
  history.stepBack();
  expect(world.tick).toBe(60);
  history.stepBack();
  expect(world.tick).toBe(59);
});

it('goes back to the last moment before a step that throws', () => {
  const world = createPhysicsWorld({ capacity: 9 });
  world.phases.input.push(() => {
    if (world.tick === 63) throw new Error('No further.');
  });
  const history = new History({ world, dt: 0.01 }, () => 0);
  const run = () => {
    step(world, 0.01);
    history.record();
    run();
  };
  expect(run).toThrow('No further.');
  expect([history.stepBack(), world.tick]).toEqual([true, 60]);
});
