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

import { PhysicsError } from '../faults/physics-error';
import { checkFunction, checkKeys, type Vector } from '../faults/validate';
import { momentOf } from '../forces/evaluate';
import type { Field } from '../forces/field-force';
import { timeVector, type VectorOverTime } from '../forces/time-vector';
import { axisColumns } from '../store/columns';
import { resource } from '../store/resource';
import type { Spans } from '../store/spans';
import type { PhysicsWorld } from '../world';
import type { Integrator } from './integrator';
import { integratorKernels } from './kernels';
import { drift, kick } from './moves';
import { multiplesOf } from './multiples';

/** The magnetic field, T: give one of the two. In two dimensions only z acts. */
export interface BorisOptions {
  /** The same everywhere: a vector, or a function of the time, s, that returns it. */
  readonly field?: VectorOverTime;
  /** One that differs from place to place; called for each charge in each step. */
  readonly fieldAt?: Field;
}

const halfOf = multiplesOf([1 / 2]);

const ANY = { min: -1e30, max: 1e30 };

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function boris(options: BorisOptions): Integrator {
  checkKeys(options, 'boris', ['field', 'fieldAt']);
  const { field, fieldAt } = options;
  if ((field === undefined) === (fieldAt === undefined)) {
    throw new PhysicsError('E_RANGE', 'boris needs either field or fieldAt.', { field: 'field', value: field });
  }
  if (fieldAt !== undefined) checkFunction(fieldAt, 'fieldAt');
  const uniform = timeVector(field ?? {}, 'boris', 'field', ANY);
  return {
    name: 'Boris',
    order: 2,
    symplectic: false,
    evaluations: 1,
    columns: fieldAt === undefined ? 0 : 3,
    isStable: (stiffness, damping) => stiffness + 2 * damping <= 4,
    prepare(world) {
      if (fieldAt !== undefined) fieldOf(world);
    },
    advance(world, spans, dt, evaluateForces) {
      const half = halfOf(dt)[0];
      drift(world, spans, half);
      evaluateForces(world, spans, momentOf(world, half));
      kick(world, spans, half);
      if (uniform.steady !== undefined && fieldAt === undefined) turnAll(world, spans, uniform.steady, dt);
      else if (fieldAt === undefined) turnAll(world, spans, uniform.at(world, world.time + half), dt);
      else sampleAndTurn(world, spans, fieldAt, world.time + half, dt);
      kick(world, spans, half);
      drift(world, spans, half);
    },
  };
}

const NOWHERE = { x: 0, y: 0, z: 0 };

function turnAll(world: PhysicsWorld, spans: Spans, uniform: Vector, dt: number): void {
  for (let r = 0; r < spans.count; r++) {
    turnRun(world, NOWHERE, uniform, dt, spans.bounds[2 * r], spans.bounds[2 * r + 1]);
  }
}

/** With the field in the columns whose addresses are given, or the uniform one where an address is 0. */
function turnRun(world: PhysicsWorld, at: Vector, uniform: Vector, dt: number, first: number, last: number): void {
  const { borisTurn2d, borisTurn3d } = integratorKernels(world);
  const { Velocity: v, Charge, Mass } = world.addresses;
  const q = Charge.value;
  const m = Mass.value;
  if (world.dimensions === 2) {
    borisTurn2d(v.x, v.y, q, m, at.z, uniform.z, dt, first, last);
  } else {
    const { x, y, z } = uniform;
    borisTurn3d(v.x, v.y, v.z, q, m, at.x, at.y, at.z, x, y, z, dt, first, last);
  }
}

const fieldOf = resource(({ internal: { arena }, precision, rows }) => {
  const [columns, at] = axisColumns(arena, precision, rows, 'Boris: magnetic field');
  return { columns, at, field: { x: 0, y: 0, z: 0 } };
});

function sampleAndTurn(world: PhysicsWorld, spans: Spans, fieldAt: Field, time: number, dt: number): void {
  const { columns, at, field } = fieldOf(world);
  const { Position, Charge } = world.components;
  for (let r = 0; r < spans.count; r++) {
    const first = spans.bounds[2 * r];
    const last = spans.bounds[2 * r + 1];
    for (let row = first; row < last; row++) {
      field.x = 0;
      field.y = 0;
      field.z = 0;
      if (Charge.value[row] !== 0) fieldAt(Position.x[row], Position.y[row], Position.z[row], time, field);
      columns.x[row] = field.x;
      columns.y[row] = field.y;
      columns.z[row] = field.z;
    }
    turnRun(world, at, NOWHERE, dt, first, last);
  }
}
