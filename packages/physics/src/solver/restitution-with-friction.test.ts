// Newton's restitution and Coulomb's friction in one impact of a rod or a box with the ground, where each changes the speed of the other.
import {
  box,
  capsule,
  createPhysicsWorld,
  createRandom,
  energy,
  rigidBodies,
  type Shape,
  spawn,
  step,
} from '@principia/physics';
import { describe, expect, test } from 'vitest';

const DT = 1 / 60;
const APPROACH = 6;

interface Landing {
  readonly shape: Shape;
  readonly angle: number;
  readonly e: number;
  readonly mu: number;
  readonly slide: number;
  /** The lowest point of the body from its centre. */
  readonly arm: { readonly x: number; readonly y: number };
}

/** Lets a body land on its lowest point, and returns how that leaves the ground. */
function land(precision: 'f32' | 'f64', { shape, angle, e, mu, slide, arm }: Landing) {
  const world = createPhysicsWorld({ preset: rigidBodies, precision, capacity: 10 });
  spawn(world, { position: { y: -0.5 }, collider: { shape: box(400, 1), friction: mu } });
  const body = spawn(world, {
    position: { y: 2 },
    rotation: angle,
    velocity: { x: slide, y: -APPROACH },
    collider: { shape, density: 100, friction: mu, restitution: e },
  });
  const { Velocity: v, AngularVelocity: w, Mass } = world.components;
  const before = energy(world).kinetic;
  for (let i = 0; i < 60 && w.z[body] === 0; i++) step(world, DT);
  const slip = v.x[body] - w.z[body] * arm.y;
  const separation = (v.y[body] + w.z[body] * arm.x) / APPROACH;
  const [normal, tangent] = [v.y[body] + APPROACH, v.x[body] - slide].map((change) => change * Mass.value[body]);
  return { slip, separation, normal, tangent, gain: energy(world).kinetic / before - 1 };
}

const rod = (angle: number) => ({
  shape: capsule(2, 0.05),
  angle,
  arm: { x: -Math.cos(angle), y: -Math.sin(angle) - 0.05 },
});

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  test.each([
    [0.9, 0, 12],
    [0.9, 0.3, 12],
    [0.9, 0.3, -12],
    [0.5, 0.2, 12],
    [1, 0.2, -8],
  ])('a rod with e = %s and μ = %s that slides at %s m/s leaves the ground at e of its speed', (e, mu, slide) => {
    const { separation, slip, normal, tangent } = land(precision, { ...rod(0.6), e, mu, slide });
    expect(separation).toBeCloseTo(e, 2);
    // It slides in one direction all the time, so that friction is Coulomb's.
    expect(Math.sign(slip)).toBe(Math.sign(slide));
    expect(tangent / normal).toBeCloseTo(-mu * Math.sign(slide), 3);
  });

  test('no rod gains energy, however it lands', () => {
    const random = createRandom(5);
    for (let k = 0; k < 150; k++) {
      const angle = random.uniform(0.2, 1.4);
      const [e, mu, slide] = [random.uniform(), random.uniform(0, 1.2), random.uniform(-12, 12)];
      const { gain, separation, slip } = land(precision, { ...rod(angle), e, mu, slide });
      // The rounding of f32 in a hundred operations.
      expect(gain, `e = ${e}, μ = ${mu}, ${slide} m/s at ${angle}`).toBeLessThan(1e-4);
      expect(separation).toBeGreaterThan(-0.02);
      if (slip * slide > 0.5) expect(separation).toBeCloseTo(e, 1);
    }
  });

  test('a box that lands on a corner leaves the ground at e of its speed, while it slides', () => {
    const angle = 0.5;
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    const arm = { x: -0.5 * c + 0.5 * s, y: -0.5 * s - 0.5 * c };
    for (const slide of [-9, 20]) {
      const { separation, slip } = land(precision, { shape: box(1, 1), angle, arm, e: 0.5, mu: 0.2, slide });
      expect(Math.sign(slip)).toBe(Math.sign(slide));
      expect(separation).toBeCloseTo(0.5, 2);
    }
  });
});
