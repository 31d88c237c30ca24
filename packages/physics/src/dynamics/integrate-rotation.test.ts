// Compares rotating bodies with closed forms and with the error terms of the scheme of kernels/integrators/spin.ts.
// Every body has equal moments of inertia about all axes, so ω is constant without torque and there is no nutation.
import { describe, expect, test } from 'vitest';
import {
  angularMomentum,
  axial3,
  constantTorque,
  createPhysicsWorld,
  defineForce,
  defineLaw,
  energy,
  type Force,
  spawn,
  step,
} from '../index.ts';

type Turning = { readonly angularVelocity: { x?: number; y?: number; z?: number }; readonly inertia?: number };

/** Creates a body of 3 kg m² that rotates under given torques. */
function turning(dimensions: 2 | 3, body: Turning, forces: readonly Force[] = []) {
  const world = createPhysicsWorld({ capacity: 3, dimensions, forces });
  const pose = dimensions === 2 ? { rotation: {} } : { orientation: {} };
  const eid = spawn(world, { position: {}, velocity: {}, mass: 1, inertia: 3, ...pose, ...body });
  const { AngularVelocity: w, Orientation: q, Rotation } = world.components;
  return {
    world,
    eid,
    spin: () => ({ x: w.x[eid], y: w.y[eid], z: w.z[eid] }),
    quaternion: () => [q.w[eid], q.x[eid], q.y[eid], q.z[eid]],
    angle: () => Rotation.angle[eid],
    run: (dt: number, steps: number) => {
      for (let i = 0; i < steps; i++) step(world, dt);
    },
  };
}

/** The quaternion (w, x, y, z) of a rotation by an angle about a unit axis. */
const turnBy = (angle: number, axis: readonly number[]) => [
  Math.cos(angle / 2),
  ...axis.map((part) => part * Math.sin(angle / 2)),
];

/** Angle between two orientations, rad. */
function apart(a: readonly number[], b: readonly number[]): number {
  const difference = Math.hypot(...a.map((part, i) => part - b[i]));
  return 4 * Math.asin(Math.min(1, difference / 2));
}

/** The unit axis (2, -3, 6) / 7. */
const AXIS = [2 / 7, -3 / 7, 6 / 7];

describe('in the plane', () => {
  test('a constant spin is exact', () => {
    const body = turning(2, { angularVelocity: { z: 0.375 } });
    body.run(1 / 64, 1000);
    // All values are binary fractions, so nothing rounds.
    expect(body.spin().z).toBe(0.375);
    expect(body.angle()).toBe((0.375 * 1000) / 64);
  });

  test('a constant torque: ω = τ t/I exact, θ = τ t (t + dt)/2I, as the scheme is first order', () => {
    const body = turning(2, { angularVelocity: {} }, [constantTorque({ z: 1.5 })]);
    body.run(1 / 64, 640);
    expect(body.spin().z).toBe(5);
    expect(body.angle()).toBe((0.5 * 10 * (10 + 1 / 64)) / 2);
  });

  test('a torque that is added or taken out in the middle of a step acts from the next step on', () => {
    const body = turning(2, { angularVelocity: {} });
    const { world } = body;
    const inStep = (act: () => void) => {
      world.phases.input[0] = act;
      body.run(1 / 64, 1);
      world.phases.input[0] = () => {};
      return body.spin().z;
    };
    const kernel = (z: number) =>
      defineForce({
        name: 'torque',
        equation: 'τ',
        reads: [],
        local: true,
        appliesTorque: true,
        accumulate: ({ scratch }, first, last) => {
          for (let row = first; row < last; row++) scratch.torque.z[row] += z;
        },
      });
    for (const torque of [(z: number) => constantTorque({ z }), kernel]) {
      // 192 N m turn 3 kg m² by 1 rad/s more in each step.
      const start = inStep(() => world.forces.push(torque(192)));
      body.run(1 / 64, 1);
      expect(body.spin().z).toBe(start + 1);
      expect(inStep(() => world.forces.pop())).toBe(start + 2);
      body.run(1 / 64, 1);
      expect(inStep(() => world.forces.push(torque(0)))).toBe(start + 2);
      world.forces.length = 0;
    }
    expect(body.spin().z).toBe(4);
  });

  test('a body without inertia ignores torque and keeps its spin', () => {
    const body = turning(2, { angularVelocity: { z: 2 }, inertia: 0 }, [constantTorque({ z: 1 })]);
    body.run(1 / 64, 64);
    expect([body.spin().z, body.angle()]).toEqual([2, 2]);
  });
});

describe('in space, without a torque', () => {
  const [ω, dt, steps] = [7, 1 / 64, 640];
  const free = () => turning(3, { angularVelocity: { x: 2, y: -3, z: 6 } });

  test('angular momentum I ω and energy I ω²/2 are conserved bitwise', () => {
    const body = free();
    body.run(dt, steps);
    expect(body.spin()).toEqual({ x: 2, y: -3, z: 6 });
    expect(angularMomentum(body.world)).toEqual({ x: 6, y: -9, z: 18 });
    expect(energy(body.world).kinetic).toBe((3 * ω ** 2) / 2);
  });

  test.each([0.01, 1, 7, 100, 1000])('a constant spin of %s rad/s turns by ω t exactly', (speed) => {
    const [x, y, z] = AXIS.map((part) => speed * part);
    const body = turning(3, { angularVelocity: { x, y, z } });
    body.run(dt, steps);
    const wanted = turnBy(speed * steps * dt, AXIS);
    // About ten roundings of 2⁻⁵³ in each of 640 steps give 7e-13; doubling the angle of a step multiplies them by it.
    const rounding = 1e-12 * Math.max(1, 4 * speed * dt);
    body.quaternion().forEach((part, i) => {
      expect(Math.abs(part - wanted[i])).toBeLessThan(rounding);
    });
  });

  test('the quaternion keeps unit length', () => {
    const body = free();
    // The quaternion is normalised in every step, with three roundings.
    body.run(0.5, 10_000);
    expect(Math.abs(Math.hypot(...body.quaternion()) - 1)).toBeLessThan(4 * 2 ** -53);
  });
});

describe('in space, under a torque', () => {
  /**
   * τ = Ω ẑ × L, as for a magnetic moment along the spin in a field along z: L precesses about z at Ω (Larmor 1897).
   */
  const field = (Ω: number) =>
    defineLaw({
      name: 'larmor',
      torque: ({ angularVelocity: { x, y } }) => axial3(y.mul(-3 * Ω), x.mul(3 * Ω), 0),
    })({});

  test('each step of a precession rotates L by atan(Ω dt) and scales it by √(1 + Ω² dt²)', () => {
    const [Ω, dt, steps] = [2, 1 / 64, 320];
    const body = turning(3, { angularVelocity: { x: 4, z: 1 } }, [field(Ω)]);
    body.run(dt, steps);
    const { x, y, z } = body.spin();
    const size = 4 * (1 + (Ω * dt) ** 2) ** (steps / 2);
    const angle = steps * Math.atan(Ω * dt);
    // Four roundings of 2⁻⁵³ in each of 320 steps, of magnitude 4.7, give 7e-13.
    expect(Math.abs(x - size * Math.cos(angle))).toBeLessThan(1e-12);
    expect(Math.abs(y - size * Math.sin(angle))).toBeLessThan(1e-12);
    expect(z).toBe(1);
  });

  test('so the precession of 2 rad/s is accurate to first order', () => {
    const error = (count: number) => {
      const body = turning(3, { angularVelocity: { x: 4, z: 1 } }, [field(2)]);
      body.run(1 / count, count);
      return Math.hypot(body.spin().x - 4 * Math.cos(2), body.spin().y - 4 * Math.sin(2));
    };
    // The length errs by the factor Ω² dt t/2, the angle by Ω³ dt² t/3 only. The next terms are smaller by about Ω dt.
    for (const count of [256, 512, 1024]) {
      expect(Math.abs(error(count) / ((4 * 4) / 2 / count) - 1)).toBeLessThan(2 / count);
      expect(Math.abs(Math.log2(error(count) / error(2 * count)) - 1)).toBeLessThan(4 / count);
    }
  });

  test('a constant torque about a slanted axis: ω = τ t/I, and the orientation to the first order', () => {
    const error = (count: number) => {
      const [x, y, z] = AXIS.map((part) => 3 * part);
      const body = turning(3, { angularVelocity: {} }, [constantTorque({ x, y, z })]);
      body.run(1 / count, count);
      const { x: wx, y: wy, z: wz } = body.spin();
      // One rounding per step.
      expect(Math.abs(Math.hypot(wx, wy, wz) - 1)).toBeLessThan(count * 2 ** -53);
      return apart(body.quaternion(), turnBy(0.5, AXIS));
    };
    // θ = t (t + dt)/2: it leads by dt/2, less ω³ dt²/12 per second.
    for (const count of [64, 128, 256]) expect(Math.abs(error(count) / (0.5 / count) - 1)).toBeLessThan(0.1 / count);
  });
});
