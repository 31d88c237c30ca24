// Winches that reel in what swings.
import { createJoint, distance, endedJoints, jointForce, softStep, spawn, step } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, G, rigidWorld } from '../../../../test/support/rigid-world.ts';

const MASS = 28;
const LENGTH = 5;
const ACROSS = 3;

interface Winch {
  readonly substeps?: number;
  readonly speed?: number;
  readonly max?: number;
  readonly breakForce?: number;
  readonly gravity?: boolean;
}

/** A body in an oblique direction from its winch, which crosses the rope at 3 m/s and already comes in at the speed of the motor. */
function swinging(
  precision: 'f32' | 'f64',
  { substeps = 4, speed = -3, max = 1e6, breakForce, gravity = false }: Winch,
) {
  const integrator = softStep({ substeps });
  const world = rigidWorld({ precision, integrator, ...(gravity ? {} : { forces: [] }) });
  const [x, y] = [0.6, -0.8];
  const body = spawn(world, {
    position: { x: LENGTH * x, y: LENGTH * y },
    velocity: { x: speed * x - ACROSS * y, y: speed * y + ACROSS * x },
    mass: MASS,
    inertia: 1,
    collider: { radius: 0.3 },
  });
  const motor = { speed, max };
  const joint = createJoint(world, distance({ b: body, anchorA: {}, motor, ...(breakForce ? { breakForce } : {}) }));
  const { Position, Velocity } = world.components;
  const state = () => {
    const [px, py, vx, vy] = [Position.x[body], Position.y[body], Velocity.x[body], Velocity.y[body]];
    const length = Math.hypot(px, py);
    return { length, in: (px * vx + py * vy) / length, across: (px * vy - py * vx) / length, up: -py / length, vx, vy };
  };
  return { world, joint, state };
}

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  it.each([
    { speed: -3, substeps: 4 },
    { speed: -3, substeps: 16 },
    { speed: -1, substeps: 4 },
    { speed: 1, substeps: 4 },
  ])('a winch at $speed m/s with $substeps sub-steps exerts what keeps its body on its path', (options) => {
    const { world, joint, state } = swinging(precision, { ...options, gravity: true });
    // The body begins along an arc, and goes on along its chords.
    step(world, DT);
    for (let i = 0; i < 50; i++) {
      const before = state();
      step(world, DT);
      const forces = [before, state()].map(
        ({ across, length, up }) => (MASS * across * across) / length + MASS * G * up,
      );
      // It is the largest of the sub-steps, and lies between those before and after them.
      expect(jointForce(world, joint)).toBeGreaterThan(0.99 * Math.min(...forces));
      expect(jointForce(world, joint)).toBeLessThan(1.01 * Math.max(...forces));
    }
  });

  it('gives what it pulls in the energy of its force along its speed', () => {
    // With one sub-step in each step the largest force is the only one.
    const { world, joint, state } = swinging(precision, { substeps: 1 });
    const h = DT / 4;
    const energy = ({ vx, vy }: { vx: number; vy: number }) => 0.5 * MASS * (vx * vx + vy * vy);
    const before = energy(state());
    let work = 0;
    for (let i = 0; i < 240; i++) {
      step(world, h);
      work += 3 * jointForce(world, joint) * h;
    }
    // It pulls along the rope as it was when the sub-step began.
    expect(Math.abs(work / (energy(state()) - before) - 1)).toBeLessThan(0.005);
  });

  it('has no more than its largest force, and reaches its speed with that', () => {
    const max = 600;
    const { world, joint, state } = swinging(precision, { speed: 0, max });
    world.components.Joint.motorSpeed[joint] = -3;
    let [length, radial] = [LENGTH, 0];
    const momentum = LENGTH * ACROSS;
    const parts = 100;
    for (let i = 0; i < 60; i++) {
      const before = state();
      step(world, DT);
      const after = state();
      expect(jointForce(world, joint)).toBeLessThan(max * (1 + 1e-5));
      expect(MASS * Math.hypot(after.vx - before.vx, after.vy - before.vy)).toBeLessThan(max * DT * (1 + 1e-4));
      for (let part = 0; part < parts; part++) {
        const pull = momentum ** 2 / length ** 3 - max / MASS;
        radial = Math.max(-3, radial + (pull * DT) / parts);
        length += (radial * DT) / parts;
      }
    }
    // What a sub-step adds to the speed acts one half of it too early.
    expect(Math.abs(state().length - length)).toBeLessThan(3 * (DT / 8) * 1.5);
  });

  it('holds as long as its rope bears', () => {
    // At last 28 kg · (3 m/s · 5/2.5)² / 2.5 m = 403 N.
    const { world } = swinging(precision, { breakForce: 500 });
    for (let i = 0; i < 50; i++) {
      step(world, DT);
      expect(endedJoints(world).broken).toHaveLength(0);
    }
  });
});
