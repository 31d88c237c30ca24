import { expect, test } from 'vitest';
import { despawn } from '../bodies/spawn.ts';
import type { Precision } from '../kernels/instantiate.ts';
import { createPhysicsWorld } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import { createCloth } from './cloth.ts';
import { clothWind } from './cloth-wind.ts';

/** Returns the forces of wind on the nodes of a bent sheet; `order` permutes its triangles. */
function forces(precision: Precision, order: (triangles: Uint32Array) => Uint32Array, lost?: number) {
  const world = createPhysicsWorld({ dimensions: 3, capacity: 2000, precision });
  const sheet = createCloth(world, { corner: {}, columns: 12, rows: 9, spacing: 0.1, mass: 1, structural: 0 });
  const { Position, Velocity } = world.components;
  sheet.nodes.forEach((node, i) => {
    Position.z[node] = 0.03 * ((i * i) % 7);
    Velocity.x[node] = 0.1 * (i % 5);
  });
  world.forces.push(clothWind({ triangles: order(sheet.triangles), velocity: { x: 1, z: 3 } }));
  step(world, 1e-6);
  if (lost !== undefined) {
    despawn(world, sheet.nodes[lost]);
    step(world, 1e-6);
  }
  const { x, y, z } = world.scratch.force;
  return Array.from(sheet.nodes, (node) => [x[node], y[node], z[node]]);
}

/** Reverses the order of the triangles. */
function backwards(triangles: Uint32Array): Uint32Array {
  return triangles.map((_, i) => triangles[triangles.length - 3 - 3 * Math.floor(i / 3) + (i % 3)]);
}

test.each(['f32', 'f64'] as const)('wind is independent of the order of triangles, in %s', (precision) => {
  const [forward, backward] = [forces(precision, (t) => t), forces(precision, backwards)];
  // Six forces of about 0.05 N are summed at a node.
  const rounding = 6 * 0.05 * (precision === 'f32' ? 6e-8 : 1.2e-16) * 4;
  let largest = 0;
  forward.forEach((force, node) => {
    force.forEach((value, axis) => {
      expect(Math.abs(value - backward[node][axis])).toBeLessThan(rounding);
      largest = Math.max(largest, Math.abs(value));
    });
  });
  expect(largest).toBeGreaterThan(0.01);
});

test('triangles with a removed corner receive no force, and the others are unchanged', () => {
  const [whole, torn] = [forces('f64', (t) => t), forces('f64', (t) => t, 40)];
  // The corner and its six neighbours receive less force; all others are unchanged.
  const changed = whole.flatMap((force, node) => (Math.abs(force[2] - torn[node][2]) > 1e-6 ? [node] : []));
  expect(changed).toEqual([28, 29, 39, 40, 41, 51, 52]);
});
