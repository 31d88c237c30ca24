import {
  box,
  createJoint,
  distance,
  filterJoint,
  jointPosition,
  prismatic,
  revolute,
  spawn,
  uniformGravity,
  weld,
  wheel,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { rigidWorld, run } from '../../../../test/support/rigid-world.ts';

const collider = { shape: box(1, 0.2), density: 10 };

describe.each(['f32', 'f64'] as const)('the position of a joint in %s', (precision) => {
  it('is the angle of a hinge from where it was made, also after many turns', () => {
    const world = rigidWorld({ precision, forces: [] });
    const a = spawn(world, { position: {}, rotation: 0.5, collider });
    const b = spawn(world, {
      position: { x: 0.5 },
      rotation: 1.5,
      angularVelocity: 10,
      mass: 1,
      inertia: 0.1,
      collider,
    });
    const hinge = createJoint(world, revolute({ a, b, anchor: { x: 0.5 } }));
    expect(jointPosition(world, hinge)).toBeCloseTo(0, 6);
    run(world, 3);
    expect(jointPosition(world, hinge)).toBeCloseTo(world.components.Rotation.angle[b] - 1.5, 5);
    expect(jointPosition(world, hinge)).toBeGreaterThan(9 * Math.PI);
  });

  it('is where a limit stops it: a hinge, a slider of a turned body, and a rope', () => {
    const world = rigidWorld({ precision, forces: [uniformGravity({ y: -10 })] });
    const flap = spawn(world, { position: { x: 0.5 }, collider });
    const hinge = createJoint(world, revolute({ b: flap, anchor: {}, limits: { lower: -0.4, upper: 0.4 } }));
    const rail = spawn(world, { position: { x: 5 }, rotation: 0.3, collider: { shape: box(1, 0.2) } });
    const cart = spawn(world, { position: { x: 5 }, rotation: 0.3, collider });
    const axis = { x: -Math.sin(0.3), y: Math.cos(0.3) };
    const slider = createJoint(
      world,
      prismatic({ a: rail, b: cart, anchor: { x: 5 }, axis, limits: { lower: -0.7, upper: 0.7 } }),
    );
    const lamp = spawn(world, { position: { x: 9, y: -0.5 }, collider: { radius: 0.1, density: 10 } });
    const rope = createJoint(world, distance({ b: lamp, anchorA: { x: 9 }, limits: { upper: 2 } }));
    expect([hinge, slider, rope].map((id) => jointPosition(world, id))).toEqual([0, 0, 0.5]);
    run(world, 5);
    expect(jointPosition(world, hinge)).toBeCloseTo(-0.4, 3);
    expect(jointPosition(world, slider)).toBeCloseTo(-0.7, 3);
    expect(jointPosition(world, rope)).toBeCloseTo(2, 3);
  });

  it('is the travel of a suspension, and the angle of a weld', () => {
    const world = rigidWorld({ precision, forces: [uniformGravity({ y: -10 })] });
    const hub = spawn(world, { position: { y: -1 }, collider: { radius: 0.2, density: 100 } });
    const spring = { hertz: 2, dampingRatio: 1 };
    const suspension = createJoint(world, wheel({ b: hub, anchor: { y: -1 }, axis: { y: 1 }, spring }));
    const sign = spawn(world, { position: { x: 3 }, collider });
    const bracket = createJoint(world, weld({ b: sign, anchor: { x: 3 } }));
    run(world, 5);
    // It hangs g/ω² below where the spring is at rest.
    expect(jointPosition(world, suspension)).toBeCloseTo(-10 / (2 * Math.PI * 2) ** 2, 3);
    expect(jointPosition(world, bracket)).toBeCloseTo(0, 4);
  });
});

it('is refused for what is no joint, and for a joint without one direction', () => {
  const world = rigidWorld();
  const [a, b] = [0, 2].map((x) => spawn(world, { position: { x }, collider }));
  const filter = createJoint(world, filterJoint({ a, b }));
  expect(() => jointPosition(world, a)).toThrow(/E_STALE.*no joint 1/);
  expect(() => jointPosition(world, filter)).toThrow(
    /E_RANGE.*a filter joint.*revolute, distance, weld, prismatic, wheel\./s,
  );
});
