// What joints hold moves on arcs: a sub-step is a chord of the arc, so that swinging costs no energy (kernels/joints/2d/chords.ts).
import {
  box,
  createJoint,
  distance,
  energy,
  jointForce,
  type PhysicsWorld,
  prismatic,
  revolute,
  softStep,
  spawn,
  step,
  weld,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, G, rigidWorld } from '../../../../test/support/rigid-world.ts';

const block = (world: PhysicsWorld, x: number) =>
  spawn(world, { position: { x }, collider: { shape: box(0.4, 0.2), density: 10, layers: 0 } });
const hinge = (world: PhysicsWorld, x: number, b: number, a?: number) =>
  createJoint(world, revolute({ ...(a === undefined ? {} : { a }), b, anchor: { x } }));

/** What begins level and at rest. */
const SWINGS = {
  'a pendulum'(world: PhysicsWorld) {
    hinge(world, 0, block(world, 2));
  },
  'a weight on a rod'(world: PhysicsWorld) {
    createJoint(world, distance({ b: block(world, 2), anchorA: {} }));
  },
  'a weight on a rope'(world: PhysicsWorld) {
    createJoint(world, distance({ b: block(world, 2), anchorA: {}, limits: { upper: 2 } }));
  },
  'a swing of two bars and a seat, which is a loop,'(world: PhysicsWorld) {
    const [left, right, seat] = [block(world, 0.5), block(world, 2.5), block(world, 2)];
    hinge(world, 0, left);
    hinge(world, 2, right);
    hinge(world, 1, seat, left);
    hinge(world, 3, seat, right);
  },
  'a pendulum on a cart'(world: PhysicsWorld) {
    const cart = block(world, 0);
    createJoint(world, prismatic({ b: cart, anchor: {}, axis: { x: 1 } }));
    hinge(world, 0, block(world, 1), cart);
  },
  'a pendulum of two that are welded'(world: PhysicsWorld) {
    const [a, b] = [block(world, 0.5), block(world, 1)];
    hinge(world, 0, a);
    createJoint(world, weld({ a, b, anchor: { x: 0.75 } }));
  },
};

/** Mean of the energy from the 15th to the 20th second, less that at the start, for the largest kinetic energy. */
function driftOf(swing: keyof typeof SWINGS, substeps: number, precision: 'f32' | 'f64'): number {
  const world = rigidWorld({ precision, integrator: softStep({ substeps, sleepTime: 0 }) });
  SWINGS[swing](world);
  const start = energy(world).total;
  let [largest, sum] = [0, 0];
  for (let i = 0; i < 1200; i++) {
    step(world, DT);
    const { kinetic, total } = energy(world);
    largest = Math.max(largest, kinetic);
    if (i >= 900) sum += total - start;
  }
  return sum / 300 / largest;
}

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  it.each(Object.keys(SWINGS) as (keyof typeof SWINGS)[])('%s keeps its energy, to second order', (swing) => {
    const [one, two, four] = [1, 2, 4].map((substeps) => driftOf(swing, substeps, precision)) as [
      number,
      number,
      number,
    ];
    // With half of the sub-step the loss is a quarter; along tangents it was a half, and the pendulum lost a fifth in 20 s.
    expect(one / two).toBeGreaterThan(3.5);
    expect(two / four).toBeGreaterThan(3.5);
    expect(Math.abs(four)).toBeLessThan(0.005);
  });
});

it('a pendulum that falls from level has the period of its amplitude', () => {
  const world = rigidWorld({ integrator: softStep({ sleepTime: 0 }) });
  // Its own inertia counts little: its length is 2 m, its radius 1 cm.
  const bob = spawn(world, { position: { x: 2 }, collider: { radius: 0.01, density: 1000 } });
  hinge(world, 0, bob);
  const { x, y } = world.components.Position;
  const crossings: number[] = [];
  let before = x[bob] as number;
  for (let i = 1; i <= 1800; i++) {
    step(world, DT);
    const now = x[bob] as number;
    if (before > 0 !== now > 0) crossings.push((i - now / (now - before)) * DT);
    before = now;
    // At its lowest point it pulls with three times its weight, which stretches a joint of 72 Hz by 3 g / (2π 72 Hz)².
    expect(Math.abs(Math.hypot(now, y[bob] as number) - 2)).toBeLessThan((1.1 * 3 * G) / (2 * Math.PI * 72) ** 2);
  }
  const halves = crossings.length - 1;
  const period = (2 * ((crossings[halves] as number) - (crossings[0] as number))) / halves;
  // 4 √(L/g) K(sin 45°), with K = 1.8540747. Source: Abramowitz and Stegun, 17.3.
  expect(period / (4 * Math.sqrt(2 / G) * 1.8540747)).toBeCloseTo(1, 3);
});

it('a bead that slides out along a turning rod keeps its energy: Coriolis and centrifugal force come from the slider', () => {
  const world = rigidWorld({ forces: [], integrator: softStep({ substeps: 1, sleepTime: 0 }) });
  const rod = spawn(world, { position: {}, rotation: 0, angularVelocity: 3, velocity: {}, mass: 1, inertia: 2 });
  const bead = spawn(world, {
    position: { x: 0.5 },
    rotation: 0,
    velocity: { y: 1.5 },
    angularVelocity: 3,
    mass: 1,
    inertia: 0.05,
  });
  hinge(world, 0, rod);
  createJoint(world, prismatic({ a: rod, b: bead, anchor: { x: 0.5 }, axis: { x: 1 } }));
  const start = energy(world).total;
  for (let i = 0; i < 120; i++) step(world, DT);
  // No force acts, so that no speed lags behind its place. Along tangents 3 % were lost.
  expect(Math.abs(energy(world).total / start - 1)).toBeLessThan(1e-6);
  // ω = L/(I + m r²), with L = 3 (2.05 + 0.25) kg m²/s; it lags behind r by half a step, in which r² grows by 1 %.
  const { Position, AngularVelocity } = world.components;
  const r = Math.hypot(Position.x[bead] as number, Position.y[bead] as number);
  expect(r).toBeGreaterThan(7);
  expect(Math.abs((AngularVelocity.z[rod] as number) / (6.9 / (2.05 + r * r)) - 1)).toBeLessThan(0.012);
});

it('a hammer that strikes a wall at its lowest point stands, and its hinge bears its weight alone', () => {
  const world = rigidWorld();
  spawn(world, { position: { x: -0.6, y: -2 }, collider: { shape: box(1, 1) } });
  const hammer = spawn(world, { position: { x: 2 }, mass: 10, inertia: 0.1, collider: { radius: 0.1 } });
  const joint = hinge(world, 0, hammer);
  let highest = -Infinity;
  for (let i = 0; i < 300; i++) {
    step(world, DT);
    if (i > 100) highest = Math.max(highest, world.components.Position.y[hammer] as number);
  }
  expect(highest).toBeLessThan(-1.99);
  expect(jointForce(world, joint) / (10 * G)).toBeCloseTo(1, 2);
});
