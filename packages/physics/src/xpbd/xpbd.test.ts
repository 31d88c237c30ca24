import { describe, expect, test } from 'vitest';
import { spawn } from '../bodies/spawn.ts';
import { angularMomentum, energy, momentum } from '../diagnostics/energy.ts';
import { stateHash } from '../diagnostics/hash.ts';
import { linearDrag } from '../forces/drag.ts';
import { springs } from '../forces/springs.ts';
import { uniformGravity } from '../forces/uniform-gravity.ts';
import { velocityVerlet } from '../integrators/velocity-verlet.ts';
import { createCloth } from '../soft-bodies/cloth.ts';
import { createRope } from '../soft-bodies/rope.ts';
import { createPhysicsWorld, type PhysicsWorldOptions } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { breakSprings, brokenSprings } from './breaking.ts';
import { maxStrain } from './stretch.ts';
import { xpbd } from './xpbd.ts';

function constrainedWorld(options: PhysicsWorldOptions = {}): PhysicsWorld {
  return createPhysicsWorld({ capacity: 500, integrator: xpbd(), forces: [springs()], ...options });
}

/** Makes a bob of 1 kg on a string of 200 m from the pivot (0, 0), at 30 degrees, g = 100 m/s². */
function pendulum(integrator = xpbd()) {
  const world = constrainedWorld({ integrator, forces: [uniformGravity({ y: -100 }), springs()] });
  const pivot = spawn(world, { position: {} });
  const bob = spawn(world, { position: { x: 100, y: -100 * Math.sqrt(3) }, velocity: {}, mass: 1 });
  spawn(world, { spring: { a: pivot, b: bob, length: 200, stiffness: Infinity, tensionOnly: 1 } });
  return { world, bob };
}

/** Returns the mean time between passages to the left, s. */
function periodOf(world: PhysicsWorld, bob: number, dt: number, seconds: number): number {
  const { x } = world.components.Position;
  const passages: number[] = [];
  for (let s = 0; s < seconds / dt; s++) {
    const before = x[bob];
    step(world, dt);
    if (before > 0 && x[bob] <= 0) passages.push((s + before / (before - x[bob])) * dt);
  }
  return (passages[passages.length - 1] - passages[0]) / (passages.length - 1);
}

describe('rods and strings', () => {
  test('a pendulum keeps its length, its period and its energy over 100 s (ch09-pendulum)', () => {
    const { world, bob } = pendulum();
    const { Position, Velocity } = world.components;
    const start = energy(world).total;
    let [largestError, drift, fastest] = [0, 0, 0];
    world.phases.events.push(() => {
      largestError = Math.max(largestError, Math.abs(Math.hypot(Position.x[bob], Position.y[bob]) - 200));
      drift = Math.max(drift, Math.abs(energy(world).total - start));
      fastest = Math.max(fastest, Math.hypot(Velocity.x[bob], Velocity.y[bob]));
    });
    const period = periodOf(world, bob, 1 / 60, 100);
    expect(Math.abs(period / 9.04046 - 1)).toBeLessThan(1e-4);
    expect(largestError).toBeLessThan(1e-9);
    expect(fastest).toBeCloseTo(73.205, 1);
    expect(drift / 2679.5).toBeLessThan(1e-3);
  });

  test('the error of the period falls with the square of the sub-step', () => {
    const error = (substeps: number) => {
      const { world, bob } = pendulum(xpbd({ substeps }));
      return Math.abs(periodOf(world, bob, 1 / 15, 60) - 9.0404586);
    };
    const [coarse, fine] = [error(1), error(2)];
    expect(coarse / fine).toBeGreaterThan(3.5);
    expect(coarse / fine).toBeLessThan(4.5);
  });

  test('a double pendulum is chaotic, and its energy stays bounded', () => {
    const run = (tilt: number) => {
      const world = constrainedWorld({ forces: [uniformGravity(), springs()] });
      const pivot = spawn(world, { position: {} });
      const inner = spawn(world, { position: { x: 1 }, velocity: {}, mass: 1 });
      const outer = spawn(world, { position: { x: 1, y: 1 }, velocity: { x: tilt }, mass: 1 });
      spawn(world, { spring: { a: pivot, b: inner, length: 1, stiffness: Infinity } });
      spawn(world, { spring: { a: inner, b: outer, length: 1, stiffness: Infinity } });
      const start = energy(world).total;
      let drift = 0;
      for (let s = 0; s < 40 * 480; s++) {
        step(world, 1 / 480);
        drift = Math.max(drift, Math.abs(energy(world).total - start));
      }
      expect(maxStrain(world)).toBeLessThan(1e-12);
      // 49 J is the energy difference between the highest and the lowest configuration.
      expect(drift).toBeLessThan(0.1);
      return world.components.Position.x[outer];
    };
    expect(Math.abs(run(0) - run(1e-9))).toBeGreaterThan(0.01);
  });

  test('a slack string exerts no force, a rod pushes, and a string does not bounce', () => {
    const world = constrainedWorld();
    const anchor = spawn(world, { position: {} });
    const free = spawn(world, { position: { x: 1 }, velocity: { x: 1 }, mass: 2 });
    spawn(world, { spring: { a: anchor, b: free, length: 2, stiffness: Infinity, tensionOnly: 1 } });
    const { Position, Velocity } = world.components;
    for (let s = 0; s < 50; s++) step(world, 0.01);
    expect(Velocity.x[free]).toBe(1);
    for (let s = 0; s < 100; s++) step(world, 0.01);
    expect(Position.x[free]).toBeCloseTo(2, 12);
    expect(Velocity.x[free]).toBeCloseTo(0, 12);
    const other = spawn(world, { position: { y: 1 }, velocity: { y: -1 }, mass: 1 });
    spawn(world, { spring: { a: anchor, b: other, length: 1, stiffness: Infinity } });
    step(world, 0.01);
    expect(Position.y[other]).toBeCloseTo(1, 12);
  });
});

describe('springs of finite stiffness', () => {
  test.each(['f32', 'f64'] as const)('extend by x = F/k in equilibrium, in %s', (precision) => {
    const world = constrainedWorld({ precision, forces: [uniformGravity({ y: -10 }), springs()] });
    const top = spawn(world, { position: {} });
    const weight = spawn(world, { position: { y: -1 }, velocity: {}, mass: 2 });
    spawn(world, { spring: { a: top, b: weight, length: 1, stiffness: 400, damping: 20 } });
    for (let s = 0; s < 2000; s++) step(world, 1 / 60);
    const extension = -world.components.Position.y[weight] - 1;
    expect(Math.abs(extension / 0.05 - 1)).toBeLessThan(precision === 'f32' ? 1e-4 : 1e-6);
  });

  test('a chain on a support has the analytic equilibrium and modes (ch08-coupled-chain)', () => {
    const modes = [0.7623, 2.2427, 3.5928, 4.734, 5.6001, 6.1408];
    modes.forEach((omega, m) => {
      const world = constrainedWorld({ forces: [uniformGravity({ y: -20 }), springs()] });
      const rest = [112, 172, 230, 286, 340, 392];
      let above = spawn(world, { position: { y: -50 } });
      const shape = rest.map((_, j) => Math.sin(((2 * m + 1) * Math.PI * (j + 1)) / 13));
      const ids = rest.map((depth, j) => {
        const id = spawn(world, { position: { y: -depth + shape[j] }, velocity: {}, mass: 1 });
        spawn(world, { spring: { a: above, b: id, length: 50, stiffness: 10 } });
        above = id;
        return id;
      });
      const { y } = world.components.Position;
      const amplitude = () => ids.reduce((sum, id, j) => sum + shape[j] * (y[id] + rest[j]), 0);
      // After a quarter of a period the amplitude passes through zero.
      let time = 0;
      for (let before = amplitude(); before > 0; time += 1e-3) {
        step(world, 1e-3);
        const now = amplitude();
        if (now <= 0) time += (1e-3 * now) / (before - now);
        before = now;
      }
      expect(Math.abs(Math.PI / 2 / time / omega - 1)).toBeLessThan(0.005);
    });
  });

  test('damping dissipates energy at the analytic rate, and is stable when too strong', () => {
    const end = (damping: number, integrator: PhysicsWorld['integrator']) => {
      const world = constrainedWorld({ integrator });
      const a = spawn(world, { position: {} });
      const b = spawn(world, { position: { x: 1.5 }, velocity: {}, mass: 1 });
      spawn(world, { spring: { a, b, length: 1, stiffness: 10, damping } });
      let last = energy(world).total;
      for (let s = 0; s < 2000; s++) {
        step(world, 1e-3);
        const now = energy(world).total;
        expect(now).toBeLessThan(last * (1 + 1e-5) + 1e-12);
        last = now;
      }
      return last;
    };
    // x = e^(-t/2) (cos ωt + sin ωt/2ω)/2 with ω² = 10 - 1/4, after 2 s.
    const omega = Math.sqrt(9.75);
    const x = 0.5 * Math.exp(-1) * (Math.cos(2 * omega) + Math.sin(2 * omega) / (2 * omega));
    const v = -0.5 * Math.exp(-1) * (10 / omega) * Math.sin(2 * omega);
    const exact = 0.5 * v * v + 5 * x * x;
    // The relative error of Verlet is about ω² dt²/12.
    expect(Math.abs(end(1, velocityVerlet) / exact - 1)).toBeLessThan(1e-5);
    // Backward Euler dissipates a fraction (ω² - 1/4) dt of the energy per second. It delays the phase by ω dt/2 per
    // second, 3e-3 in all, which changes an energy that oscillates by a sixth twice per period.
    expect(Math.abs(end(1, xpbd()) / (exact * Math.exp(-9.5 * 1e-3 * 2)) - 1)).toBeLessThan(1e-3);
    // Strong damping stops the body at the end of every step, so a step shortens the extension by a fraction k dt²/m.
    // The energy decays as e^(-2 k dt t/m), up to the square of this fraction.
    expect(Math.abs(end(1e6, xpbd()) / (1.25 * Math.exp(-2 * 10 * 1e-3 * 2)) - 1)).toBeLessThan(1e-4);
  });

  test('any stiffness is stable', () => {
    const world = constrainedWorld();
    const a = spawn(world, { position: {}, velocity: {}, mass: 1 });
    const b = spawn(world, { position: { x: 2 }, velocity: { y: 1 }, mass: 1 });
    spawn(world, { spring: { a, b, length: 1, stiffness: 1e15 } });
    for (let s = 0; s < 100; s++) step(world, 1 / 60);
    expect(maxStrain(world)).toBeLessThan(1e-3);
    expect(world.faults.faults).toEqual([]);
  });
});

describe('free networks', () => {
  test.each([2, 3] as const)(
    'conserve momentum to rounding, and a chain angular momentum as well, in %iD',
    (dimensions) => {
      const world = constrainedWorld({ dimensions });
      const net = createCloth(world, {
        corner: {},
        columns: 6,
        rows: 5,
        spacing: 0.1,
        mass: 1,
        shear: 1e4,
        pins: 'none',
      });
      net.nodes.forEach((node, i) => {
        world.components.Velocity.x[node] = Math.sin(i);
        world.components.Velocity.y[node] = Math.cos(3 * i);
      });
      const before = [momentum(world), angularMomentum(world).z] as const;
      for (let s = 0; s < 200; s++) step(world, 1 / 600);
      // Positions of size 1 are rounded at 1e-16, over steps of 1/600 s, in 200 steps of 10 iterations.
      expect(Math.abs(momentum(world).x - before[0].x)).toBeLessThan(1e-11);
      expect(Math.abs(momentum(world).y - before[0].y)).toBeLessThan(1e-11);
      expect(Math.abs(angularMomentum(world).z - before[1])).toBeLessThan(0.02);

      const chain = constrainedWorld({ dimensions });
      const rope = createRope(chain, { from: {}, to: { x: 1 }, nodes: 8, mass: 1, pins: 'none' });
      rope.nodes.forEach((node, i) => {
        chain.components.Velocity.y[node] = Math.cos(2 * i);
      });
      step(chain, 1 / 600);
      const spin = angularMomentum(chain).z;
      for (let s = 0; s < 600; s++) step(chain, 1 / 600);
      expect(Math.abs(angularMomentum(chain).z - spin)).toBeLessThan(1e-9);
    },
  );
});

describe('degenerate springs', () => {
  test.each(['f32', 'f64'] as const)('coincident ends, zero length and zero mass stay finite in %s', (precision) => {
    const world = constrainedWorld({ precision });
    const place = () => spawn(world, { position: { x: 1 }, velocity: {}, mass: 1 });
    const [a, b, c, d, e] = [place(), place(), place(), place(), place()];
    const held = [spawn(world, { position: {} }), spawn(world, { position: { y: 1 } })];
    for (const [from, to, length] of [
      [a, b, 1],
      [b, c, 0],
      [c, a, 1],
      [a, d, 1],
      [c, d, 1],
      [held[0], held[1], 5],
      [d, e, 1],
    ]) {
      spawn(world, { spring: { a: from, b: to, length, stiffness: Infinity } });
    }
    for (let s = 0; s < 20; s++) step(world, 1 / 60);
    for (const id of [a, b, c, d, e]) expect(Number.isFinite(world.components.Position.x[id])).toBe(true);
    expect(world.faults.faults).toEqual([]);
    expect(world.components.Position.y[held[1]]).toBe(1);
  });

  test('a bad position is reported and does not spread', () => {
    for (const cross of [0, 1e4]) {
      const world = constrainedWorld({ forces: [uniformGravity(), springs()] });
      const size = { corner: {}, columns: 4, rows: 4, spacing: 0.1, mass: 1 };
      const cloth = createCloth(world, { ...size, shear: cross, pins: 'corners' });
      step(world, 1 / 60);
      const bad = cloth.at(1, 2);
      world.phases.input.push((w) => {
        if (w.tick === 3) w.components.Velocity.x[bad] = 1e38;
        if (w.tick === 5) w.components.Position.x[bad] = Number.NaN;
      });
      for (let s = 0; s < 10; s++) step(world, 1 / 60);
      expect(world.faults.faults.length).toBeGreaterThan(0);
      for (const node of cloth.nodes) {
        expect(Math.abs(world.components.Position.x[node])).toBeLessThan(1e15);
        if (node !== bad) expect(world.components.Quarantined.step[node]).toBe(0);
      }
    }
  });

  test('changed ends and added or removed springs take effect', () => {
    const world = constrainedWorld();
    const [a, b, c] = [0, 1, 2].map((x) => spawn(world, { position: { x }, velocity: {}, mass: 1 }));
    const id = spawn(world, { spring: { a, b, length: 1, stiffness: Infinity } });
    step(world, 1 / 60);
    world.components.Spring.b[id] = c;
    step(world, 1 / 60);
    expect(world.components.Position.x[c] - world.components.Position.x[a]).toBeCloseTo(1, 12);
    expect(world.components.Position.x[b]).toBe(1);
  });

  test.each(['f32', 'f64'] as const)('two runs are identical, in %s', (precision) => {
    const run = () => {
      const world = constrainedWorld({ precision, dimensions: 3, forces: [uniformGravity(), springs()] });
      createCloth(world, {
        corner: {},
        columns: 8,
        rows: 7,
        spacing: 0.1,
        mass: 1,
        down: { z: 1 },
        shear: 1e3,
        bend: 10,
      });
      for (let s = 0; s < 60; s++) step(world, 1 / 60);
      return stateHash(world);
    };
    expect(run()).toBe(run());
  });

  test('options are checked', () => {
    expect(() => xpbd({ substeps: 0 })).toThrow(/E_RANGE/);
    expect(() => xpbd({ iteration: 3 } as never)).toThrow(/E_UNKNOWN/);
  });
});

describe('breaking', () => {
  test.each([
    ['constraints', xpbd()],
    ['forces', velocityVerlet],
  ] as const)('a rope breaks at the highest tension, as %s', (_, integrator) => {
    const world = constrainedWorld({ integrator, forces: [uniformGravity({ y: -10 }), linearDrag(), springs()] });
    world.phases.finish.push(breakSprings);
    // Ten links below the pin carry from 10 N up to 100 N; only the uppermost exceeds 95 N.
    const rope = createRope(world, {
      from: {},
      to: { y: -10 },
      nodes: 11,
      mass: 11,
      stiffness: 5000,
      breakForce: 95,
      damping: 50,
      components: { linearDrag: 5 },
    });
    for (let s = 0; s < 400; s++) step(world, 1 / 400);
    expect(brokenSprings(world).total).toBe(1);
    expect(world.components.Spring.a[rope.springs[0]]).toBe(0);
    expect(world.components.Spring.a[rope.springs[1]]).toBe(rope.nodes[1]);
    expect(world.components.Velocity.y[rope.nodes[10]]).toBeLessThan(-0.5);
  });
});
