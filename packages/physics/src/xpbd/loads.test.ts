// Rods and inextensible ropes under load: the tension that breaks them, and loads much heavier than a node.
import { describe, expect, test } from 'vitest';
import { spawn } from '../bodies/spawn.ts';
import { springs } from '../forces/springs.ts';
import { uniformGravity } from '../forces/uniform-gravity.ts';
import { createRope } from '../soft-bodies/rope.ts';
import { createPhysicsWorld } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import { breakSprings, brokenSprings } from './breaking.ts';
import { maxStrain } from './stretch.ts';
import { xpbd } from './xpbd.ts';

const world = (precision: 'f32' | 'f64', substeps: number, g: number) =>
  createPhysicsWorld({
    precision,
    capacity: 300,
    integrator: xpbd({ substeps }),
    forces: [uniformGravity({ y: -g }), springs()],
  });

describe('the tension of a rod', () => {
  /** Tells whether a pendulum of 1 kg and 1 m, g = 10 m/s², breaks within 1.5 s. */
  const pendulumBreaks = (breakForce: number, position: { x?: number; y?: number }, substeps: number) => {
    const w = world('f64', substeps, 10);
    w.phases.finish.push(breakSprings);
    const a = spawn(w, { position: {} });
    const b = spawn(w, { position, velocity: {}, mass: 1 });
    spawn(w, { spring: { a, b, length: 1, stiffness: Infinity, breakForce } });
    for (let s = 0; s < 90; s++) step(w, 1 / 60);
    return brokenSprings(w).total > 0;
  };

  test.each([1, 4, 16])('is m g at rest, with %i sub-steps', (substeps) => {
    expect(pendulumBreaks(10 * (1 - 1e-9), { y: -1 }, substeps)).toBe(true);
    expect(pendulumBreaks(10 * (1 + 1e-9), { y: -1 }, substeps)).toBe(false);
  });

  test('is 3 m g at the bottom of a swing from the level', () => {
    // The tension 3 m g cos(angle) is read once per step: at 4.5 rad/s within 0.037 rad of the bottom, so 0.07 % less.
    expect(pendulumBreaks(30 * (1 - 1e-3), { x: 1 }, 16)).toBe(true);
    // The mean over a sub-step is no more than the maximum, and the speed is exact to (4.5/960)² = 2e-5.
    expect(pendulumBreaks(30 * (1 + 5e-5), { x: 1 }, 16)).toBe(false);
  });

  test('is the weight of all that hangs below, in a rope', () => {
    const breaks = (breakForce: number) => {
      const w = world('f64', 16, 10);
      w.phases.finish.push(breakSprings);
      // The first of 21 nodes is a pin: 1 kg hangs.
      createRope(w, { from: {}, to: { y: -1 }, nodes: 21, mass: 1.05, breakForce });
      for (let s = 0; s < 30; s++) step(w, 1 / 60);
      return brokenSprings(w).total > 0;
    };
    expect(breaks(9.999)).toBe(true);
    expect(breaks(10.001)).toBe(false);
  });
});

describe('a rope of 1 g per node', () => {
  test.each([
    ['f64', 10, 4],
    ['f64', 200, 16],
    ['f64', 1000, 4],
    ['f64', 1e6, 4],
    ['f32', 1000, 4],
  ] as const)('in %s holds %d kg that swing down from the level, with %i sub-steps', (precision, mass, substeps) => {
    const w = world(precision, substeps, 9.81);
    const rope = createRope(w, { from: {}, to: { x: 5 }, nodes: 101, mass: 0.1 });
    const load = spawn(w, { position: { x: 5.1 }, velocity: {}, mass });
    spawn(w, { spring: { a: rope.nodes[100], b: load, length: 0.1, stiffness: Infinity } });
    let strain = 0;
    let fastest = 0;
    const { x, y } = w.components.Velocity;
    for (let s = 0; s < 120; s++) {
      step(w, 1 / 60);
      strain = Math.max(strain, maxStrain(w));
      fastest = Math.max(fastest, Math.sqrt(x[load] * x[load] + y[load] * y[load]));
    }
    // A solution is accepted when all lengths are within 1e-5 of their sum d + L, 2e-5 of L; positions of 5 m are
    // rounded to 2e-7 m in f32, 5e-6 of a link, at each end.
    expect(strain).toBeLessThan(precision === 'f64' ? 2.1e-5 : 3.1e-5);
    // At the bottom, v² = 2 g L. Backward Euler turns the rope by v h/L in a sub-step and loses half of that of the speed
    // per radian: 0.5 %. In f32 lengths are solved to 1e-5, which costs the speed another 0.5 %.
    const speed = Math.sqrt(2 * 9.81 * 5.1);
    expect(fastest).toBeLessThan(speed);
    expect(fastest).toBeGreaterThan(
      speed * (1 - (speed / 5.1 / (60 * substeps)) * (Math.PI / 4)) * (precision === 'f64' ? 1 : 0.995),
    );
  });

  test('holds a load of 1000 kg at its middle between two pins', () => {
    const w = world('f64', 4, 9.81);
    const rope = createRope(w, { from: {}, to: { x: 5 }, length: 5.5, nodes: 101, mass: 0.1, pins: 'both' });
    w.components.Mass.value[rope.nodes[50]] = 1000;
    for (let s = 0; s < 300; s++) step(w, 1 / 60);
    // Both halves are straight: 2.75² - 2.5² = 1.1456².
    expect(w.components.Position.y[rope.nodes[50]]).toBeCloseTo(-Math.sqrt(2.75 * 2.75 - 2.5 * 2.5), 6);
    expect(maxStrain(w)).toBeLessThan(2e-5);
  });
});

describe('a rope between pins twice as far apart as it is long', () => {
  const stretched = (breakForce: number) => {
    const w = world('f64', 4, 9.81);
    w.phases.finish.push(breakSprings);
    const { nodes } = createRope(w, {
      from: {},
      to: { x: 4 },
      length: 2,
      nodes: 11,
      mass: 1,
      pins: 'both',
      breakForce,
    });
    for (let s = 0; s < 60; s++) step(w, 1 / 60);
    return { w, nodes };
  };

  test('shares the strain', () => {
    const { w, nodes } = stretched(0);
    // Positions of 4 m are rounded to 4e-16 m, a link is 0.2 m long.
    for (const [i, node] of nodes.entries()) {
      expect(w.components.Position.x[node]).toBeCloseTo(0.4 * i, 13);
      expect(w.components.Position.y[node]).toBeCloseTo(0, 13);
    }
    expect(maxStrain(w)).toBeCloseTo(1, 12);
    expect(w.faults.faults).toEqual([]);
  });

  test('breaks at any force', () => {
    expect(brokenSprings(stretched(1e20).w).total).toBeGreaterThan(0);
  });
});

test.each(['f32', 'f64'] as const)(
  'a hub on eight ropes keeps their lengths with one iteration, in %s',
  (precision) => {
    const w = createPhysicsWorld({
      precision,
      capacity: 1000,
      integrator: xpbd({ substeps: 4, iterations: 1 }),
      forces: [uniformGravity(), springs()],
    });
    const hub = spawn(w, { position: {}, velocity: {}, mass: 5 });
    for (let k = 0; k < 8; k++) {
      const [x, y] = [Math.cos((k * Math.PI) / 4), Math.sin((k * Math.PI) / 4)];
      const ends = { from: { x: 3 * x, y: 3 * y }, to: { x: 0.1 * x, y: 0.1 * y } };
      const { nodes } = createRope(w, { ...ends, length: 3.2, nodes: 31, mass: 0.2 });
      // The spring that joins the hub follows those of its rope, so that all are solved together.
      spawn(w, { spring: { a: nodes[30], b: hub, length: 0.1, stiffness: Infinity } });
    }
    let strain = 0;
    for (let s = 0; s < 300; s++) {
      step(w, 1 / 60);
      if (s > 200) strain = Math.max(strain, maxStrain(w));
    }
    // Polylines are iterated until lengths are within 0.4 %.
    expect(strain).toBeLessThan(0.004);
  },
);
