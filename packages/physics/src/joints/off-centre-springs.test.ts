// Springs that are tied far from the centres of their bodies: as stiff as they are set, whatever keeps the bodies from turning.
import {
  box,
  circle,
  createJoint,
  distance,
  energy,
  type PhysicsWorld,
  prismatic,
  spawn,
  step,
  wheel,
} from '@principia/physics';
import { describe, expect, it, test } from 'vitest';
import { DT, G, rigidWorld } from '../../../../test/support/rigid-world.ts';

const UP = { y: 1 };

/** How far a crate at the origin sags on what holds it, m. */
function sag(hold: (world: PhysicsWorld, b: number) => void): number {
  const world = rigidWorld({ precision: 'f64' });
  const b = spawn(world, { position: {}, neverSleep: {}, collider: { shape: box(0.5, 0.5), density: 100, mask: 0 } });
  hold(world, b);
  for (let i = 0; i < 10 / DT; i++) step(world, DT);
  expect(Math.abs(world.components.Velocity.y[b])).toBeLessThan(2e-3);
  return -world.components.Position.y[b];
}

describe.each([1, 2, 5, 10, 15])('a spring of %d Hz', (hertz) => {
  const spring = { hertz, dampingRatio: 1 };
  const expected = G / (2 * Math.PI * hertz) ** 2;

  it.each([0, 0.25, 0.5, 1, 2, 4])('of a slider sags by g/ω² at an arm of %d m', (arm) => {
    const found = sag((world, b) => createJoint(world, prismatic({ b, anchor: { x: arm }, axis: UP, spring })));
    // That the slider does not turn is a joint, too, which gives way by 0.05 mm under the weight.
    expect(Math.abs(found - expected)).toBeLessThan(5e-5 + 1e-3 * expected);
  });

  it.each([0, 0.25, 0.5, 1])('of a rod beside a slider sags by about that at an arm of %d m', (arm) => {
    const found = sag((world, b) => {
      createJoint(world, prismatic({ b, anchor: {}, axis: UP }));
      createJoint(world, distance({ b, anchorA: { x: arm, y: 10 }, anchorB: { x: arm }, spring }));
    });
    // Springs of rods do not see what their bodies are joined to: at most they are as stiff as at 66 Hz on what they see, and turn the
    // crate by the little that the slider gives way.
    expect(found).toBeGreaterThan(0.99 * expected);
    expect(found - expected).toBeLessThan(0.01 * expected + 1.6e-3 * arm);
  });
});

test.each(['wheel', 'prismatic'])('a %s far from its bodies gives them no energy', (kind) => {
  const isSlider = kind === 'prismatic';
  const world = rigidWorld({ precision: 'f64', forces: [] });
  const anchor = isSlider ? { x: -0.212, y: -1.482 } : { x: 2.59, y: 1.756 };
  const a = spawn(world, {
    position: isSlider ? { x: -2.996, y: 2.917 } : { x: -2.648, y: -0.455 },
    velocity: isSlider ? { x: 0.273, y: 0.832 } : { x: 1.376, y: 1.685 },
    angularVelocity: isSlider ? -0.251 : 2.741,
    collider: { shape: circle(0.3), density: isSlider ? 3.996 : 10.633, mask: 0 },
  });
  const more = isSlider ? { velocity: { x: 1.011, y: -1.313 }, angularVelocity: 2.342, mass: 8 } : {};
  const b = spawn(world, { position: anchor, collider: { shape: circle(0.5), mask: 0 }, ...more });
  const spring = isSlider ? { hertz: 9.3, dampingRatio: 0.233 } : { hertz: 10.152, dampingRatio: 0.065 };
  const axis = isSlider ? { x: -0.411, y: -0.574 } : { x: -0.66, y: -0.884 };
  createJoint(world, (isSlider ? prismatic : wheel)({ a, b, anchor, axis, spring }));
  const start = energy(world).total;
  for (let i = 0; i < 10 / DT; i++) {
    step(world, DT);
    expect(energy(world).total).toBeLessThan(1.01 * start);
  }
});
