// Torques and forces that depend on the angle of a rigid body: in each sub-step they see it as it is then.
import {
  box,
  defineForce,
  defineLaw,
  type PhysicsWorld,
  polygonBuoyancy,
  scalar,
  softStep,
  spawn,
  step,
  thrust,
  uniformGravity,
  vec3,
} from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { DT, G, rigidWorld } from '../../../../test/support/rigid-world.ts';

const torsion = defineLaw({
  name: 'torsion',
  parameters: { stiffness: scalar('N m/rad') },
  torque: ({ rotate }, { stiffness }) => vec3(0, 0, rotate(vec3(1, 0)).y.mul(stiffness).negate()),
});

/** The largest angle in the last second of a time, rad. */
function lastSwing(world: PhysicsWorld, body: number, seconds: number): number {
  let largest = 0;
  for (let i = 0; i < seconds / DT; i++) {
    step(world, DT);
    if (i * DT > seconds - 1) largest = Math.max(largest, Math.abs(world.components.Rotation.angle[body]));
  }
  return largest;
}

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  test.each([1, 4, 16])('a force sees poses and velocities of one moment in each of %d sub-steps', (substeps) => {
    const seen: number[][] = [];
    const spy = defineForce({
      name: 'spy',
      equation: 'F = 0',
      reads: ['Position', 'Rotation'],
      accumulate({ components: { Position, Rotation } }, first, last, time) {
        if (first <= 1 && last >= 1) seen.push([time, Position.x[1], Rotation.angle[1]]);
      },
    });
    const world = rigidWorld({ precision, forces: [spy], integrator: softStep({ substeps }) });
    spawn(world, {
      position: {},
      rotation: 0,
      velocity: { x: 2 },
      angularVelocity: 3,
      collider: { shape: box(1, 1), density: 1 },
    });
    for (let i = 0; i < 3; i++) step(world, DT);
    expect(seen.length).toBe(3 * substeps);
    for (const [time, x, angle] of seen) {
      expect(x).toBeCloseTo(2 * time, 6);
      expect(angle).toBeCloseTo(3 * time, 6);
    }
  });

  test('what a spring of torsion turns swings on for a minute', () => {
    const world = rigidWorld({
      precision,
      forces: [torsion({ stiffness: 60 })],
      integrator: softStep({ sleepTime: 0 }),
    });
    const body = spawn(world, { position: {}, rotation: 0.1, mass: 1, inertia: 1, collider: { shape: box(1, 1) } });
    // Semi-implicit Euler swings within ω h/2 of its part, ω² = k/I; f32 rounds 14 400 times, to 6e-9 rad each.
    const part = Math.sqrt(60) * (DT / 4) * 0.5;
    const swing = lastSwing(world, body, 60);
    expect(Math.abs(swing / 0.1 - 1)).toBeLessThan(part + 1e-3);
  });

  test('a barge that is tilted rolls on as far as it was tilted', () => {
    const [width, height, density] = [4, 0.5, 300];
    const corners = [
      [-1, -1],
      [1, -1],
      [1, 1],
      [-1, 1],
    ].map(([x, y]) => ({ x: (x * width) / 2, y: (y * height) / 2 }));
    const sea = polygonBuoyancy({ density: 1000, level: 0 }, { shape: 2, vertices: corners });
    const world = rigidWorld({ precision, forces: [uniformGravity(), sea], integrator: softStep({ sleepTime: 0 }) });
    const draft = 0.3 * height;
    const body = spawn(world, {
      position: { y: height / 2 - draft },
      rotation: 0.003,
      collider: { shape: box(width, height), density },
      hull: { volume: width * height, shape: 2 },
    });
    // ω² = g GM/k², where GM is the metacentric height and k the radius of gyration.
    const metacentric = width ** 2 / (12 * draft) - (height - draft) / 2;
    const omega = Math.sqrt((G * metacentric * 12) / (width ** 2 + height ** 2));
    const swing = lastSwing(world, body, 30);
    expect(Math.abs(swing / 0.003 - 1)).toBeLessThan((omega * DT) / 8 + 0.01);
  });

  test('thrust along a body that turns goes round with it', () => {
    // v = T/(m ω) (sin ω t, 1 - cos ω t): of first order in the sub-step, by half of one.
    const world = rigidWorld({ precision, forces: [thrust({ frame: 'body' })] });
    const collider = { shape: box(1, 1) };
    const body = spawn(world, {
      position: {},
      rotation: 0,
      angularVelocity: 6,
      mass: 1,
      inertia: 1,
      thrust: { x: 10 },
      collider,
    });
    for (let i = 0; i < 60; i++) step(world, DT);
    const { x, y } = world.components.Velocity;
    const error = Math.hypot(x[body] - (10 / 6) * Math.sin(6), y[body] - (10 / 6) * (1 - Math.cos(6)));
    const along = Math.hypot(Math.sin(6), 1 - Math.cos(6)) * (10 / 6);
    expect(error).toBeLessThan(((6 * DT) / 4) * 0.5 * along * 1.01 + 1e-4);
  });
});
