// Uniform gravity: every body with mass feels the same acceleration.
//
//   F = m g            potential  U = -m g·r   (zero at the origin)
//
//   m  mass, kg        g  acceleration, m/s²
//
// Valid near the surface of a planet, over heights small against its radius (over 1 km g falls by 0.03 %).
// Standard gravity 9.80665 m/s²: 3rd CGPM (1901), resolution on the unit of mass. Cost: one multiply-add an axis.
import { checkVector, type VectorInput } from '../faults/validate';
import { letAssign } from './assign';
import type { Force } from './force';

/** Standard acceleration of free fall, m/s². */
export const STANDARD_GRAVITY = 9.80665;

/**
 * @param acceleration g, m/s²; by default standard gravity downwards
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE
 */
export function uniformGravity(acceleration: VectorInput = { y: -STANDARD_GRAVITY }): Force {
  const g = checkVector(acceleration, 'uniformGravity', { min: -1e12, max: 1e12 });
  const force: Force = {
    name: 'uniform gravity',
    equation: 'F = m g',
    parameters: {
      gx: { unit: 'm/s²', value: g.x },
      gy: { unit: 'm/s²', value: g.y },
      gz: { unit: 'm/s²', value: g.z },
    },
    reads: ['Mass'],
    local: true,
    timeless: true,
    accumulate(world, first, last) {
      const { kernels, addresses, dimensions } = world;
      const mass = addresses.Mass.value;
      const force = world.scratch.at.force;
      if (g.x !== 0) kernels.uniformGravityAxis(force.x, mass, g.x, first, last);
      if (g.y !== 0) kernels.uniformGravityAxis(force.y, mass, g.y, first, last);
      if (g.z !== 0 && dimensions === 3) kernels.uniformGravityAxis(force.z, mass, g.z, first, last);
    },
    potential(world) {
      const { kernels, addresses } = world;
      const rows = world.lastId + 1;
      const { Mass, Position } = addresses;
      return -(
        g.x * kernels.dotColumns(Mass.value, Position.x, 0, rows) +
        g.y * kernels.dotColumns(Mass.value, Position.y, 0, rows) +
        g.z * kernels.dotColumns(Mass.value, Position.z, 0, rows)
      );
    },
  };
  letAssign(force, ({ kernels, addresses, dimensions, scratch }, first, last) => {
    const mass = addresses.Mass.value;
    const { x, y, z } = scratch.at.force;
    kernels.assignGravityAxis(x, mass, g.x, first, last);
    kernels.assignGravityAxis(y, mass, g.y, first, last);
    if (dimensions === 3) kernels.assignGravityAxis(z, mass, g.z, first, last);
  });
  return force;
}
