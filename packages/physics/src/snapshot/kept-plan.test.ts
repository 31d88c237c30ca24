// A restore keeps the compiled loops and the plan of a world where the snapshot contains all that they need, and nothing
// else depends on whether it does.
import {
  createPhysicsWorld,
  energy,
  linearDrag,
  on,
  type PhysicsWorld,
  quadraticDrag,
  restore,
  rigidBodies,
  snapshot,
  spawn,
  standard,
  stateHash,
  step,
  uniformGravity,
} from '@principia/physics';
import { afterEach, describe, expect, test } from 'vitest';

const { Instance } = WebAssembly;
afterEach(() => {
  WebAssembly.Instance = Instance;
});

/** Counts the loops that are made from now on. */
function countInstances(): () => number {
  let count = 0;
  WebAssembly.Instance = class extends Instance {
    constructor(module: WebAssembly.Module, imports?: WebAssembly.Imports) {
      super(module, imports);
      count++;
    }
  };
  return () => count;
}

const run = (world: PhysicsWorld, steps: number) => {
  for (let i = 0; i < steps; i++) step(world, 1 / 60);
};

const body = (x: number) => ({ position: { x, y: 3 }, velocity: { x: 1 }, mass: 1, collider: 0.3 });

describe.each([standard, rigidBodies])('$name', (preset) => {
  const build = () => {
    const forces = [uniformGravity({ y: -7 }), linearDrag()];
    const world = createPhysicsWorld({ preset, capacity: 50, forces, onWarning: () => {} });
    for (const x of [0, 2, 4]) spawn(world, { ...body(x), linearDrag: 0.1 });
    return world;
  };

  test('a rollback makes no loop and no plan', () => {
    const world = build();
    run(world, 2);
    const taken = snapshot(world);
    const { plan } = world.internal;
    run(world, 3);
    const instances = countInstances();
    restore(world, taken);
    run(world, 3);
    expect(instances()).toBe(0);
    expect(world.internal.plan).toBe(plan);
  });

  test('a restore to before the first step makes no loop that is there already', () => {
    const world = build();
    const taken = snapshot(world);
    run(world, 3);
    const hash = stateHash(world);
    const instances = countInstances();
    restore(world, taken);
    run(world, 3);
    expect(instances()).toBe(0);
    expect(stateHash(world)).toBe(hash);
  });

  test('a loop that was made after the snapshot is made again, with its numbers in memory', () => {
    const world = build();
    run(world, 2);
    const taken = snapshot(world);
    // The potential energy of the law is summed by a loop with a block of memory.
    const before = energy(world);
    restore(world, taken);
    expect(energy(world)).toEqual(before);
    run(world, 30);
    const straight = build();
    run(straight, 32);
    expect(stateHash(world)).toBe(stateHash(straight));
    expect(energy(world)).toEqual(energy(straight));
  });

  test('a force that came after the snapshot acts until the restore, and not beyond', () => {
    const world = build();
    run(world, 2);
    const taken = snapshot(world);
    world.forces.push(uniformGravity({ x: 5 }));
    run(world, 3);
    restore(world, taken);
    run(world, 5);
    const straight = build();
    run(straight, 7);
    expect(stateHash(world)).toBe(stateHash(straight));
  });
});

/** A world in whose future one body had a component, and in whose present another has one of as many fields. */
function otherFuture(future: object, present: object) {
  const warnings: string[] = [];
  const world = createPhysicsWorld({
    capacity: 50,
    forces: [uniformGravity(), quadraticDrag()],
    onWarning: ({ message }) => void warnings.push(message),
  });
  spawn(world, body(0));
  run(world, 2);
  const taken = snapshot(world);
  spawn(world, { ...body(2), ...future });
  run(world, 1);
  const { membership } = world.versions;
  restore(world, taken);
  const id = spawn(world, { ...body(2), ...present });
  // The number of changes is that of the other future.
  expect(world.versions.membership).toBe(membership);
  return { world, warnings, id };
}

test('components that come after a restore are looked at for warnings', () => {
  const { world, warnings } = otherFuture({ quadraticDrag: 1 }, { linearDrag: 1 });
  run(world, 1);
  expect(warnings).toEqual([expect.stringContaining('LinearDrag has no effect')]);
});

test('coefficients that come after a restore are checked', () => {
  const { world, id } = otherFuture({ appearance: 0xff00ff00 }, { linearDrag: 1 });
  const faults: unknown[] = [];
  on(world, 'fault', ({ entity, field }) => void faults.push([entity, field]));
  run(world, 1);
  world.components.LinearDrag.coefficient[id] = -1;
  run(world, 128);
  expect(faults).toEqual([[id, 'LinearDrag.coefficient']]);
});
