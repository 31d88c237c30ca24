// A uniform electric field, steady or changing with time.
//
//   F = q E(t)        potential  U = -q E·r   (zero at the origin; only of a steady field)
//
//   q  charge, C    E  field, V/m (= N/C)
//
// Valid between plates wide against their distance, and for fields that change slowly against the time light takes
// across the scene: no radiation, no induced magnetic field. Griffiths, Introduction to Electrodynamics, chapter 2.
// Cost: one multiply-add an axis.
import { ANY } from './bounds';
import type { Force } from './force';
import { shownVector, timeVector, type VectorOverTime } from './time-vector';

/**
 * @param field E, V/m, or a function of the time, s, that returns it
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function electricField(field: VectorOverTime): Force {
  const state = timeVector(field, 'electricField', 'electricField', ANY);
  const { steady } = state;
  const force: Force = {
    name: 'electric field',
    equation: 'F = q E(t)',
    parameters: shownVector('field', 'V/m', steady),
    reads: ['Charge'],
    local: true,
    timeless: steady !== undefined,
    accumulate(world, first, last, time) {
      const e = state.at(world, time);
      const { kernels, addresses, dimensions } = world;
      const charge = addresses.Charge.value;
      const at = world.scratch.at.force;
      if (e.x !== 0) kernels.uniformGravityAxis(at.x, charge, e.x, first, last);
      if (e.y !== 0) kernels.uniformGravityAxis(at.y, charge, e.y, first, last);
      if (e.z !== 0 && dimensions === 3) kernels.uniformGravityAxis(at.z, charge, e.z, first, last);
    },
  };
  if (steady === undefined) return force;
  return {
    ...force,
    potential({ kernels, addresses: { Charge, Position }, lastId }) {
      const along = (axis: 'x' | 'y' | 'z') =>
        steady[axis] * kernels.dotColumns(Charge.value, Position[axis], 0, lastId + 1);
      return -(along('x') + along('y') + along('z'));
    },
  };
}
