// Springs of joints in series, up to those that are far faster than the sub-steps: none gains energy.
import {
  box,
  createJoint,
  destroyWorld,
  distance,
  energy,
  type JointInput,
  type JointSpring,
  jointPosition,
  motorJoint,
  type PhysicsWorldOptions,
  prismatic,
  revolute,
  softStep,
  spawn,
  step,
  uniformGravity,
  weld,
  wheel,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, G, rigidWorld } from '../../../../test/support/rigid-world.ts';

const MASS = 10;
const SECONDS = 3;
const H = DT / 4;

type Make = (a: number, b: number, i: number, spring: JointSpring) => JointInput;

/** Joints of a beam of bars that lie, and of a column of boxes that hang. */
const LYING: Record<string, Make> = {
  weld: (a, b, i, spring) => weld({ a, b, anchor: { x: i }, spring }),
  revolute: (a, b, i, spring) => revolute({ a, b, anchor: { x: i }, spring }),
  motorJoint: (a, b, i, spring) =>
    motorJoint({ a, b, anchor: { x: i }, target: { x: i }, spring, maxForce: 1e9, maxTorque: 1e9 }),
};
const HANGING: Record<string, Make> = {
  distance: (a, b, _, spring) => distance({ a, b, spring }),
  prismatic: (a, b, i, spring) => prismatic({ a, b, anchor: { y: -1 - i }, axis: { y: 1 }, spring }),
  wheel: (a, b, i, spring) => wheel({ a, b, anchor: { y: -1 - i }, axis: { y: 1 }, spring }),
};

/** A row of bodies on springs, of which the last has another mass, at rest and without tension. */
function row(kind: string, count: number, ratio: number, spring: JointSpring, options: PhysicsWorldOptions = {}) {
  const world = rigidWorld({
    precision: 'f64',
    forces: [uniformGravity({ y: -G })],
    integrator: softStep({ sleepTime: 0 }),
    ...options,
  });
  const isLying = kind in LYING;
  const make = isLying ? LYING[kind] : HANGING[kind];
  let a = spawn(world, { position: {}, collider: { shape: box(0.1, 0.1) } });
  const bodies: number[] = [];
  const joints: number[] = [];
  for (let i = 0; i < count; i++) {
    const mass = i === count - 1 ? ratio * MASS : MASS;
    const position = isLying ? { x: 0.5 + i } : { y: -1 - i };
    const b = spawn(world, { position, mass, collider: { shape: box(isLying ? 1 : 0.2, 0.2) } });
    joints.push(createJoint(world, make(a, b, i, spring)));
    bodies.push(b);
    a = b;
  }
  return { world, bodies, joints };
}

/** The most of the kinetic and of the total energy beside what has fallen so far, and the deepest fall of a body, m. */
function drop(kind: string, count: number, ratio: number, spring: JointSpring, options?: PhysicsWorldOptions) {
  const { world, bodies } = row(kind, count, ratio, spring, options);
  const { Mass, Position } = world.components;
  const from = bodies.map((b) => Position.y[b]);
  const start = energy(world).total;
  let [fallen, deepest, moving, gained] = [0, 0, 0, 0];
  for (let i = 0; i < SECONDS / DT; i++) {
    step(world, DT);
    let given = 0;
    bodies.forEach((b, j) => {
      const depth = from[j] - Position.y[b];
      given += Mass.value[b] * G * depth;
      deepest = Math.max(deepest, Math.abs(depth));
    });
    fallen = Math.max(fallen, given);
    const { kinetic, total } = energy(world);
    moving = Math.max(moving, kinetic / fallen);
    gained = Math.max(gained, (total - start) / fallen);
  }
  destroyWorld(world);
  return { moving, gained, deepest };
}

const HERTZ = [20, 60, 100, 200, 1000, 1e6];
/**
 * Semi-implicit Euler keeps E - (h/2) F v, which is within hω/2 of E. The fastest springs that are not damped by themselves have
 * hω = 1/2, and ω of two in series is at most √2 of theirs.
 */
const IN_TREES = Math.SQRT2 / 4;
/** Of springs that are solved one after another the fastest motion has (hω)² = 3. */
const ALONE = Math.sqrt(3) / 2;

describe.each(['weld', 'revolute', 'prismatic', 'wheel', 'distance', 'motorJoint'])(
  'springs of %s in series',
  (kind) => {
    const isInTree = kind !== 'distance' && kind !== 'motorJoint';
    const bound = isInTree ? IN_TREES : ALONE;

    it.each([0, 0.1, 1])('gain no energy with the damping ratio %d', (dampingRatio) => {
      for (const ratio of [1, 10, 100]) {
        for (const count of ratio === 100 ? [1, 2] : [1, 2, 4]) {
          let before = Number.POSITIVE_INFINITY;
          for (const hertz of HERTZ) {
            const { moving, gained, deepest } = drop(kind, count, ratio, { hertz, dampingRatio });
            const what = `${hertz} Hz, 1 : ${ratio}, ${count} bodies`;
            expect(moving, what).toBeLessThan(1 + bound);
            // Up to here the stiffness is that which is counted.
            if (isInTree && hertz <= 200) expect(gained, what).toBeLessThan(bound);
            // What is stiffer gives way less.
            expect(deepest, what).toBeLessThan(before * 1.001);
            before = deepest;
          }
        }
      }
    });

    it('nor in f32', () => {
      for (const hertz of HERTZ) {
        const { moving, deepest } = drop(kind, 2, 10, { hertz, dampingRatio: 1 }, { precision: 'f32' });
        expect(moving, `${hertz} Hz`).toBeLessThan(1 + bound);
        expect(deepest, `${hertz} Hz`).toBeLessThan(0.5);
      }
    });
  },
);

it.each(['prismatic', 'wheel'])('a weight on two fast springs of %s hangs by load/(m ω²)', (kind) => {
  for (const hertz of [60, 200, 500]) {
    const { world, joints } = row(kind, 2, 100, { hertz, dampingRatio: 1 });
    for (let i = 0; i < 4 / DT; i++) step(world, DT);
    const square = (2 * Math.PI * hertz) ** 2;
    const reduced = (100 * MASS) / 101;
    expect(jointPosition(world, joints[0]) / ((-101 * MASS * G) / (MASS * square))).toBeCloseTo(1, 3);
    expect(jointPosition(world, joints[1]) / ((-100 * MASS * G) / (reduced * square))).toBeCloseTo(1, 3);
    destroyWorld(world);
  }
});

it('a beam of fast weld springs bends by the torques over I ω²', () => {
  for (const hertz of [60, 200]) {
    const { world, joints, bodies } = row('weld', 2, 1, { hertz, dampingRatio: 1 });
    for (let i = 0; i < 4 / DT; i++) step(world, DT);
    const stiffness = world.components.Inertia.value[bodies[0]] * (2 * Math.PI * hertz) ** 2;
    // Weights 0.5 m and 1.5 m from the first joint, and 0.5 m from the second, whose reduced inertia is half.
    expect(jointPosition(world, joints[0]) / ((-2 * MASS * G) / stiffness)).toBeCloseTo(1, 2);
    expect(jointPosition(world, joints[1]) / ((-0.5 * MASS * G) / (0.5 * stiffness))).toBeCloseTo(1, 2);
    destroyWorld(world);
  }
});

it.each([0, 0.1, 1])('many rods with springs at one body gain no energy with the damping ratio %d', (dampingRatio) => {
  for (const hertz of HERTZ) {
    const world = rigidWorld({ precision: 'f64', forces: [uniformGravity({ y: -G })] });
    const a = spawn(world, { position: { y: 3 }, collider: { radius: 0.1 } });
    const b = spawn(world, { position: {}, mass: 1, neverSleep: {}, collider: { radius: 0.1 } });
    const c = spawn(world, { position: { y: -2 }, mass: 10, neverSleep: {}, collider: { radius: 0.1 } });
    for (let i = 0; i < 8; i++) {
      createJoint(world, distance({ a, b, spring: { hertz, dampingRatio } }));
      createJoint(world, distance({ a: b, b: c, spring: { hertz, dampingRatio } }));
    }
    let fallen = 0;
    for (let i = 0; i < SECONDS / DT; i++) {
      step(world, DT);
      const { Position } = world.components;
      fallen = Math.max(fallen, -G * (Position.y[b] + 10 * (Position.y[c] + 2)));
      expect(energy(world).kinetic, `${hertz} Hz`).toBeLessThan((1 + ALONE) * fallen);
    }
    destroyWorld(world);
  }
});

it('a loop of fast weld springs, clamped at both ends, comes to rest', () => {
  for (const hertz of [60, 200, 1e6]) {
    const { world, bodies } = row('weld', 5, 1, { hertz, dampingRatio: 0.1 });
    const end = spawn(world, { position: { x: 5.1 }, collider: { shape: box(0.2, 0.2) } });
    createJoint(world, weld({ a: bodies[4], b: end, anchor: { x: 5 }, spring: { hertz, dampingRatio: 0.1 } }));
    for (let i = 0; i < 4 / DT; i++) step(world, DT);
    // A sub-step of free fall moves each by less.
    expect(energy(world).kinetic, `${hertz} Hz`).toBeLessThan(0.5 * 5 * MASS * (G * H) ** 2);
    destroyWorld(world);
  }
});
