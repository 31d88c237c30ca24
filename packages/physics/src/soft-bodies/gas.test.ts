// The gas of a soft body goes with its body.
import { expect, test } from 'vitest';
import { despawn } from '../bodies/spawn.ts';
import { energy } from '../diagnostics/energy.ts';
import { springs } from '../forces/springs.ts';
import { restore, snapshot } from '../snapshot/snapshot.ts';
import { createPhysicsWorld } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import { createSoftBody } from './soft-body.ts';

const OPTIONS = { centre: {}, radius: 0.5, mass: 1, stiffness: 100, pressure: 50, detail: 3 };
const DT = 1 / 600;

test.each([2, 3] as const)(
  'soft bodies that come and go leave no force and take no memory, in %i dimensions',
  (dimensions) => {
    const world = createPhysicsWorld({ dimensions, capacity: 4000, forces: [springs()] });
    const tops: number[] = [];
    for (let i = 0; i < 8; i++) {
      const body = createSoftBody(world, OPTIONS);
      step(world, DT);
      expect(world.forces).toHaveLength(2);
      for (const node of body.nodes) despawn(world, node);
      step(world, DT);
      expect(world.forces).toHaveLength(1);
      tops.push(world.internal.arena.top);
    }
    // Features allocate what they need with the first bodies, and force memory is free in the step after the removal.
    expect(new Set(tops.slice(2)).size).toBe(1);
  },
);

test('the gas stays while some node is left, and comes back with its body', () => {
  const world = createPhysicsWorld({ capacity: 100, forces: [springs()] });
  const { gas, nodes } = createSoftBody(world, { ...OPTIONS, detail: 12 });
  const before = snapshot(world);
  for (const node of nodes.slice(1)) despawn(world, node);
  step(world, DT);
  expect(world.forces).toContain(gas);
  despawn(world, nodes[0]);
  step(world, DT);
  expect(world.forces).not.toContain(gas);
  restore(world, before);
  expect(world.forces).toContain(gas);
  step(world, DT);
  // A regular polygon under pressure: every node is pushed outwards, along its own radius.
  const { force } = world.scratch;
  expect(Math.hypot(force.x[nodes[0]], force.y[nodes[0]])).toBeGreaterThan(1);
});

test.each([
  [2, 4, 10, 500],
  [2, 4, 400, 50],
  [3, 12, 400, 500],
  [3, 12, 50, 200],
] as const)('the stated step keeps the energy, in %i dimensions', (dimensions, most, stiffness, pressure) => {
  const world = createPhysicsWorld({ dimensions, capacity: 1000, forces: [springs()], onWarning: () => {} });
  const { nodes, gas } = createSoftBody(world, { centre: {}, radius: 0.5, mass: 1, stiffness, pressure });
  // A = π in both: 2π r times one metre of depth, and 4π r². The longest edges of the ball are 0.163 m.
  const [volume, depth] = dimensions === 2 ? [Math.PI / 4, 1] : [Math.PI / 6, 0.163];
  const squares = [
    most * stiffness * nodes.length,
    (pressure * Math.PI * Math.PI) / volume,
    pressure * depth * nodes.length,
  ];
  const dt = 2 / Math.sqrt(squares[0] + squares[1] + squares[2]);
  const [{ total }, gasAmount] = [energy(world), gas.parameters?.amount.value as number];
  for (let i = 0; i < 300; i++) {
    step(world, dt);
    // A tenth of what the gas turns over. Steps 1.3 to 1.6 times as long let the energy of all but the first reach 1e34 J.
    expect(Math.abs(energy(world).total - total)).toBeLessThan(gasAmount / 10);
  }
});
