// Tests values that a law may use in every evaluation mode: sums in the stages of a scheme, and the length of the step.
import { describe, expect, test } from 'vitest';
import { read, run } from '../../../../test/support/laws.ts';
import { spawn } from '../bodies/spawn.ts';
import { rungeKutta4 } from '../integrators/runge-kutta-4.ts';
import { semiImplicitEuler } from '../integrators/semi-implicit-euler.ts';
import { vec3 } from '../laws/expression.ts';
import { defineForce } from '../laws/force.ts';
import { table } from '../laws/table.ts';
import { allocate } from '../memory/arena.ts';
import { resource } from '../memory/resource.ts';
import { createPhysicsWorld, type PhysicsWorldOptions } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import type { Integrator } from '../world/types.ts';
import { defineLaw } from './define-law.ts';

/** A body at x = 3 under some forces. */
function moving(options: PhysicsWorldOptions) {
  const world = createPhysicsWorld({ capacity: 4, ...options });
  return { world, ...read(world, spawn(world, { position: { x: 3 }, velocity: { y: 1 }, mass: 2 })) };
}

describe('a sum over a table', () => {
  const rowsAt = resource((world) => {
    const at = allocate(world.internal.arena, 32, 'rows');
    new Float64Array(world.memory.buffer, at, 4).set([0, -1, 2, -3]);
    return { at, count: 2 };
  });
  const summed = defineLaw({
    name: 'springs to a table',
    parameters: { rows: table(['x', 'k'], rowsAt) },
    acceleration: ({ position }, { rows }) => rows.sum(({ x, k }) => position.sub(vec3(x, 0)).mul(k)),
  });
  const written = defineLaw({
    name: 'two springs',
    acceleration: ({ position }) => position.mul(-1).add(position.sub(vec3(2, 0)).mul(-3)),
  });

  test('is evaluated separately in each stage of a scheme', () => {
    const [a, b] = [summed(), written()].map((law) => moving({ forces: [law], integrator: rungeKutta4 }));
    run(a.world, 1, 0.01);
    run(b.world, 1, 0.01);
    expect(a.at()).toEqual(b.at());
    expect(a.at().x).not.toBe(3);
  });
});

describe('the length of the step', () => {
  const law = defineLaw({ name: 'by dt', acceleration: ({ dt }) => vec3(dt, 0) });

  test('is available to a law beside a custom force, and to a custom integrator', () => {
    const nothing = defineForce({ name: 'nothing', accumulate: () => {} });
    const byHand: Integrator = {
      name: 'by hand',
      order: 1,
      symplectic: false,
      evaluations: 1,
      advance: (world, ranges, dt, evaluateForces) => {
        evaluateForces(world, ranges, world.time);
        world.components.Velocity.x[1] += (world.scratch.force.x[1] / 2) * dt;
      },
    };
    for (const forces of [[law()], [law(), nothing]]) {
      for (const integrator of [semiImplicitEuler, byHand]) {
        const { world, going } = moving({ forces, integrator });
        step(world, 0.5);
        expect(going().x).toBe(0.25);
      }
    }
  });
});
