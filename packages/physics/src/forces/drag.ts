// Drag of a medium, still or moving at the wind w.
//
//   linear     F = -c (v - w)            slow, viscous: Re < 1     c, kg/s: 6 π η r for a sphere (Stokes 1851)
//   quadratic  F = -k |v - w| (v - w)    fast: Re > 1000           k, kg/m: ρ C_d A / 2 (Rayleigh)
//
// The coefficients are the columns LinearDrag and QuadraticDrag; zero, or no component, feels nothing.
// A source of both: Batchelor, An Introduction to Fluid Dynamics, sections 4.9 and 5.11.
// Cost: linear one multiply-add an axis; quadratic one square root more.
import type { Force } from './force';
import { shownVector } from './time-vector';
import { type Wind, windState } from './wind';

const STILL = { x: 0, y: 0, z: 0 };

/**
 * Linear drag.
 * @param wind velocity w of the medium, m/s, or a function of time, s, that gives it
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function linearDrag(wind: Wind = STILL): Force {
  const medium = windState(wind, 'linearDrag');
  return {
    name: 'linear drag',
    equation: 'F = -c (v - w)',
    parameters: shownVector('wind', 'm/s', medium.steady),
    reads: ['Velocity', 'LinearDrag'],
    local: true,
    timeless: typeof wind !== 'function',
    accumulate(world, first, last, time) {
      const w = medium.at(world, time);
      const { kernels, addresses, dimensions } = world;
      const { Velocity, LinearDrag } = addresses;
      const force = world.scratch.at.force;
      kernels.linearDragAxis(force.x, Velocity.x, LinearDrag.coefficient, w.x, first, last);
      kernels.linearDragAxis(force.y, Velocity.y, LinearDrag.coefficient, w.y, first, last);
      if (dimensions === 3) {
        kernels.linearDragAxis(force.z, Velocity.z, LinearDrag.coefficient, w.z, first, last);
      }
    },
  };
}

/**
 * Quadratic drag.
 * @param wind velocity w of the medium, m/s, or a function of time, s, that gives it
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function quadraticDrag(wind: Wind = STILL): Force {
  const medium = windState(wind, 'quadraticDrag');
  return {
    name: 'quadratic drag',
    equation: 'F = -k |v - w| (v - w)',
    parameters: shownVector('wind', 'm/s', medium.steady),
    reads: ['Velocity', 'QuadraticDrag'],
    local: true,
    timeless: typeof wind !== 'function',
    accumulate(world, first, last, time) {
      const w = medium.at(world, time);
      const { kernels, addresses } = world;
      const { x, y, z } = addresses.Velocity;
      const k = addresses.QuadraticDrag.coefficient;
      const force = world.scratch.at.force;
      if (world.dimensions === 2) {
        kernels.quadraticDrag2d(force.x, force.y, x, y, k, w.x, w.y, first, last);
      } else {
        kernels.quadraticDrag3d(force.x, force.y, force.z, x, y, z, k, w.x, w.y, w.z, first, last);
      }
    },
  };
}
