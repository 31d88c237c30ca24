// The springs of all joints have the damping that they are given and no more.
import {
  box,
  createJoint,
  destroyWorld,
  distance,
  type JointSpring,
  type PhysicsWorldOptions,
  prismatic,
  revolute,
  softStep,
  spawn,
  step,
  weld,
  wheel,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, rigidWorld } from '../../../../test/support/rigid-world.ts';

const START = 0.3;
const SECONDS = 5;

const joints = {
  distance: (b: number, spring: JointSpring) => distance({ b, anchorA: { y: -5 }, spring }),
  prismatic: (b: number, spring: JointSpring) => prismatic({ b, anchor: {}, axis: { y: 1 }, spring }),
  wheel: (b: number, spring: JointSpring) => wheel({ b, anchor: {}, axis: { y: 1 }, spring }),
  revolute: (b: number, spring: JointSpring) => revolute({ b, anchor: {}, spring }),
  weld: (b: number, spring: JointSpring) => weld({ b, anchor: {}, spring }),
};

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  /** Least and largest amplitude, √(x² + (v/ω)²), of the last second of five. */
  function amplitudes(kind: keyof typeof joints, hertz: number, dampingRatio = 0, options: PhysicsWorldOptions = {}) {
    const world = rigidWorld({ precision, forces: [], ...options });
    const body = spawn(world, { position: {}, collider: { shape: box(1, 1), density: 2 }, neverSleep: {} });
    createJoint(world, joints[kind](body, { hertz, dampingRatio }));
    const { Position, Velocity, Rotation, AngularVelocity } = world.components;
    const turns = kind === 'revolute' || kind === 'weld';
    const [place, speed] = turns ? [Rotation.angle, AngularVelocity.z] : [Position.y, Velocity.y];
    const omega = 2 * Math.PI * hertz;
    speed[body] = START * omega;
    let [least, most] = [Number.POSITIVE_INFINITY, 0];
    for (let i = 0; i < SECONDS / DT; i++) {
      step(world, DT);
      if (i * DT < SECONDS - 1) continue;
      const amplitude = Math.hypot(place[body], speed[body] / omega);
      [least, most] = [Math.min(least, amplitude), Math.max(most, amplitude)];
    }
    destroyWorld(world);
    return { least, most };
  }

  it.each([
    ['distance', 10],
    ['prismatic', 2],
    ['prismatic', 15],
    ['wheel', 15],
    ['revolute', 15],
    ['weld', 15],
  ] as const)('an undamped spring of a %s joint keeps its amplitude at %d Hz', (kind, hertz) => {
    const { least, most } = amplitudes(kind, hertz);
    // Semi-implicit Euler keeps x² ± hω x (v/ω) + (v/ω)².
    const tilt = (DT / 4) * Math.PI * hertz;
    expect(most).toBeLessThan((1.001 * START) / Math.sqrt(1 - tilt));
    expect(least).toBeGreaterThan((0.999 * START) / Math.sqrt(1 + tilt));
  });

  it.each(['prismatic', 'revolute'] as const)('nor does %s depend on how softly joints are held', (kind) => {
    const { most } = amplitudes(kind, 10, 0, { integrator: softStep({ jointHertz: 10, jointDampingRatio: 0.5 }) });
    expect(most).toBeLessThan((1.001 * START) / Math.sqrt(1 - (DT / 4) * Math.PI * 10));
  });

  it('a damped one loses exp(-ζ ω t)', () => {
    const { most } = amplitudes('prismatic', 10, 0.005);
    const left = START * Math.exp(-0.005 * 2 * Math.PI * 10 * (SECONDS - 1));
    const tilt = (DT / 4) * Math.PI * 10;
    expect(most).toBeLessThan((1.02 * left) / Math.sqrt(1 - tilt));
    expect(most).toBeGreaterThan((0.98 * left) / Math.sqrt(1 + tilt));
  });
});
