// Boris's scheme for charges in magnetic fields.
//
//   x½ = x + v dt/2        v⁻ = v + F/m dt/2        v⁺ = v⁻ turned about B by 2 atan(|q| B dt/2m)
//   v' = v⁺ + F/m dt/2     x' = x½ + v' dt/2        F: all forces but the magnetic, at x½
//
// Second order. A magnetic field turns the velocity and does nothing else, so in it alone the speed is constant to
// rounding whatever the step: no other scheme here does that. The angle is a little too small, by (q B dt/m)²/12 of it,
// so gyration lags. It preserves the volume of phase space, is reversible, and its energy error is bounded. One force
// evaluation. Drag makes it first order. Give the field here, not to `world.forces`; the electric field stays a force.
//
// Boris, Proc. 4th Conf. Numerical Simulation of Plasmas (1970), p. 3; Qin et al., Phys. Plasmas 20, 084503 (2013).

import { PhysicsError } from '../errors/physics-error.ts';
import { checkFunction, checkKeys } from '../errors/validate.ts';
import { constant, Scalar, select, type Vector, vectorOf } from '../laws/expression.ts';
import { axialVectorOverTime, sourcesOf } from '../laws/parameter.ts';
import type { VectorOverTime } from '../laws/time-vector.ts';
import type { Integrator } from '../world/types.ts';
import { defineCheckedIntegrator } from './support/define-integrator.ts';

/** The magnetic field, T: give one of the two. In two dimensions only z acts. */
export interface BorisOptions {
  /** The same everywhere: a vector, or a function of the time, s, that returns it. */
  readonly field?: VectorOverTime;
  /** One that differs from place to place, as an expression: called once, with symbols of position (m) and time (s). */
  readonly fieldAt?: (position: Vector, time: Scalar) => Vector;
}

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function boris(options: BorisOptions): Integrator {
  checkKeys(options, 'boris', ['field', 'fieldAt']);
  const { field, fieldAt } = options;
  if ((field === undefined) === (fieldAt === undefined)) {
    throw new PhysicsError('E_RANGE', 'boris needs either field or fieldAt.', { field: 'field', value: field });
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
      isStable: (stiffness, damping) => stiffness + 2 * damping <= 4,
    },
    ({ position, velocity, dt, charge, mass }, kick, [uniform]) => {
      const half = dt.mul(0.5);
      const middle = position.add(velocity.mul(half));
      const kicked = kick(middle, velocity, 1 / 2, half);
      const time = new Scalar('time', []).add(half);
      const b = fieldAt === undefined ? (uniform as Vector) : vectorOf(fieldAt(middle, time), 'boris: fieldAt');
      const gyration = select(mass.greater(0), charge.div(mass).mul(half), 0);
      const after = turn(velocity.add(kicked), b.mul(gyration)).add(kicked);
      return { position: middle.add(after.mul(half)), velocity: after };
    },
    { parameters: [parameters.field], sources },
  );
}

/** Turns v about t = q B dt/2m by 2 atan |t|, without changing its length. */
function turn(v: Vector, t: Vector): Vector {
  const across = v.add(v.cross(t));
  return v.add(across.cross(t).mul(constant(2).div(t.lengthSquared().add(1))));
}
