// What is refused for want of memory takes none.
import {
  createPhysicsWorld,
  createRope,
  implicitEuler,
  PhysicsError,
  type PhysicsWorld,
  particleContacts,
  resource,
  rungeKutta4,
  springs,
  step,
  uniformGravity,
  xpbd,
} from '@principia/physics';
import { describe, expect, it, vi } from 'vitest';
import { allocate } from './arena.ts';

function errorOf(act: () => void): PhysicsError {
  try {
    act();
  } catch (error) {
    if (error instanceof PhysicsError) return error;
    throw error;
  }
  throw new Error('nothing was thrown');
}

function ropeWorld(arenaBytes?: number): PhysicsWorld {
  const forces = [uniformGravity(), springs()];
  const room = arenaBytes === undefined ? {} : { arenaBytes };
  const world = createPhysicsWorld({ preset: particleContacts, forces, ...room });
  createRope(world, { from: {}, to: { x: 5 }, nodes: 10, mass: 1, stiffness: 100 });
  return world;
}

const usedBy = (world: PhysicsWorld) => {
  const { top, staggered } = world.internal.arena;
  return { top, staggered };
};

describe('a world that gets no memory', () => {
  it('says whether it is too large, or others hold what there is', () => {
    const memory = vi.spyOn(WebAssembly, 'Memory').mockImplementation(() => {
      throw new RangeError('could not allocate memory');
    });
    const hintFor = (capacity: number) => {
      const error = errorOf(() => createPhysicsWorld({ capacity }));
      expect(error.code).toBe('E_CAPACITY');
      return error.hint;
    };
    try {
      expect(hintFor(100)).toContain('destroy worlds');
      expect(hintFor(16e6)).toContain('at most 4096 MiB');
    } finally {
      memory.mockRestore();
    }
  });
});

describe('an integrator that does not fit', () => {
  it('leaves the memory to others, however often it is tried', () => {
    const world = ropeWorld();
    step(world, 1e-3);
    const before = usedBy(world);
    world.integrator = implicitEuler();
    for (let i = 0; i < 3; i++) expect(errorOf(() => step(world, 1e-3)).code).toBe('E_CAPACITY');
    expect(usedBy(world)).toEqual(before);
    for (const integrator of [xpbd(), rungeKutta4]) {
      world.integrator = integrator;
      step(world, 1e-3);
    }
    expect(world.tick).toBe(3);
  });

  it('names the present memory and one that is enough', () => {
    const world = ropeWorld();
    world.integrator = implicitEuler();
    const { message } = errorOf(() => step(world, 1e-3));
    const [, enough, present] = /`arenaBytes: (\d+)` or more; it has (\d+)\./.exec(message) ?? [];
    expect(Number(present)).toBe(world.internal.arena.arenaBytes);
    const larger = ropeWorld(Number(enough));
    larger.integrator = implicitEuler();
    step(larger, 1e-3);
    expect(larger.tick).toBe(1);
  });
});

describe('a resource whose creation fails', () => {
  const fill = (world: PhysicsWorld, bytes: number) => {
    const at = allocate(world.internal.arena, bytes, 'test');
    new Uint8Array(world.memory.buffer, at, bytes).fill(7);
    return at;
  };

  it('gives its memory back, all zero', () => {
    const world = createPhysicsWorld({ capacity: 10 });
    const before = usedBy(world);
    const broken = resource((w) => {
      for (const bytes of [10, 5000, 100_000]) fill(w, bytes);
      throw new RangeError('no');
    });
    expect(() => broken(world)).toThrow('no');
    expect(usedBy(world)).toEqual(before);
    const { buffer } = world.memory;
    expect(new Uint8Array(buffer, before.top).every((byte) => byte === 0)).toBe(true);
  });

  it('keeps that of the resources it has made', () => {
    const world = createPhysicsWorld({ capacity: 10 });
    const inner = resource((w) => fill(w, 1000));
    const broken = resource((w) => {
      inner(w);
      fill(w, 5000);
      throw new RangeError('no');
    });
    for (let i = 0; i < 3; i++) expect(() => broken(world)).toThrow('no');
    const at = inner(world);
    expect(world.internal.arena.top).toBe(at + 1000);
    expect(new Uint8Array(world.memory.buffer, at, 1000).every((byte) => byte === 7)).toBe(true);
    expect(new Uint8Array(world.memory.buffer, at + 1000).every((byte) => byte === 0)).toBe(true);
  });
});
