// Networks of springs oscillate faster than each of their springs: ω² = 4k/m in a long chain, 2k/m in a pair.
import { describe, expect, test } from 'vitest';
import { spawn } from '../bodies/spawn.ts';
import { energy } from '../diagnostics/energy.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { rungeKutta4 } from '../integrators/runge-kutta-4.ts';
import { semiImplicitEuler } from '../integrators/semi-implicit-euler.ts';
import { velocityVerlet } from '../integrators/velocity-verlet.ts';
import { createCloth } from '../soft-bodies/cloth.ts';
import { createRope } from '../soft-bodies/rope.ts';
import { createSoftBody } from '../soft-bodies/soft-body.ts';
import { createPhysicsWorld, type PhysicsWorldOptions } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { springs } from './springs.ts';

function springWorld(options: PhysicsWorldOptions = {}) {
  const warnings: string[] = [];
  const onWarning: PhysicsWorldOptions['onWarning'] = ({ message, hint }) => warnings.push(`${message} ${hint}`);
  const world = createPhysicsWorld({ capacity: 2000, forces: [springs()], onWarning, ...options });
  return { world, warnings };
}

/** The error of a step, or nothing. */
function refusal(world: PhysicsWorld, dt: number): PhysicsError | undefined {
  try {
    step(world, dt);
  } catch (error) {
    if (error instanceof PhysicsError) return error;
    throw error;
  }
  return undefined;
}

/** The step, s, that a text recommends. */
const advised = (text = '') => Number(/at most ([\d.e-]+) s/.exec(text)?.[1]);

const NETWORKS: readonly [string, 2 | 3, (world: PhysicsWorld) => unknown][] = [
  ['a rope', 3, (world) => createRope(world, { from: {}, to: { x: 2 }, nodes: 20, mass: 1, stiffness: 5000 })],
  [
    'a cloth with shear',
    3,
    (world) =>
      createCloth(world, { corner: {}, columns: 12, rows: 12, spacing: 0.1, mass: 1, structural: 1000, shear: 500 }),
  ],
  ['a ring', 2, (world) => createSoftBody(world, { centre: {}, radius: 0.5, mass: 1, stiffness: 600, pressure: 0 })],
  ['a ball', 3, (world) => createSoftBody(world, { centre: {}, radius: 0.5, mass: 1, stiffness: 400, pressure: 0 })],
  [
    'a damped rope',
    2,
    (world) => createRope(world, { from: {}, to: { x: 2 }, nodes: 20, mass: 1, stiffness: 100, damping: 20 }),
  ],
];

describe.each(NETWORKS)('%s', (_, dimensions, make) => {
  test.each([velocityVerlet, semiImplicitEuler, rungeKutta4])(
    'takes the step that the refusal of a longer one names, and keeps its energy: $name',
    (integrator) => {
      const { world, warnings } = springWorld({ dimensions, integrator });
      make(world);
      const { x, y, z } = world.components.Position;
      for (let id = 1; id <= world.lastId; id++) {
        x[id] += 1e-6 * Math.sin(id * id);
        y[id] += 1e-6 * Math.cos(id * id);
        if (dimensions === 3) z[id] += 1e-6 * Math.cos(id);
      }
      const dt = advised(refusal(world, 0.1)?.hint);
      const start = energy(world).total;
      for (let i = 0; i < 500; i++) step(world, dt);
      // A scheme of second order lets the energy swing by 1/(1 - q²) at the part q of its limit: with two digits, by up to some
      // hundred times. Steps 5 % longer than the limit multiply it by e^600.
      expect(energy(world).total).toBeLessThan(1000 * start);
      expect(warnings).toEqual([]);
    },
  );
});

test('the stiffest spring is named, wherever it is in the list, with a step that suits all', () => {
  const { world } = springWorld();
  const ids = [100, 40_000, 900].map((stiffness, i) => {
    const [a, b] = [0, 1].map((x) => spawn(world, { position: { x, y: i }, velocity: {}, mass: 1 }));
    return spawn(world, { spring: { a, b, stiffness, length: 1 } });
  });
  const error = refusal(world, 0.1);
  expect(error?.entity).toBe(ids[1]);
  // 2/ω with ω² = 2k/m is 0.00707 s.
  expect(advised(error?.hint)).toBe(0.007);
});

/** A chain of bodies of 1 kg along x. */
function chain(world: PhysicsWorld, nodes: number, spring: { readonly stiffness?: number; readonly damping?: number }) {
  const bodies = Array.from({ length: nodes }, (_, x) => spawn(world, { position: { x }, velocity: {}, mass: 1 }));
  for (let i = 1; i < nodes; i++) {
    spawn(world, { spring: { stiffness: 0, ...spring, a: bodies[i - 1], b: bodies[i], length: 1 } });
  }
}

describe('a chain whose springs are slow enough each', () => {
  test.each([
    ['stiffness', { stiffness: 1 }, 1],
    ['damping', { damping: 1 }, 1 / 2],
  ] as const)('is warned of above the limit of its %s, and not below it', (_, spring, limit) => {
    // The limit of one spring is √2 and 2 times as long.
    for (const [part, count] of [
      [0.995, 0],
      [1.05, 1],
    ]) {
      const { world, warnings } = springWorld({ integrator: semiImplicitEuler });
      chain(world, 100, spring);
      step(world, part * limit);
      step(world, part * limit);
      expect(warnings).toHaveLength(count);
      if (count === 0) continue;
      expect(warnings[0]).toMatch(/^the springs around body \d+ are together too stiff or too strongly damped/);
      expect(advised(warnings[0])).toBeCloseTo(limit, 10);
    }
  });

  test('is not warned of where its strings are slack, nor where each node has its own spring', () => {
    const { world, warnings } = springWorld({ integrator: semiImplicitEuler });
    for (let i = 0; i < 50; i++) {
      const [a, b] = [0, 1].map((x) => spawn(world, { position: { x, y: i }, velocity: {}, mass: 1 }));
      spawn(world, { spring: { a, b, stiffness: 1, length: 1 } });
      const c = spawn(world, { position: { x: 2, y: i }, velocity: {}, mass: 1 });
      spawn(world, { spring: { a: b, b: c, stiffness: 1, length: 2, tensionOnly: 1 } });
    }
    step(world, 1.3);
    expect(warnings).toEqual([]);
  });
});
