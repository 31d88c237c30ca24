// Gravity of a spherical cloud, from a table of the mass within each radius (the shell theorem).
//
//   F = -m G M(<r) r/|r|³        U = -m G ∫ᵣ^∞ M(<s)/s² ds
//
//   m  mass, kg    G  gravitational constant, m³/(kg s²)    M(<r)  mass within r, kg    r  from the centre, m
//
// The density is uniform within the first radius, M is linear in r between radii, and all of it is inside the last:
// the table is never read beyond its end. Shells outside r pull nothing (Newton, Principia I, propositions 70 and 71).
// Valid for spherical symmetry. Cost: a square root, two divisions and a search of log₂ n steps a body. The table takes
// 24 bytes a radius of the memory of each world it is used in, and stays there.
import { PhysicsError } from '../faults/physics-error';
import { checkKeys, checkList, checkNumber } from '../faults/validate';
import { log } from '../math/elementary';
import { allocate } from '../store/arena';
import { resource } from '../store/resource';
import { LENGTHS, NOT_NEGATIVE, POSITIVE } from './bounds';
import { CENTRE_KEYS, type CentreOptions, centralForce, LAW, type LawParameters } from './central';
import type { Force } from './force';

/** Newton's constant of gravitation, m³/(kg s²): CODATA 2022. */
export const GRAVITATIONAL_CONSTANT = 6.6743e-11;

export interface EnclosedMassOptions extends CentreOptions {
  /** Radii, m: positive and ascending. */
  readonly radii: readonly number[];
  /** Mass within each radius, kg: not descending. */
  readonly masses: readonly number[];
  /** G, m³/(kg s²); default Newton's. */
  readonly gravitationalConstant?: number;
}

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN; E_CAPACITY from a step, when the world has no room */
export function enclosedMassGravity(options: EnclosedMassOptions): Force {
  checkKeys(options, 'enclosedMassGravity', ['radii', 'masses', 'gravitationalConstant', ...CENTRE_KEYS]);
  const g = checkNumber(
    options.gravitationalConstant ?? GRAVITATIONAL_CONSTANT,
    'enclosedMassGravity.gravitationalConstant',
    POSITIVE,
  );
  const table = profile(options.radii, options.masses);
  const knots = table.length / 3;
  const values = resource((world): LawParameters => {
    const at = allocate(world.internal.arena, table.byteLength, 'a mass profile');
    new Float64Array(world.memory.buffer, at, table.length).set(table);
    return [g, at, knots];
  });
  return centralForce(
    {
      name: 'enclosed mass gravity',
      equation: 'F = -m G M(<r) r / |r|³',
      law: LAW.enclosedMass,
      couplesTo: 'Mass',
      parameters: {
        gravitationalConstant: { unit: 'm³/(kg s²)', value: g },
        radius: { unit: 'm', value: table[3 * knots - 3] },
        mass: { unit: 'kg', value: table[3 * knots - 2] },
      },
      values,
    },
    options,
    'enclosedMassGravity',
  );
}

/** (radius, mass, potential per G) a knot; the potential from outside in, exactly for M linear between knots. */
function profile(radii: readonly number[], masses: readonly number[]): Float64Array {
  checkList(radii, 'enclosedMassGravity.radii');
  checkList(masses, 'enclosedMassGravity.masses');
  const count = radii?.length ?? 0;
  if (count === 0 || masses?.length !== count) {
    throw new PhysicsError('E_RANGE', 'enclosedMassGravity needs as many masses as radii, and at least one.', {
      field: 'masses',
      value: masses,
    });
  }
  const table = new Float64Array(3 * count);
  for (let i = 0; i < count; i++) {
    const least = i === 0 ? 0 : table[3 * i - 3];
    const lightest = i === 0 ? 0 : table[3 * i - 2];
    table[3 * i] = checkNumber(radii[i], `enclosedMassGravity.radii[${i}]`, { ...LENGTHS, above: least });
    table[3 * i + 1] = checkNumber(masses[i], `enclosedMassGravity.masses[${i}]`, { ...NOT_NEGATIVE, min: lightest });
  }
  table[3 * count - 1] = -table[3 * count - 2] / table[3 * count - 3];
  for (let i = count - 2; i >= 0; i--) {
    const [r1, m1, , r2, m2, outer] = table.subarray(3 * i, 3 * i + 6);
    const slope = (m2 - m1) / (r2 - r1);
    const rest = m2 - slope * r2;
    table[3 * i + 2] = outer + rest * (1 / r2 - 1 / r1) - slope * log(r2 / r1);
  }
  return table;
}
