// gaussRadau is explicit in all but name: its iteration converges only for short sub-steps under a stiff drag, of which
// a step may need more than it is allowed. It then says so, and must not lose the body.
import { describe, expect, test } from 'vitest';
import { spawn } from '../bodies/spawn.ts';
import { linearDrag } from '../forces/drag.ts';
import { uniformGravity } from '../forces/uniform-gravity.ts';
import { createPhysicsWorld } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import { gaussRadau } from './gauss-radau.ts';

const G = 9.81;

/** A body of 1 kg, thrown at 5 m/s into a fluid of linear drag `drag`, kg/s, whose name is not 1. */
function thrown(drag: number, precision: 'f32' | 'f64') {
  // Few evaluations, so that no step of these is resolved.
  const integrator = gaussRadau({ maxEvaluations: 2000 });
  const forces = [linearDrag(), uniformGravity({ y: -G })];
  const world = createPhysicsWorld({ capacity: 8, precision, integrator, forces });
  spawn(world, { position: {} });
  const body = spawn(world, { position: { y: 100 }, velocity: { x: 5 }, mass: 1, linearDrag: drag });
  return { world, body };
}

describe('a body under a drag that is stiff for gaussRadau', () => {
  test.each([
    ['f64', 1e4, 1 / 60],
    ['f64', 1e4, 0.1],
    ['f64', 1e8, 0.1],
    ['f32', 1e4, 0.1],
  ] as const)('sinks at its terminal speed, in %s, k = %d, steps of %d s', (precision, drag, dt) => {
    const { world, body } = thrown(drag, precision);
    const { Position, Velocity } = world.components;
    for (let s = 0; s < 10; s++) step(world, dt);
    const speed = G / drag;
    expect(Velocity.y[body] / -speed).toBeCloseTo(1, 5);
    expect(Math.abs(Velocity.x[body])).toBeLessThan(1e-6);
    // Fallen by v t; a sub-step of first order is wrong by its length at the start, and f32 rounds 100 m by 4 µm.
    const tolerance = (speed * dt) / 10 + (precision === 'f32' ? 1e-4 : 1e-9);
    expect(Math.abs(Position.y[body] - 100 + speed * world.time)).toBeLessThan(tolerance);
    // Carried on by v/k, or up to a sub-step.
    expect(Math.abs(Position.x[body])).toBeLessThan(5 * (1 / drag + dt / 100));
  });

  test('gets an E_STEP that names it, and no other fault', () => {
    const { world, body } = thrown(1e4, 'f64');
    for (let s = 0; s < 5; s++) step(world, 0.1);
    expect(world.faults.faults.length).toBeGreaterThan(0);
    for (const fault of world.faults.faults) expect(fault).toMatchObject({ code: 'E_STEP', entity: body });
  });
});
