// User-defined fields: a function of position and time gives the acceleration, or the force, on every body.
//
//   accelerationField   F = m a(r, t)        forceField   F = f(r, t)
//
//   m  mass, kg    a  m/s²    f  N    r  position, m    t  time, s
//
//   const sway = accelerationField((x, y, z, t, out) => {
//     out.x = 2 * sin(3 * t);
//   });
//
// The function writes to `out`, which holds zeros; what it returns has no effect. It must depend only on its arguments,
// or two runs differ; use the portable sine and the other functions of this package. With a `potential` (J/kg, or J) the
// energy of the world is conserved. Cost: one call of the function per body and evaluation, in TypeScript.
import { describe, PhysicsError } from '../errors/physics-error.ts';
import { checkFunction, checkKeys, type Vector } from '../errors/validate.ts';
import type { Force, PhysicsWorld } from '../world/types.ts';

/** Writes the field at (x, y, z) and time t to `out`, which holds zeros. What it returns has no effect. */
export type Field = (x: number, y: number, z: number, t: number, out: { x: number; y: number; z: number }) => void;

/** Options of `accelerationField` and `forceField`. */
export interface FieldOptions {
  /**
   * Potential, J/kg (of an acceleration) or J (of a force), at a position; for conservative fields only. Default none:
   * then the energy leaves this force out.
   */
  readonly potential?: (x: number, y: number, z: number) => number;
  /** Name of the force; default 'acceleration field' or 'force field'. */
  readonly name?: string;
}

/**
 * A field of acceleration: it is independent of the mass of a body.
 * @param field writes the acceleration, m/s², at a position and time to its last argument
 * @throws PhysicsError E_TYPE, E_UNKNOWN
 */
export function accelerationField(field: Field, options: FieldOptions = {}): Force {
  return fieldForce(field, options, true, 'acceleration field', 'F = m a(r, t)');
}

/**
 * A field of force, for every body with mass.
 * @param field writes the force, N, at a position and time to its last argument
 * @throws PhysicsError E_TYPE, E_UNKNOWN
 */
export function forceField(field: Field, options: FieldOptions = {}): Force {
  return fieldForce(field, options, false, 'force field', 'F = f(r, t)');
}

function fieldForce(field: Field, options: FieldOptions, perMass: boolean, name: string, equation: string): Force {
  checkFunction(field, name);
  checkKeys(options, `the options of the ${name}`, ['potential', 'name']);
  const { potential } = options;
  if (potential !== undefined) checkFunction(potential, `the potential of the ${name}`);
  if (options.name !== undefined && typeof options.name !== 'string') {
    throw new PhysicsError('E_TYPE', `the name of the ${name} must be a string.`, {
      field: 'name',
      value: options.name,
    });
  }
  const out = { x: 0, y: 0, z: 0 };
  const force: Force = {
    name: options.name ?? name,
    equation,
    reads: ['Position', 'Mass'],
    local: true,
    accumulate({ components: { Position, Mass }, scratch, dimensions }, first, last, time) {
      const total = scratch.force;
      let returned: unknown;
      for (let eid = first; eid < last; eid++) {
        const mass = Mass.value[eid];
        if (!(mass > 0)) continue;
        out.x = 0;
        out.y = 0;
        out.z = 0;
        returned = field(Position.x[eid], Position.y[eid], Position.z[eid], time, out);
        const scale = perMass ? mass : 1;
        total.x[eid] += scale * out.x;
        total.y[eid] += scale * out.y;
        if (dimensions === 3) total.z[eid] += scale * out.z;
      }
      checkReturned(returned, out, force.name);
    },
  };
  return potential === undefined ? force : { ...force, potential: (world) => sumPotential(world, potential, perMass) };
}

/**
 * The type of `field` allows every result, because those of functions such as `(x, y, z, t, out) => (out.x = t)` are of no
 * account. A result in place of a field is a mistake; the last body of each range shows it.
 * @throws PhysicsError E_TYPE
 */
function checkReturned(returned: unknown, out: Vector, name: string): void {
  if (!returned || returned === out || out.x !== 0 || out.y !== 0 || out.z !== 0) return;
  throw new PhysicsError('E_TYPE', `"${name}" returned ${describe(returned)} and wrote nothing to \`out\`.`, {
    field: name,
    hint: 'Write to it: (x, y, z, t, out) => { out.x = 20; }.',
  });
}

function sumPotential(
  { components: { Position, Mass }, lastId }: PhysicsWorld,
  potential: (x: number, y: number, z: number) => number,
  perMass: boolean,
): number {
  let sum = 0;
  for (let eid = 1; eid <= lastId; eid++) {
    const mass = Mass.value[eid];
    if (mass > 0) sum += (perMass ? mass : 1) * potential(Position.x[eid], Position.y[eid], Position.z[eid]);
  }
  return sum;
}
