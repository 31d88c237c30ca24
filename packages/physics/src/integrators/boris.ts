// Boris's scheme for charges in magnetic fields.
//
//   x½ = x + v dt/2        v⁻ = v + F/m dt/2        v⁺ = v⁻ rotated about B by 2 atan(|q| B dt/2m)
//   v' = v⁺ + F/m dt/2     x' = x½ + v' dt/2        F: all forces except the magnetic force, at x½
//
// Second order. A magnetic field only rotates the velocity, so in a purely magnetic field the speed is constant to
// rounding at any step, unlike in the other schemes. The angle is too small by the fraction (q B dt/m)²/12, so
// gyration lags. It preserves phase-space volume, is reversible, and its energy error is bounded. One force
// evaluation. Drag makes it first order. Pass the field here, not to `world.forces`; the electric field remains a
// force.
//
// Boris, Proc. 4th Conf. Numerical Simulation of Plasmas (1970), p. 3; Qin et al., Phys. Plasmas 20, 084503 (2013).

import { PhysicsError } from '../errors/physics-error.ts';
import { checkFunction, checkKeys } from '../errors/validate.ts';
import { axial } from '../laws/axial.ts';
import { constant, Scalar, select, type Vector, vectorOf } from '../laws/expression.ts';
import { axialVectorOverTime, sourcesOf } from '../laws/parameter.ts';
import type { VectorOverTime } from '../laws/time-vector.ts';
import type { Integrator } from '../world/types.ts';
import { defineCheckedIntegrator } from './support/define-integrator.ts';

/** The magnetic field, T: exactly one of the two. In 2D only z is used. */
export interface BorisOptions {
  /** A uniform field: a vector, or a function of time, s, that returns it. Default none: then `fieldAt` is needed. */
  readonly field?: VectorOverTime;
  /**
   * A non-uniform field as an expression: called once, with symbols of position (m) and time (s). Default none: then
   * `field` is needed.
   */
  readonly fieldAt?: (position: Vector, time: Scalar) => Vector;
}

/**
 * Boris's scheme for charges in a magnetic field, which turns their velocities exactly about it: no field changes the
 * speed. Second order, one force evaluation. Leave `magneticField` out of the forces.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function boris(options: BorisOptions): Integrator {
  checkKeys(options, 'boris', ['field', 'fieldAt']);
  const { field, fieldAt } = options;
  if ((field === undefined) === (fieldAt === undefined)) {
    throw new PhysicsError('E_RANGE', 'boris needs exactly one of field and fieldAt.', {
      field: 'field',
      value: field,
    });
  }
  if (fieldAt !== undefined) checkFunction(fieldAt, 'fieldAt');
  const parameters = { field: axialVectorOverTime('T', { min: -1e30, max: 1e30 }) };
  const sources = sourcesOf('boris', parameters, { field: field ?? {} });
  return defineCheckedIntegrator(
    {
      name: 'Boris',
      order: 2,
      symplectic: false,
      evaluations: 1,
      reads: ['Charge'],
      isStable: (stiffness, damping) => stiffness + 2 * damping <= 4,
    },
    ({ position, velocity, dt, charge, mass }, kick, [uniform]) => {
      const half = dt.mul(0.5);
      const middle = position.add(velocity.mul(half));
      const kicked = kick(middle, velocity, 1 / 2, half);
      const time = new Scalar('time', []).add(half);
      const b = fieldAt === undefined ? (uniform as Vector) : axial(vectorOf(fieldAt(middle, time), 'boris: fieldAt'));
      const gyration = select(mass.greater(0), charge.div(mass).mul(half), 0);
      const after = rotate(velocity.add(kicked), b.mul(gyration)).add(kicked);
      return { position: middle.add(after.mul(half)), velocity: after };
    },
    { parameters: [parameters.field], sources },
  );
}

/** Rotates v about t = q B dt/2m by 2 atan |t|, preserving its length. */
function rotate(v: Vector, t: Vector): Vector {
  const across = v.add(v.cross(t));
  return v.add(across.cross(t).mul(constant(2).div(t.lengthSquared().add(1))));
}
