// Exceptions of user code at the end of a step: of `onWarning`, and of steps that a runner makes.
import {
  contactEvents,
  createPhysicsWorld,
  createRunner,
  destroyWorld,
  rigidBodies,
  spawn,
  step,
  uniformGravity,
} from '@principia/physics';
import { expect, test } from 'vitest';

const DT = 1 / 60;

function errorsOf(act: () => void): string[] {
  try {
    act();
  } catch (error) {
    if (error instanceof AggregateError) return error.errors.map((each) => (each as Error).message);
    return [`alone: ${(error as Error).message}`];
  }
  return [];
}

test('what onWarning throws comes with the other exceptions of its step, and the world is destroyed as it was told', () => {
  const world = createPhysicsWorld({
    capacity: 10,
    forces: [uniformGravity(), uniformGravity()],
    onWarning: ({ message }) => {
      throw new Error(`warned: ${message}`);
    },
  });
  world.phases.events.push(() => {
    destroyWorld(world);
    throw new Error('of a system');
  });
  const errors = errorsOf(() => step(world, DT));
  expect(errors[0]).toBe('of a system');
  expect(errors[1]).toMatch(/^warned: /);
  expect(world.state).toBe('destroyed');
});

test('a runner tells of a step that threw, and of no step that was refused', () => {
  const world = createPhysicsWorld({ preset: rigidBodies, capacity: 10, forces: [uniformGravity()] });
  spawn(world, { position: { y: -0.5 }, collider: { radius: 0.5 } });
  spawn(world, { position: { y: 0.52 }, velocity: { y: -2 }, collider: { radius: 0.5, density: 1 } });
  world.phases.events.push(({ tick }) => {
    if (tick % 2 === 0) throw new Error('of a system');
  });
  const told: number[] = [];
  let begun = 0;
  let throws = false;
  const runner = createRunner(world, {
    dt: DT,
    afterStep: () => {
      told.push(world.tick);
      begun += contactEvents(world).begin.count;
      if (throws) throw new Error('of afterStep');
    },
  });
  for (let i = 0; i < 4; i++) errorsOf(() => runner.advance(DT));
  expect(told).toEqual([1, 2, 3, 4]);
  expect(begun).toBe(1);
  throws = true;
  expect(errorsOf(() => runner.advance(DT))).toEqual(['of a system', 'of afterStep']);
  world.time = Number.NaN;
  expect(errorsOf(() => runner.advance(DT))[0]).toMatch(/^alone: E_NONFINITE/);
  expect(told).toEqual([1, 2, 3, 4, 5]);
});
