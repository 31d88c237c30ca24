// Columns of a joint that are changed while the world runs, and what is read of joints that are new or have nothing to hold.
import {
  box,
  circle,
  createJoint,
  despawn,
  distance,
  endedJoints,
  gear,
  isAsleep,
  jointForce,
  jointTorque,
  prismatic,
  revolute,
  spawn,
  step,
  weld,
} from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { DT, disc, G, rigidWorld, run } from '../../../../test/support/rigid-world.ts';

const FILTER = 8;

describe('limits of what has no free coordinate', () => {
  test('a gear turns on', () => {
    const world = rigidWorld();
    const wheel = (x: number, angularVelocity: number) => {
      const body = spawn(world, { position: { x }, angularVelocity, collider: { shape: circle(0.5), density: 10 } });
      createJoint(world, revolute({ b: body, anchor: { x } }));
      return body;
    };
    const [a, b] = [wheel(0, 1), wheel(2, 0)];
    const gears = createJoint(world, gear({ a, b, ratio: -1 }));
    run(world, 0.5);
    world.components.Joint.hasLimits[gears] = 1;
    run(world, 0.5);
    expect(world.components.AngularVelocity.z[a]).toBeCloseTo(0.5, 5);
    expect(world.components.AngularVelocity.z[b]).toBeCloseTo(-0.5, 5);
  });

  test('a rack on a slope slides on', () => {
    const world = rigidWorld({ precision: 'f64' });
    const b = spawn(world, { position: {}, collider: { shape: circle(0.5), density: 8, mask: 0 } });
    const a = spawn(world, { position: { x: 2 }, collider: { shape: circle(0.4), density: 5, mask: 0 } });
    createJoint(world, revolute({ b: a, anchor: { x: 2 } }));
    createJoint(world, prismatic({ b, anchor: {}, axis: { x: 0.6, y: -0.8 } }));
    const gears = createJoint(world, gear({ a, b, ratio: 0.4, axis: { x: 0.6, y: -0.8 } }));
    world.components.Joint.hasLimits[gears] = 1;
    run(world, 1);
    // The wheel adds I/r² = m_a/2 to the mass: r = 0.4 m is its radius, too.
    const { Mass, Velocity } = world.components;
    const speed = (0.8 * G * Mass.value[b]) / (Mass.value[b] + Mass.value[a] / 2);
    expect(Math.hypot(Velocity.x[b], Velocity.y[b]) / speed).toBeCloseTo(1, 3);
  });
});

describe('a joint that is changed', () => {
  /** A plank that sleeps, welded to a static post. */
  function sleeping() {
    const world = rigidWorld();
    const post = spawn(world, { position: { y: 1 }, collider: { shape: box(0.2, 0.2) } });
    const far = spawn(world, { position: { x: 5, y: 5 }, collider: { shape: box(0.2, 0.2) } });
    const plank = spawn(world, { position: { x: 1, y: 1 }, collider: { shape: box(2, 0.1), density: 10 } });
    const joint = createJoint(world, weld({ a: post, b: plank, anchor: { y: 1 } }));
    run(world, 3);
    expect(isAsleep(world, plank)).toBe(true);
    return { world, joint, plank, far };
  }

  test('wakes what it no longer holds', () => {
    for (const change of ['kind', 'b'] as const) {
      const { world, joint, plank, far } = sleeping();
      world.components.Joint[change][joint] = change === 'kind' ? FILTER : far;
      run(world, 0.5);
      expect(world.components.Position.y[plank], change).toBeLessThan(0);
    }
  });

  test('is of its new kind at once', () => {
    const world = rigidWorld();
    const b = spawn(world, { position: {}, collider: { shape: circle(0.5), density: 10 }, neverSleep: {} });
    const joint = createJoint(world, weld({ b, anchor: {} }));
    run(world, 0.5);
    world.components.Joint.kind[joint] = 3;
    world.components.Joint.axis[joint] = -Math.PI / 2;
    run(world, 0.5);
    expect(world.components.Velocity.y[b]).toBeCloseTo(-0.5 * G, 1);
  });

  test('keeps its new bodies from colliding, and no longer the old ones', () => {
    const world = rigidWorld({ forces: [] });
    // A body that stands for one that was there before.
    despawn(world, disc(world, { x: 50 }));
    const [a, b, c] = [disc(world, {}), disc(world, { x: 3 }), disc(world, { x: -3 })];
    const rope = createJoint(world, distance({ a, b, limits: { upper: 20 } }));
    run(world, 0.1);
    world.components.Joint.b[rope] = c;
    run(world, 0.1);
    expect(endedJoints(world).removed).toEqual([]);
    const { Position, Velocity } = world.components;
    Velocity.x[b] = -2;
    Velocity.x[c] = 2;
    run(world, 1.5);
    // a has taken the speed of b; c has come through it, and struck b.
    expect(Velocity.x[a]).toBeLessThan(-1.9);
    expect(Position.x[c]).toBeGreaterThan(Position.x[a]);
  });
});

describe('the force and the torque of a joint', () => {
  test('are 0 before its first step, whatever had its id', () => {
    const world = rigidWorld();
    const b = spawn(world, { position: { x: 1 }, collider: { shape: box(1, 1), density: 100 } });
    const old = createJoint(world, weld({ b, anchor: {} }));
    run(world, 0.2);
    expect(jointTorque(world, old)).toBeGreaterThan(50 * G);
    despawn(world, old);
    const next = createJoint(world, distance({ b, anchorA: { x: 1, y: 3 } }));
    expect(next).toBe(old);
    expect([jointForce(world, next), jointTorque(world, next)]).toEqual([0, 0]);
  });

  test('are 0 when nothing is left to hold, and stay as they were in sleep', () => {
    const world = rigidWorld();
    const b = spawn(world, { position: {}, collider: { shape: box(1, 1), density: 100 } });
    const rod = createJoint(world, distance({ b, anchorA: { y: 2 } }));
    run(world, 3);
    expect(isAsleep(world, b)).toBe(true);
    expect(jointForce(world, rod) / (100 * G)).toBeCloseTo(1, 3);
    world.components.Mass.value[b] = 0;
    step(world, DT);
    expect([jointForce(world, rod), jointTorque(world, rod)]).toEqual([0, 0]);
  });
});
