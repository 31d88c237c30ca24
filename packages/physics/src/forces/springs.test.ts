import { describe, expect, test } from 'vitest';
import { despawn, spawn } from '../bodies/spawn.ts';
import { spawnMany } from '../bodies/spawn-many.ts';
import { energy, momentum } from '../diagnostics/energy.ts';
import { stateHash } from '../diagnostics/hash.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { rungeKutta4 } from '../integrators/runge-kutta-4.ts';
import { semiImplicitEuler } from '../integrators/semi-implicit-euler.ts';
import { velocityVerlet } from '../integrators/velocity-verlet.ts';
import { rigidBodies } from '../presets/rigid-bodies.ts';
import { softStep } from '../solver/soft-step.ts';
import { createPhysicsWorld, type PhysicsWorldOptions } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { removedSprings, springs } from './springs.ts';
import { uniformGravity } from './uniform-gravity.ts';

function springWorld(options: PhysicsWorldOptions = {}): PhysicsWorld {
  return createPhysicsWorld({ capacity: 100, forces: [springs()], ...options });
}

/** Makes two bodies joined by a spring. */
function pair(world: PhysicsWorld, spring: object, gap = 2, masses: readonly [number, number] = [1, 1]) {
  const a = spawn(world, { position: {}, velocity: {}, mass: masses[0] });
  const b = spawn(world, { position: { x: gap }, velocity: {}, mass: masses[1] });
  const id = spawn(world, { spring: { a, b, stiffness: 1, ...spring } });
  return { a, b, id };
}

/** Returns the error code of a throwing function. */
function codeOf(act: () => unknown): string {
  try {
    act();
  } catch (error) {
    return error instanceof PhysicsError ? error.code : String(error);
  }
  return 'nothing';
}

describe('springs', () => {
  test('a free pair oscillates about its centre of mass with ω² = k/μ', () => {
    const world = springWorld();
    const { a, b } = pair(world, { stiffness: 3, length: 1 }, 1.5, [1, 2]);
    const omega = Math.sqrt(3 / (2 / 3));
    const steps = 4000;
    const dt = (2 * Math.PI) / omega / steps;
    for (let i = 0; i < steps / 4; i++) step(world, dt);
    const x = world.components.Position.x;
    expect(x[b] - x[a]).toBeCloseTo(1, 5);
    for (let i = 0; i < steps / 4; i++) step(world, dt);
    expect(x[b] - x[a]).toBeCloseTo(0.5, 5);
    expect((x[a] + 2 * x[b]) / 3).toBeCloseTo(1, 12);
    expect(Math.abs(momentum(world).x)).toBeLessThan(1e-14);
  });

  test('an anchor does not move, and damping dissipates energy', () => {
    const world = springWorld();
    const { a, b } = pair(world, { stiffness: 10, damping: 0.5 }, 1, [Infinity, 1]);
    const start = energy(world).total;
    expect(start).toBeCloseTo(5, 12);
    let last = start;
    for (let i = 0; i < 100; i++) {
      step(world, 0.01);
      const now = energy(world).total;
      expect(now).toBeLessThan(last + 2e-4);
      last = now;
    }
    expect(world.components.Position.x[a]).toBe(0);
    // The energy decays as e^(-c t / m) (ch08-damped).
    expect(last / start).toBeCloseTo(Math.exp(-0.5), 1);
    expect(world.components.Position.x[b]).not.toBe(1);
  });

  test('the forces of a pair are equal and opposite to the last bit, in 2D and 3D', () => {
    for (const dimensions of [2, 3] as const) {
      for (const precision of ['f32', 'f64'] as const) {
        const world = springWorld({ dimensions, precision });
        const z = dimensions === 3 ? 0.3 : 0;
        const a = spawn(world, { position: { x: 0.1, y: 0.7, z }, velocity: { x: 1 }, mass: 1 });
        const b = spawn(world, { position: { x: 0.37, y: -0.2 }, velocity: { y: 2 }, mass: 1 });
        spawn(world, { spring: { a, b, stiffness: 7, damping: 0.3, length: 2 } });
        const before = momentum(world);
        step(world, 0.01);
        const { x, y, z: fz } = world.scratch.force;
        for (const f of [x, y, fz]) expect(f[a] + f[b]).toBe(0);
        expect(x[a]).not.toBe(0);
        expect(momentum(world).x).toBeCloseTo(before.x, precision === 'f32' ? 6 : 14);
      }
    }
  });

  test('coincident ends are pushed apart along x, reproducibly', () => {
    const run = () => {
      const world = springWorld();
      const { a, b } = pair(world, { length: 1, damping: 0.1 }, 0);
      step(world, 0.01);
      expect(world.components.Position.x[a]).toBeLessThan(0);
      expect(world.components.Position.x[b]).toBe(-world.components.Position.x[a]);
      return stateHash(world);
    };
    expect(run()).toBe(run());
  });

  test('a tension-only spring pulls and never pushes', () => {
    const world = springWorld();
    const slack = pair(world, { length: 3, tensionOnly: 1, damping: 10 }, 2);
    step(world, 0.01);
    expect(world.components.Velocity.x[slack.b]).toBe(0);
    expect(energy(world).potential).toBe(0);
    world.components.Position.x[slack.b] = 4;
    step(world, 0.01);
    expect(world.components.Velocity.x[slack.b]).toBeLessThan(0);
    // The spring is taut but its ends approach fast: the damper alone would push.
    world.components.Velocity.x[slack.b] = -100;
    world.components.Velocity.x[slack.a] = 0;
    step(world, 1e-6);
    expect(world.components.Velocity.x[slack.a]).toBe(0);
  });

  test('bungee jump: energy gives the lowest point (ch08-bungee without drag)', () => {
    const world = springWorld({ integrator: velocityVerlet });
    const { components } = world;
    const top = spawn(world, { position: {} });
    const jumper = spawn(world, { position: {}, velocity: {}, mass: 90 });
    spawn(world, { spring: { a: top, b: jumper, stiffness: 25, length: 100, tensionOnly: 1 } });
    world.forces.push(uniformGravity({ y: -20 }));
    let lowest = 0;
    for (let i = 0; i < 3000; i++) {
      step(world, 1 / 240);
      lowest = Math.min(lowest, components.Position.y[jumper]);
    }
    expect(lowest).toBeCloseTo(-(361.94 - 50), 1);
  });
});

describe('the ends of springs', () => {
  test('identical, removed or missing bodies are rejected before anything is created', () => {
    const world = springWorld();
    const a = spawn(world, { position: {} });
    const hash = stateHash(world);
    expect(codeOf(() => spawn(world, { spring: { a, b: a } }))).toBe('E_RANGE');
    expect(codeOf(() => spawn(world, { spring: { a } }))).toBe('E_RANGE');
    expect(codeOf(() => spawn(world, { spring: { a, b: 77 } }))).toBe('E_STALE');
    expect(codeOf(() => spawn(world, { spring: { a, b: 1e9 } }))).toBe('E_STALE');
    expect(codeOf(() => spawnMany(world, 2, { spring: { a, b: [2, 3] } }))).toBe('E_STALE');
    expect(stateHash(world)).toBe(hash);
    expect(world.lastId).toBe(a);
  });

  test('a spring is removed with its body and never pulls a body that reuses its id', () => {
    const world = springWorld();
    const { a, b, id } = pair(world, { stiffness: 100, length: 1 });
    despawn(world, b);
    const heir = spawn(world, { position: { x: 5 }, velocity: {}, mass: 1 });
    expect(heir).toBe(b);
    step(world, 0.01);
    expect(removedSprings(world)).toEqual([id]);
    expect(world.internal.counts.Spring).toBe(0);
    expect(world.components.Velocity.x[heir]).toBe(0);
    expect(world.components.Velocity.x[a]).toBe(0);
    step(world, 0.01);
    expect(removedSprings(world)).toEqual([]);
  });

  test('springs created in bulk or during a step act on their bodies', () => {
    const world = springWorld();
    const ids = spawnMany(world, 11, {
      position: { x: Array.from({ length: 11 }, (_, i) => 2 * i) },
      velocity: {},
      mass: 1,
    });
    spawnMany(world, 10, { spring: { a: ids.slice(0, 10), b: ids.slice(1), stiffness: 1, length: 1 } });
    let made = 0;
    world.phases.input.push((w) => {
      if (made > 0) return;
      const fresh = spawn(w, { position: { x: -2 }, velocity: {}, mass: 1 });
      made = spawn(w, { spring: { a: fresh, b: ids[0], stiffness: 1, length: 1 } });
    });
    step(world, 0.01);
    step(world, 0.01);
    expect(removedSprings(world)).toEqual([]);
    expect(world.internal.counts.Spring).toBe(11);
    expect(world.components.Velocity.x[ids[10]]).toBeLessThan(0);
    expect(world.components.Spring.a[made]).toBeGreaterThan(0);
    expect(Math.abs(momentum(world).x)).toBeLessThan(1e-14);
  });

  test('invalid ids written to the columns have no effect', () => {
    const world = springWorld();
    const { a, b, id } = pair(world, { stiffness: 1, length: 1 });
    world.components.Spring.b[id] = 0xffffffff;
    step(world, 0.01);
    world.components.Spring.b[id] = a;
    step(world, 0.01);
    expect(world.components.Velocity.x[b]).toBe(0);
  });
});

describe('springs too stiff for the step', () => {
  test('k = 1e15 is refused before anything moves', () => {
    for (const integrator of [semiImplicitEuler, velocityVerlet, rungeKutta4]) {
      const world = springWorld({ integrator });
      pair(world, { stiffness: 1e15, length: 1 });
      const hash = stateHash(world);
      expect(codeOf(() => step(world, 1 / 60))).toBe('E_STIFF');
      expect(stateHash(world)).toBe(hash);
      expect(world.tick).toBe(0);
      step(world, 1e-9);
    }
  });

  test('a rod is refused with what solves it: not with a step of 1e-16 s', () => {
    const world = springWorld();
    pair(world, { stiffness: Infinity, length: 1 });
    expect(() => step(world, 1 / 60)).toThrow(/is a rod or a string.*xpbd\(\)/);
    const rigid = createPhysicsWorld({ preset: rigidBodies, capacity: 50, forces: [springs()] });
    pair(rigid, { stiffness: Infinity, length: 1 });
    expect(() => step(rigid, 1 / 60)).toThrow(/is a rod or a string.*joints/);
  });

  test('just inside the limit the energy stays bounded; just outside it would not', () => {
    for (const [integrator, limit] of [
      [semiImplicitEuler, 2],
      [velocityVerlet, 2],
      [rungeKutta4, 2 * Math.SQRT2],
    ] as const) {
      const world = springWorld({ integrator });
      const { a, b } = pair(world, { stiffness: 1 }, 1, [Infinity, 1]);
      for (let i = 0; i < 2000; i++) step(world, 0.99 * limit);
      const { x } = world.components.Position;
      expect(Math.abs(x[b] - x[a])).toBeLessThan(20);
      expect(codeOf(() => step(world, 1.01 * limit))).toBe('E_STIFF');
    }
  });

  test('the recommended step is the longest that is taken, and so are the sub-steps of rigid bodies', () => {
    const advice = (act: () => void, pattern: RegExp) => {
      try {
        act();
      } catch (error) {
        return Number(pattern.exec((error as PhysicsError).hint ?? '')?.[1]);
      }
      return undefined;
    };
    for (const integrator of [semiImplicitEuler, velocityVerlet, rungeKutta4, softStep()]) {
      const preset = integrator.solvesWalls === true ? { preset: rigidBodies } : {};
      const world = createPhysicsWorld({ ...preset, capacity: 50, forces: [springs()], integrator });
      pair(world, { stiffness: 20_000 });
      const longest = advice(() => step(world, 1 / 10), /at most ([\d.]+) s/) as number;
      // Two digits are said.
      expect(codeOf(() => step(world, 1.06 * longest))).toBe('E_STIFF');
      step(world, 0.94 * longest);
      const substeps = advice(() => step(world, 1 / 10), /substeps: (\d+)/);
      if (integrator.solvesWalls !== true) continue;
      world.integrator = softStep({ substeps: substeps as number });
      step(world, 1 / 10);
    }
  });

  test('strong damping is refused as well, and the recommended step is accepted', () => {
    for (const integrator of [semiImplicitEuler, velocityVerlet, rungeKutta4]) {
      const world = springWorld({ integrator });
      pair(world, { stiffness: 3, damping: 500 });
      expect(codeOf(() => step(world, 1 / 60))).toBe('E_STIFF');
      for (let w = 0; w <= 4; w += 0.05) {
        expect(integrator.isStable?.(w, (4 - w) / 2), `${integrator.name} ${w}`).toBe(true);
      }
    }
  });

  test('springs whose maxima together exceed the limit, but none alone, are accepted', () => {
    const world = springWorld();
    pair(world, { stiffness: 0.49 * 3.9, damping: 0 }, 1);
    pair(world, { stiffness: 0, damping: 0.9 }, 1);
    step(world, 1);
  });
});

test('the fault of a chain that is unstable though each spring is not names the springs', () => {
  const world = createPhysicsWorld({ forces: [springs()], onWarning: () => {} });
  const nodes = Array.from({ length: 50 }, (_, i) =>
    spawn(world, { position: { x: i + (i % 2) * 1e-3 }, velocity: {}, mass: 1 }),
  );
  // k dt²/μ = 3.6 with the reduced mass μ = 1/2 is below the 4 of a single spring, and 4 k dt²/m = 7.2 of the chain above it.
  for (let i = 0; i < 49; i++) spawn(world, { spring: { a: nodes[i], b: nodes[i + 1], stiffness: 1.8e4, length: 1 } });
  for (let i = 0; i < 300 && world.faults.faults.length === 0; i++) step(world, 0.01);
  expect(world.faults.faults[0]).toMatchObject({ code: 'E_SPEED' });
  expect(world.faults.faults[0].hint).toMatch(/^Springs may be the cause: a network needs steps/);
});
