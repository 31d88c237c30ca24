// Short rods and ropes between light bodies under a load of a hundred times their mass. A rod of length l with the force F in it
// holds its ends back as a spring of stiffness F/l holds them, which is more than a sub-step can follow here.
import {
  box,
  capsule,
  createJoint,
  distance,
  energy,
  jointPosition,
  type PhysicsWorld,
  softStep,
  spawn,
  step,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, G, rigidWorld, run } from '../../../../test/support/rigid-world.ts';

type Kind = 'rods' | 'ropes';
type Precision = 'f32' | 'f64';

/** A joint of this length between a point of a and one of b, at the height 0. */
function join(world: PhysicsWorld, kind: Kind, ends: { a: number; b: number; x: number; length: number }): number {
  const { a, b, x, length } = ends;
  const limits = kind === 'ropes' ? { limits: { upper: length } } : {};
  return createJoint(world, distance({ a, b, anchorA: { x }, anchorB: { x: x + length }, ...limits }));
}

/** How far the longest of the joints is beyond this length in some seconds, m, and how far the energy is above the start, J. */
function watch(world: PhysicsWorld, seconds: number, joints: readonly number[], length: number) {
  const start = energy(world).total;
  let excess = 0;
  let gain = -Infinity;
  for (let i = 0; i < Math.round(seconds / DT); i++) {
    step(world, DT);
    for (const joint of joints) excess = Math.max(excess, jointPosition(world, joint) - length);
    gain = Math.max(gain, energy(world).total - start);
  }
  return { excess, gain };
}

/** Twelve planks of 10 kg in a row between two banks, at rest. */
function bridge(precision: Precision, kind: Kind, gap: number) {
  const world = rigidWorld({ precision });
  const count = 12;
  const width = 0.8;
  const bank = (x: number) => spawn(world, { position: { x }, collider: { shape: box(1, 0.2) } });
  const bodies = [bank(-0.5)];
  for (let i = 0; i < count; i++) {
    const x = gap + i * (width + gap) + width / 2;
    bodies.push(spawn(world, { position: { x }, mass: 10, inertia: 0.57, collider: { shape: box(width, 0.2) } }));
  }
  const right = count * (width + gap) + gap;
  bodies.push(bank(right + 0.5));
  const joints: number[] = [];
  for (let i = 0; i <= count; i++) {
    const ends = { a: bodies[i] as number, b: bodies[i + 1] as number, x: i * (width + gap), length: gap };
    joints.push(join(world, kind, ends));
  }
  for (let i = 0; i < 120; i++) step(world, DT);
  return { world, joints, middle: right / 2 };
}

/** A swing that begins level: links of 0.9 kg between joints of 0.3 m, and 100 kg at the end. */
function swing(precision: Precision, kind: Kind, count: number, substeps: number) {
  const world = rigidWorld({ precision, integrator: softStep({ substeps }) });
  const length = 0.3;
  let a = spawn(world, { position: {}, collider: { radius: 0.1 } });
  let x = 0;
  const joints: number[] = [];
  const hang = (b: number) => {
    joints.push(join(world, kind, { a, b, x, length }));
    a = b;
    x += length + 0.2;
  };
  for (let i = 0; i < count; i++) {
    const position = { x: x + length + 0.1 };
    hang(spawn(world, { position, collider: { shape: capsule(0.14, 0.03), density: 80 } }));
  }
  hang(spawn(world, { position: { x: x + length + 0.25 }, collider: { shape: box(0.5, 0.5), density: 400 } }));
  return { world, joints, reach: x + 0.05 };
}

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  it.each([1, 5])('a rope that is too long does not stop what comes back at %d m/s', (speed) => {
    const world = rigidWorld({ precision, forces: [] });
    const post = spawn(world, { position: {}, collider: { radius: 0.1 } });
    const b = spawn(world, { position: { x: 2.05 }, velocity: { x: -speed }, mass: 10, collider: { radius: 0.1 } });
    createJoint(world, distance({ a: post, b, limits: { upper: 2 } }));
    run(world, DT);
    // It only pulls, and nothing else acts.
    expect(world.components.Velocity.x[b]).toBeCloseTo(-speed, 5);
  });

  it.each([
    ['rods', 0.1, 100],
    ['rods', 0.1, 1000],
    ['rods', 0.3, 1000],
    ['ropes', 0.1, 1000],
    ['ropes', 0.3, 1000],
  ] as const)('a bridge of planks of 10 kg on %s of %d m bears a box of %d kg', (kind, gap, mass) => {
    const { world, joints, middle } = bridge(precision, kind, gap);
    const height = 1;
    spawn(world, { position: { x: middle, y: height }, mass, inertia: mass / 3, collider: { shape: box(1.5, 1) } });
    const { excess, gain } = watch(world, 15, joints, gap);
    // What lands at v gives way by less than 2 v h in a sub-step h.
    expect(excess).toBeLessThan((2 * Math.sqrt(2 * G * height) * DT) / 4);
    expect(gain).toBeLessThan(1e-3 * mass * G * height);
  });

  it.each([
    ['rods', 4],
    ['rods', 8],
    ['ropes', 4],
    ['ropes', 8],
  ] as const)('a minute of swinging on %s, in %d sub-steps, tears none and adds no energy', (kind, substeps) => {
    for (let count = 1; count <= 3; count++) {
      const { world, joints, reach } = swing(precision, kind, count, substeps);
      const { excess, gain } = watch(world, 60, joints, 0.3);
      // Where 100 kg jerk a slack link straight in one sub-step, its joints are up to 9 cm too long for two steps.
      expect(excess, `${count} links`).toBeLessThan(0.1);
      expect(gain, `${count} links`).toBeLessThan(0.01 * 100 * G * reach);
      expect(world.faults.faults).toHaveLength(0);
    }
  });
});
