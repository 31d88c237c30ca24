import { describe, expect, test } from 'vitest';
import { read, run, single } from '../../../../test/support/laws.ts';
import {
  angularDrag,
  angularMomentum,
  applyImpulse,
  box,
  constantTorque,
  createPhysicsWorld,
  defineForce,
  explode,
  momentum,
  PhysicsError,
  rigidBodies,
  spawn,
  spawnCompound,
} from '../index.ts';

describe('impulses', () => {
  test('change the momentum by J, and the angular momentum by r × J', () => {
    const body = { mass: 4, inertia: 2, angularVelocity: {}, orientation: {} };
    const { world, eid } = single([], { position: { x: 1, y: 2, z: 3 }, ...body }, { dimensions: 3 });
    applyImpulse(world, eid, { x: 1, y: -2, z: 5 }, { x: 2, y: 2, z: 1 });
    expect(momentum(world)).toEqual({ x: 1, y: -2, z: 5 });
    const spin = world.components.AngularVelocity;
    const r = { x: 1, y: 0, z: -2 };
    expect(2 * spin.x[eid]).toBe(r.y * 5 - r.z * -2);
    expect(2 * spin.y[eid]).toBe(r.z * 1 - r.x * 5);
    expect(2 * spin.z[eid]).toBe(r.x * -2 - r.y * 1);
    const about = angularMomentum(world, { x: 2, y: 2, z: 1 });
    for (const axis of ['x', 'y', 'z'] as const) expect(about[axis]).toBeCloseTo(0, 12);
  });

  test('have no effect on a body without mass, and do not rotate a body that cannot rotate', () => {
    const world = createPhysicsWorld({ capacity: 5 });
    const fixed = spawn(world, { position: {}, velocity: {} });
    const straight = spawn(world, { position: {}, velocity: {}, mass: 1, inertia: 1 });
    applyImpulse(world, fixed, { x: 5 });
    applyImpulse(world, straight, { x: 5 }, { y: 1 });
    expect(read(world, fixed).speed()).toBe(0);
    expect(read(world, straight).speed()).toBe(5);
    expect(world.components.AngularVelocity.z[straight]).toBe(0);
    expect(() => applyImpulse(world, 4, {})).toThrow(/E_STALE/);
    expect(() => applyImpulse(world, straight, { x: Number.NaN })).toThrow(PhysicsError);
  });

  test('on a part act on its body, and turn it about the centre of mass of all', () => {
    const world = createPhysicsWorld({ preset: rigidBodies });
    const parts = [0, 1].map((x) => ({ shape: box(1, 1), x, density: 1 }));
    const { body, parts: ids } = spawnCompound(world, { parts });
    const { Velocity, AngularVelocity, Inertia } = world.components;
    applyImpulse(world, ids[1], { x: 4 });
    expect(Velocity.x[body]).toBe(2);
    expect(AngularVelocity.z[body]).toBe(0);
    applyImpulse(world, ids[1], { y: 4 }, { x: 1 });
    expect(Velocity.y[body]).toBe(2);
    // The centre is at x = 0.5.
    expect(AngularVelocity.z[body]).toBeCloseTo((0.5 * 4) / Inertia.value[body], 12);
  });

  test('and explosions leave kinematic bodies as they are', () => {
    const world = createPhysicsWorld({ preset: rigidBodies });
    const collider = { shape: box(2, 0.2), density: 100 };
    const lift = spawn(world, { position: { y: 1 }, velocity: { y: 0.5 }, kinematic: {}, collider });
    const plank = spawn(world, { position: { y: -1 }, collider });
    applyImpulse(world, lift, { x: 100 });
    explode(world, { impulse: 400, radius: 3 });
    const { Mass, Velocity } = world.components;
    expect([Velocity.x[lift], Velocity.y[lift]]).toEqual([0, 0.5]);
    expect(Velocity.y[plank]).toBeCloseTo((-400 * (1 - 1 / 3)) / Mass.value[plank], 12);
  });

  test('an explosion pushes outwards, less with distance, and has no effect beyond its radius', () => {
    const world = createPhysicsWorld({ capacity: 9, dimensions: 3 });
    const at = [0, 1, 2, 3.9, 4, 5].map((x) => spawn(world, { position: { x }, velocity: {}, mass: 2 }));
    explode(world, { impulse: 8, radius: 4 });
    const speeds = at.map((eid) => world.components.Velocity.x[eid]);
    [0, 3, 2, 0.1, 0, 0].forEach((v, i) => {
      expect(speeds[i]).toBeCloseTo(v, 12);
    });
    // (1 - d/R)^1.5 = 1/8 at d = 3 R/4.
    explode(world, { centre: { x: 1 }, impulse: 16, radius: 4, falloff: 1.5 });
    expect(world.components.Velocity.x[at[4]] - speeds[4]).toBeCloseTo(1, 12);
    explode(world, { centre: { y: 3 }, impulse: -2, radius: 100, falloff: 0 });
    expect(world.components.Velocity.y[at[0]]).toBeCloseTo(1, 12);
    expect(() => explode(world, { impulse: 1, radius: -1 })).toThrow(PhysicsError);
    for (const falloff of [-1, 17]) expect(() => explode(world, { impulse: 1, radius: 1, falloff })).toThrow('E_RANGE');
  });

  test('an explosion with a mask leaves out colliders on other layers', () => {
    const world = createPhysicsWorld({ preset: rigidBodies });
    const [debris, wall, point] = [{ radius: 0.1, layers: 2 }, { radius: 0.1, layers: 4 }, undefined].map(
      (collider, i) => spawn(world, { position: { x: 1 + i }, mass: 1, ...(collider && { collider }) }),
    );
    explode(world, { impulse: 3, radius: 10, falloff: 0, mask: 2 });
    expect([debris, wall, point].map((id) => world.components.Velocity.x[id])).toEqual([3, 0, 3]);
    expect(() => explode(world, { impulse: 1, radius: 1, mask: -1 })).toThrow(/explode\.mask/);
  });

  test('equal bodies around an explosion keep the momentum', () => {
    const world = createPhysicsWorld({ capacity: 50 });
    for (let i = 0; i < 12; i++) {
      const angle = (i * Math.PI) / 6;
      spawn(world, { position: { x: 3 * Math.cos(angle), y: 3 * Math.sin(angle) }, velocity: {}, mass: 1 });
    }
    explode(world, { impulse: 8, radius: 4 });
    expect(momentum(world).x).toBeCloseTo(0, 13);
    expect(momentum(world).y).toBeCloseTo(0, 13);
  });
});

describe('torque', () => {
  const spinner = { inertia: 5, rotation: {}, angularVelocity: {} };

  test('τ = I α, and L stays without torque', () => {
    const { world, eid } = single([constantTorque({ z: 1 })], spinner);
    run(world, 10);
    expect(world.components.AngularVelocity.z[eid]).toBeCloseTo(2, 12);
    world.forces.length = 0;
    const spin = angularMomentum(world).z;
    run(world, 10);
    expect(angularMomentum(world).z).toBe(spin);
  });

  test('drag on the turning ends at ω = τ/k, after e^(-kt/I)', () => {
    const { world, eid } = single([constantTorque({ z: 6 }), angularDrag()], { ...spinner, angularDrag: 2 });
    const omega = () => world.components.AngularVelocity.z[eid];
    run(world, 2.5, 1e-3);
    expect(omega()).toBeCloseTo(3 * (1 - Math.exp(-1)), 3);
    run(world, 100);
    expect(omega()).toBeCloseTo(3, 10);
  });

  test('about three axes in space', () => {
    const body = { inertia: 2, orientation: {}, angularVelocity: {} };
    const { world, eid } = single([constantTorque({ x: 2, y: 4, z: 6 })], body, { dimensions: 3 });
    run(world, 1);
    const { x, y, z } = world.components.AngularVelocity;
    expect([x[eid], y[eid], z[eid]].map((w) => Math.round(w * 1e9) / 1e9)).toEqual([1, 2, 3]);
  });

  test('a body without inertia, or without angular velocity, does not turn', () => {
    for (const body of [
      { angularVelocity: {}, rotation: {} },
      { inertia: 1, rotation: {} },
    ]) {
      const { world, eid } = single([constantTorque({ z: 1 })], body);
      run(world, 1);
      expect(world.components.Rotation.angle[eid]).toBe(0);
      expect(world.components.AngularVelocity.z[eid]).toBe(0);
    }
  });

  test('a force of your own may turn bodies: a torsion spring swings with 2π √(I/κ)', () => {
    const torsion = defineForce({
      name: 'torsion',
      appliesTorque: true,
      accumulate({ components, scratch }, first, last) {
        for (let eid = first; eid < last; eid++) scratch.torque.z[eid] -= 20 * components.Rotation.angle[eid];
      },
    });
    const { world, eid } = single([torsion], { ...spinner, rotation: 0.3 });
    run(world, Math.PI, 1e-3);
    expect(world.components.Rotation.angle[eid]).toBeCloseTo(0.3, 3);
  });
});
