// Compares bodies with an inertia tensor with the solutions of Euler's equations, and with what the scheme of
// kernels/rotation/rotate-rigidly.ts keeps. Source of the solutions: Landau and Lifshitz, Mechanics, §§ 35 to 37.
import { describe, expect, test } from 'vitest';
import {
  angularMomentum,
  applyImpulse,
  axial3,
  createPhysicsWorld,
  defineLaw,
  energy,
  type Force,
  restore,
  snapshot,
  spawn,
  stateHash,
  step,
} from '../index.ts';

interface Axes {
  x: number;
  y: number;
  z: number;
}

interface Spinning {
  readonly moments: Axes;
  readonly spin: Partial<Axes>;
  readonly forces?: readonly Force[];
  readonly precision?: 'f32' | 'f64';
}

function spinning({ moments, spin, forces = [], precision = 'f64' }: Spinning) {
  const world = createPhysicsWorld({ capacity: 3, dimensions: 3, forces, precision });
  const body = { position: {}, mass: 1, orientation: {}, inertiaTensor: moments, angularVelocity: spin };
  const eid = spawn(world, body);
  const { Orientation: q, AngularVelocity: w } = world.components;
  /** A vector of the body's frame in the world. */
  const rotated = ({ x, y, z }: Axes): Axes => {
    const [a, b, c, d] = [q.x[eid], q.y[eid], q.z[eid], q.w[eid]];
    const [tx, ty, tz] = [b * z - c * y + d * x, c * x - a * z + d * y, a * y - b * x + d * z];
    return { x: x + 2 * (b * tz - c * ty), y: y + 2 * (c * tx - a * tz), z: z + 2 * (a * ty - b * tx) };
  };
  const along = (axis: Axes) => {
    const { x, y, z } = rotated(axis);
    return x * w.x[eid] + y * w.y[eid] + z * w.z[eid];
  };
  return {
    world,
    eid,
    rotated,
    omega: (): Axes => ({ x: w.x[eid], y: w.y[eid], z: w.z[eid] }),
    /** Angular velocity in the body's axes. */
    spin: (): Axes => ({ x: along(X), y: along(Y), z: along(Z) }),
    run: (dt: number, steps: number) => {
      for (let i = 0; i < steps; i++) step(world, dt);
    },
  };
}

const X = { x: 1, y: 0, z: 0 };
const Y = { x: 0, y: 1, z: 0 };
const Z = { x: 0, y: 0, z: 1 };
/** A wing nut: the axis through its wings has the middle moment. */
const NUT = { moments: { x: 1, y: 2, z: 2.5 }, spin: { x: 0.01, y: 5, z: 0.01 } };

/** Times between changes of the sign of the spin about y, interpolated between two steps. */
function flipTimes(body: ReturnType<typeof spinning>, dt: number, count: number): number[] {
  const times: number[] = [];
  let before = body.spin().y;
  for (let t = dt; times.length < count; t += dt) {
    step(body.world, dt);
    const now = body.spin().y;
    if (before * now < 0) times.push(t - (dt * now) / (now - before));
    before = now;
  }
  return times;
}

/** Half the period of the spin about the middle axis, 2 K(k)/p, for L² > 2 E I₂. Landau and Lifshitz, (37.12). */
function flipPeriod({ x, y, z }: Axes, spin: Axes): number {
  const energy2 = x * spin.x ** 2 + y * spin.y ** 2 + z * spin.z ** 2;
  const momentum2 = (x * spin.x) ** 2 + (y * spin.y) ** 2 + (z * spin.z) ** 2;
  const rate = Math.sqrt(((z - y) * (momentum2 - energy2 * x)) / (x * y * z));
  const modulus = ((y - x) * (energy2 * z - momentum2)) / ((z - y) * (momentum2 - energy2 * x));
  // K(k) = π / 2 agM(1, √(1 - k²)).
  let [a, b] = [1, Math.sqrt(1 - modulus)];
  while (Math.abs(a - b) > 1e-15) [a, b] = [(a + b) / 2, Math.sqrt(a * b)];
  return Math.PI / a / rate;
}

/** Relative drift of energy and angular momentum over some flips at 60 steps a second. */
function drift(precision: 'f32' | 'f64', flips: number): number {
  const body = spinning({ ...NUT, precision });
  const [before, L] = [energy(body.world).kinetic, angularMomentum(body.world)];
  flipTimes(body, 1 / 60, flips);
  const { x, y, z } = angularMomentum(body.world);
  const turned = Math.hypot(x - L.x, y - L.y, z - L.z) / Math.hypot(L.x, L.y, L.z);
  return Math.max(Math.abs(energy(body.world).kinetic / before - 1), turned);
}

describe('a free body with three different moments', () => {
  test('keeps energy and angular momentum over 1 000 flips', { timeout: 60_000 }, () => {
    // 430 000 steps with some ten roundings of 2⁻⁵³ each, were all of one sign: 5e-10.
    expect(drift('f64', 1000)).toBeLessThan(1e-9);
  });

  test('keeps them in f32 as far as its columns can state them', { timeout: 60_000 }, () => {
    // 43 000 steps with ten roundings of 2⁻²⁴: 3e-2 if all were of one sign, 1e-4 for signs at random.
    expect(drift('f32', 100)).toBeLessThan(1e-4);
  });

  test('flips with the period of the elliptic integral', () => {
    const spin = { x: 0.3, y: 5, z: 0.8 };
    const exact = flipPeriod(NUT.moments, spin);
    const times = flipTimes(spinning({ ...NUT, spin }), 1 / 60, 41);
    // θ⁴/120 for half steps of θ = |L| h / I₁ = 10/120 at most, the fifth order of a rotation.
    expect(Math.abs((times[40] - times[0]) / 40 / exact - 1)).toBeLessThan((10 / 120) ** 4 / 120);
  });

  test('spins and is oriented to fourth order', () => {
    const after = (count: number) => {
      const body = spinning({ ...NUT, spin: { x: 0.5, y: 1, z: -0.5 } });
      body.run(1 / count, 4 * count);
      return [body.rotated({ x: 0.6, y: 0, z: 0.8 }), body.spin()];
    };
    const [a, b, c] = [20, 40, 80].map(after);
    const apart = (p: Axes, q: Axes) => Math.hypot(p.x - q.x, p.y - q.y, p.z - q.z);
    for (const i of [0, 1]) expect(Math.abs(apart(a[i], b[i]) / apart(b[i], c[i]) - 16)).toBeLessThan(1.6);
  });

  test('returns when it is stopped and sent back', () => {
    const body = spinning(NUT);
    body.run(1 / 60, 2000);
    const { x, y, z } = body.omega();
    const { AngularVelocity: w } = body.world.components;
    [w.x[body.eid], w.y[body.eid], w.z[body.eid]] = [-x, -y, -z];
    body.run(1 / 60, 2000);
    // Twice 2 000 steps of ten roundings, amplified by e^(p t) with p = 3.1/s at most while it is upright: 4 flips.
    expect(body.omega().y).toBeCloseTo(-5, 6);
    expect(body.rotated(X).x).toBeCloseTo(1, 6);
  });

  test('keeps its spin about the axes of the largest and the smallest moment', () => {
    for (const [axis, spin] of [
      ['x', { x: 5, y: 0.01, z: 0.01 }],
      ['z', { x: 0.01, y: 0.01, z: 5 }],
    ] as const) {
      const body = spinning({ ...NUT, spin });
      body.run(1 / 60, 6000);
      expect(body.spin()[axis]).toBeGreaterThan(4.999);
    }
  });

  test('keeps energy and angular momentum also where a step turns it several times', () => {
    const body = spinning({ moments: { x: 1, y: 2, z: 2.5 }, spin: { x: 20, y: 900, z: -400 } });
    const [before, L] = [energy(body.world).kinetic, angularMomentum(body.world)];
    body.run(1 / 60, 1000);
    expect(Math.abs(energy(body.world).kinetic / before - 1)).toBeLessThan(1e-9);
    expect(Math.abs(angularMomentum(body.world).y / L.y - 1)).toBeLessThan(1e-9);
  });
});

describe('a symmetric top', () => {
  const moments = { x: 2, y: 2, z: 3 };

  test('without torque precesses by Ω = (I₃ - I₁)/I₁ ω₃, in each half step by 2 atan(Ω h (1 + Ω² h²/12)/2)', () => {
    const [dt, steps, w3] = [1 / 60, 600, 1.5];
    const top = spinning({ moments, spin: { x: 0.4, z: w3 } });
    const rate = ((moments.z - moments.x) / moments.x) * w3;
    top.run(dt, steps);
    const { x, y, z } = top.spin();
    const each = (rate * dt) / 2;
    const angle = 2 * steps * 2 * Math.atan((each * (1 + each ** 2 / 12)) / 2);
    // Ten roundings in each of 1 200 half steps.
    expect(Math.abs(x - 0.4 * Math.cos(angle))).toBeLessThan(1e-11);
    expect(Math.abs(y - 0.4 * Math.sin(angle))).toBeLessThan(1e-11);
    expect(Math.abs(z - w3)).toBeLessThan(1e-11);
    expect(Math.abs(angle / (rate * steps * dt) - 1)).toBeLessThan(each ** 4 / 120 + 1e-12);
  });

  test('with equal moments turns as a body of one moment of inertia does', () => {
    const ball = spinning({ moments: { x: 3, y: 3, z: 3 }, spin: { x: 2, y: -3, z: 6 } });
    ball.run(1 / 64, 640);
    expect(Math.hypot(ball.omega().x - 2, ball.omega().y + 3, ball.omega().z - 6)).toBeLessThan(1e-12);
    // Half steps of θ = 7/128 rad: 2 atan(θ/2) lacks θ³/12, which a second rotation adds.
    const angle = 1280 * 2 * (Math.atan(7 / 256) + Math.atan((7 / 128) ** 3 / 24));
    expect(Math.abs(angle / 70 - 1)).toBeLessThan((7 / 128) ** 4 / 80);
    expect(ball.rotated({ x: 2 / 7, y: -3 / 7, z: 6 / 7 }).z).toBeCloseTo(6 / 7, 11);
    const across = { x: 3 / Math.sqrt(13), y: 2 / Math.sqrt(13), z: 0 };
    const { x, y } = ball.rotated(across);
    expect(x * across.x + y * across.y).toBeCloseTo(Math.cos(angle), 10);
  });
});

/** Weight on an arm along the body's z, about a pivot at the origin: the moments are those about the pivot. */
const weight = (newtonMetres: number) =>
  defineLaw({
    name: 'weight',
    // (R ẑ) × (-m g r ŷ)
    torque({ rotate, mass }) {
      const { x, z } = rotate(axial3(0, 0, 1));
      return axial3(z, 0, x.negate()).mul(mass.mul(newtonMetres));
    },
  })({});

describe('a heavy gyroscope', () => {
  const moments = { x: 2, y: 2, z: 3 };

  test('precesses steadily by m g r/(I₃ ω) when its axis is level', () => {
    const [load, w3, dt] = [6, 20, 1 / 240];
    const rate = load / (moments.z * w3);
    // In steady precession with a level axis the angular velocity is ω₃ along the axis and the rate upwards.
    const gyroscope = spinning({ moments, spin: { y: rate, z: w3 }, forces: [weight(load)] });
    gyroscope.run(dt, 240 * 10);
    const { x, y, z } = gyroscope.rotated(Z);
    // A torque in kicks makes the axis nutate by (ω₃ I₃/I₁ dt)²/24 = 6.5e-4 of rate/(ω₃ I₃/I₁) = 3.3e-3 rad, up and down.
    expect(Math.abs(Math.atan2(x, z) / (10 * rate) - 1)).toBeLessThan(4.4e-6);
    expect(Math.abs(y)).toBeLessThan(4.4e-6);
  });

  test('released from rest nutates and precesses on average by m g r/(I₃ ω), the faster the more exactly', () => {
    const error = (w3: number) => {
      const gyroscope = spinning({ moments, spin: { z: w3 }, forces: [weight(6)] });
      gyroscope.run(1 / 480, 480 * 8);
      const { x, z } = gyroscope.rotated(Z);
      return Math.abs(Math.atan2(x, z) / ((8 * 6) / (moments.z * w3)) - 1);
    };
    // The relative correction is m g r I₁/(I₃ ω)² = 12/3600 at 20 rad/s, and the last nutation 1/(8 · 30).
    expect(error(20)).toBeLessThan(8e-3);
    expect(error(40)).toBeLessThan(4e-3);
  });

  test('is integrated to second order, energy included', () => {
    const state = (count: number) => {
      const top = spinning({ moments: { x: 1.6, y: 2, z: 3 }, spin: { x: 0.5, z: 4 }, forces: [weight(6)] });
      const height = () => 6 * top.rotated(Z).y;
      const before = energy(top.world).kinetic + height();
      top.run(1 / count, 2 * count);
      return { axis: top.rotated(Z), energy: energy(top.world).kinetic + height() - before };
    };
    const [a, b, c] = [100, 200, 400].map(state);
    const apart = (p: Axes, q: Axes) => Math.hypot(p.x - q.x, p.y - q.y, p.z - q.z);
    expect(Math.abs(apart(a.axis, b.axis) / apart(b.axis, c.axis) - 4)).toBeLessThan(0.2);
    expect(Math.abs(a.energy / b.energy - 4)).toBeLessThan(0.2);
  });
});

describe('impulses and values', () => {
  test('an impulse at a point changes L by r × J, whatever the orientation', () => {
    const body = spinning(NUT);
    body.run(1 / 60, 100);
    const before = angularMomentum(body.world);
    applyImpulse(body.world, body.eid, { x: 3, y: -1, z: 2 }, { x: 0.5, y: 1, z: -1 });
    const after = angularMomentum(body.world);
    expect(after.x - before.x).toBeCloseTo(1, 12);
    expect(after.y - before.y).toBeCloseTo(-4, 12);
    expect(after.z - before.z).toBeCloseTo(-3.5, 12);
  });

  test('a snapshot brings a tumbling body back to the bit', () => {
    const body = spinning(NUT);
    body.run(1 / 60, 50);
    const saved = snapshot(body.world);
    body.run(1 / 60, 50);
    const first = stateHash(body.world);
    restore(body.world, saved);
    body.run(1 / 60, 50);
    expect(stateHash(body.world)).toBe(first);
  });

  test('moments that no body has are refused', () => {
    const make = (inertiaTensor: Partial<Axes>) => () => spinning({ moments: inertiaTensor as Axes, spin: {} });
    expect(make({ x: 1, y: 1, z: 2.01 })).toThrow(/exceeds the sum/);
    expect(make({ x: -1, y: 1, z: 1 })).toThrow(/inertiaTensor.x/);
    expect(make({ x: 0, y: 1, z: 1 })).toThrow(/inertiaTensor.x/);
    expect(make({ x: Number.NaN, y: 1, z: 1 })).toThrow(/inertiaTensor.x/);
    expect(make({ x: 1, y: 1, z: 2 })).not.toThrow();
    const flat = createPhysicsWorld({ capacity: 3 });
    expect(() => spawn(flat, { position: {}, inertiaTensor: { x: 1, y: 1, z: 1 } })).toThrow(/2D/);
  });

  test('a moment overwritten by NaN is reported, and the body keeps turning', () => {
    const body = spinning(NUT);
    body.world.components.InertiaTensor.y[body.eid] = Number.NaN;
    body.run(1 / 60, 64);
    expect(body.world.faults.faults[0]).toMatchObject({ code: 'E_NONFINITE', field: 'InertiaTensor.y' });
    // Its rotation no longer knows moments: ω stays what it was when the column was overwritten.
    expect(Math.hypot(body.omega().x - 0.01, body.omega().y - 5, body.omega().z - 0.01)).toBeLessThan(1e-13);
  });

  test('a body without Orientation is named in a warning', () => {
    const world = createPhysicsWorld({ capacity: 3, dimensions: 3 });
    const messages: string[] = [];
    world.onWarning = ({ message }) => messages.push(message);
    spawn(world, { position: {}, mass: 1, inertiaTensor: { x: 1, y: 1, z: 1 }, angularVelocity: { x: 1 } });
    step(world, 1 / 60);
    expect(messages.join()).toMatch(/InertiaTensor/);
  });
});
