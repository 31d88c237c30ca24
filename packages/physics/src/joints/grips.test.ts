// What motors press between two light fingers stays there by friction.
import { box, createJoint, destroyWorld, type PhysicsWorld, prismatic, softStep, spawn } from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { rigidWorld, run } from '../../../../test/support/rigid-world.ts';

/** A box of 10 kg between two fingers of 2.4 kg that are pressed together with this force, N, on rails. */
function claw(world: PhysicsWorld, force: number) {
  const surface = { friction: 0.5 };
  const load = spawn(world, { position: {}, velocity: {}, collider: { shape: box(1, 1), density: 10, ...surface } });
  const finger = { shape: box(0.2, 1.2), density: 10, ...surface };
  const fingers = [-1, 1].map((side) => {
    const position = { x: side * 0.6, y: 0.15 };
    const body = spawn(world, { position, velocity: {}, collider: finger });
    createJoint(world, prismatic({ b: body, anchor: position, axis: { x: -side }, motor: { speed: 1, max: force } }));
    return body;
  });
  return { load, fingers };
}

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  // 2 μ N must exceed m g: 98 N do.
  test.each([130, 500, 2000, 5000])('a claw that presses with %i N lets nothing slip', (force) => {
    const world = rigidWorld({ precision, integrator: softStep({ sleepTime: 0 }) });
    const { load, fingers } = claw(world, force);
    run(world, 0.5);
    const { y } = world.components.Position;
    const [start, finger] = [y[load], y[fingers[0]]];
    run(world, 7);
    // Contacts have a slop of 5 mm, by which the load may settle between the fingers; it slipped by up to 0.5 m.
    expect(Math.abs(y[load] - start - (y[fingers[0]] - finger))).toBeLessThan(0.005);
    destroyWorld(world);
  });
});
