import {
  box,
  createJoint,
  despawn,
  distance,
  energy,
  type JointInput,
  type PhysicsWorld,
  prismatic,
  revolute,
  spawn,
  step,
  uniformGravity,
  weld,
  wheel,
} from '@principia/physics';
import { expect, it } from 'vitest';
import { DT, G, rigidWorld } from '../../../../test/support/rigid-world.ts';

const HERTZ = 1;
const OMEGA = 2 * Math.PI * HERTZ;
const spring = { hertz: HERTZ, dampingRatio: 0 };
/**
 * Semi-implicit Euler in four sub-steps of h keeps E - (h/2) F v, which is within hω/2 of E: two moments differ by hω at
 * most.
 */
const BOUND = (OMEGA * DT) / 4;

const lab = (gravity = 0): PhysicsWorld =>
  rigidWorld({ precision: 'f64', forces: gravity > 0 ? [uniformGravity({ y: -gravity })] : [] });

/** Least and largest total energy in ten seconds as parts of that at the start. */
function rangeOfTotal(world: PhysicsWorld): [number, number] {
  const start = energy(world).total;
  let [least, most] = [1, 1];
  for (let i = 0; i < 10 / DT; i++) {
    step(world, DT);
    const part = energy(world).total / start;
    least = Math.min(least, part);
    most = Math.max(most, part);
  }
  return [least, most];
}

it('keeps the energy of a mass on an undamped spring', () => {
  const world = lab();
  const b = spawn(world, { position: { x: 2 }, velocity: {}, mass: 3, collider: 0.1 });
  createJoint(world, distance({ b, anchorA: {}, length: 1, spring }));
  expect(energy(world).total).toBeCloseTo(0.5 * 3 * OMEGA ** 2, 9);
  const [least, most] = rangeOfTotal(world);
  expect(least).toBeGreaterThan(1 - BOUND);
  expect(most).toBeLessThan(1 + BOUND);
});

it('keeps the energy of two bodies on a spring', () => {
  const world = lab();
  const a = spawn(world, { position: { x: -1 }, velocity: {}, mass: 1, collider: 0.1 });
  const b = spawn(world, { position: { x: 1 }, velocity: {}, mass: 3, collider: 0.1 });
  createJoint(world, distance({ a, b, length: 1, spring }));
  // Reduced mass 3/4 kg.
  expect(energy(world).total).toBeCloseTo(0.5 * 0.75 * OMEGA ** 2, 9);
  const [least, most] = rangeOfTotal(world);
  expect(Math.max(1 - least, most - 1)).toBeLessThan(BOUND);
});

it('keeps the energy of a mass that swings on a spring', () => {
  const world = lab(G);
  const b = spawn(world, { position: { x: 2 }, velocity: {}, mass: 3, collider: 0.1 });
  createJoint(world, distance({ b, anchorA: {}, length: 1, spring }));
  const start = energy(world).total;
  // Stretched by mg/k = 0.25 m and by what turns it; parts of the energy of the stretch and of the fall.
  const scale = 0.5 * 3 * OMEGA ** 2 + 3 * G * 2;
  for (let i = 0; i < 600; i++) {
    step(world, DT);
    expect(Math.abs(energy(world).total - start) / scale).toBeLessThan(BOUND);
  }
});

const anchor = { x: 2 };
const axis = { x: 1 };
/** Joints of body b, and how it is moved from where their springs are at rest. */
const KINDS: readonly [string, (b: number) => JointInput, 'along' | 'about'][] = [
  ['prismatic', (b) => prismatic({ b, anchor, axis, spring }), 'along'],
  ['wheel', (b) => wheel({ b, anchor, axis, spring }), 'along'],
  ['revolute', (b) => revolute({ b, anchor, spring }), 'about'],
  ['weld', (b) => weld({ b, anchor, spring }), 'about'],
];

it.each(KINDS)('counts what the spring of a %s holds, and gives it back as motion', (_, joint, way) => {
  const world = lab();
  const b = spawn(world, { position: { x: 2 }, collider: { shape: box(1, 0.5), density: 4 } });
  createJoint(world, joint(b));
  const { Mass, Inertia, Position, Rotation } = world.components;
  expect(energy(world).total).toBe(0);
  if (way === 'along') Position.x[b] += 0.3;
  else Rotation.angle[b] += 0.3;
  const held = 0.5 * (way === 'along' ? Mass : Inertia).value[b] * (0.3 * OMEGA) ** 2;
  expect(energy(world).potential).toBeCloseTo(held, 9);
  // A quarter of a period later it passes its rest at full speed.
  for (let i = 0; i < 15; i++) step(world, DT);
  const { kinetic, potential } = energy(world);
  expect(potential / held).toBeLessThan(BOUND);
  expect(Math.abs(kinetic / held - 1)).toBeLessThan(BOUND);
});

it('counts a spring of limited force by its way', () => {
  const world = lab();
  const b = spawn(world, { position: { x: 2 }, velocity: {}, mass: 3, collider: 0.1 });
  const stiffness = 3 * OMEGA ** 2;
  createJoint(world, distance({ b, anchorA: {}, length: 1, spring: { ...spring, maxForce: 0.25 * stiffness } }));
  // ½ k s² up to a quarter of a metre, then 0.75 m of the largest force.
  expect(energy(world).potential).toBeCloseTo(stiffness * (0.5 * 0.25 ** 2 + 0.25 * 0.75), 9);
});

it('counts nothing of springs that move no body, or whose body is gone', () => {
  const world = lab();
  const a = spawn(world, { position: {}, velocity: {}, mass: 3, collider: 0.1 });
  const b = spawn(world, { position: { x: 2 }, velocity: {}, mass: 3, collider: 0.1 });
  const wall = spawn(world, { position: { y: 5 }, collider: 0.1 });
  createJoint(world, distance({ a: wall, b: spawn(world, { position: { y: 9 }, collider: 0.1 }), length: 1, spring }));
  expect(energy(world).potential).toBe(0);
  createJoint(world, distance({ a, b, length: 1, spring }));
  expect(energy(world).potential).toBeGreaterThan(0);
  despawn(world, a);
  expect(energy(world).potential).toBe(0);
});
