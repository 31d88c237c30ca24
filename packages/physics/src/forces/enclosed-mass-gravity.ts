// Gravity of a spherical cloud, from a table of the mass within each radius (the shell theorem).
//
//   F = -m G M(<r) r/|r|³        U = -m G ∫ᵣ^∞ M(<s)/s² ds
//
//   m  mass, kg    G  gravitational constant, m³/(kg s²)    M(<r)  mass within r, kg    r  from the centre, m
//
// The density is uniform within the first radius, M is linear in r between radii, and constant beyond the last
// radius. Shells outside r exert no force (Newton, Principia I, propositions 70 and 71). Valid for spherical
// symmetry. Cost: a square root, a division and 17 more operations per body, and six per radius: M is the sum over
// all shells of the mass within r, so that no body searches the table. The table takes 32 bytes per radius of the
// memory of each world that uses it, until it leaves `world.forces`.
import { PhysicsError } from '../errors/physics-error.ts';
import { checkKeys, checkList, checkNumber } from '../errors/validate.ts';
import { constant, type Scalar, select } from '../laws/expression.ts';
import { scalar, suppliedScalar } from '../laws/parameter.ts';
import { table } from '../laws/table.ts';
import { forceMemory } from '../memory/force-memory.ts';
import type { Force } from '../world/types.ts';
import { LENGTH_BOUNDS, NOT_NEGATIVE, POSITIVE } from './support/bounds.ts';
import { CENTRE_KEYS, type CentralLaw, type CentreOptions, centralForce } from './support/central-force.ts';

/** Newton's constant of gravitation, m³/(kg s²): CODATA 2022. */
export const GRAVITATIONAL_CONSTANT = 6.6743e-11;

/** Options of `enclosedMassGravity`. */
export interface EnclosedMassOptions extends CentreOptions {
  /** Radii, m: positive and strictly increasing. */
  readonly radii: readonly number[];
  /** Mass within each radius, kg: not decreasing. */
  readonly masses: readonly number[];
  /** G, m³/(kg s²); default Newton's. */
  readonly gravitationalConstant?: number;
}

/** A shell between two radii, m: its mass, kg, and its mass per radius, kg/m. */
const SHELL = ['inner', 'outer', 'mass', 'perMetre'] as const;
type Shell = Readonly<Record<(typeof SHELL)[number], Scalar>>;

/**
 * Gravity of a spherical cloud from the mass within each radius: F = -m G M(<r) r/|r|³, N, on every body with mass
 * (the shell theorem).
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN; E_CAPACITY from a step, when the world has no room
 */
export function enclosedMassGravity(options: EnclosedMassOptions): Force {
  checkKeys(options, 'enclosedMassGravity', ['radii', 'masses', 'gravitationalConstant', ...CENTRE_KEYS]);
  const { radii, masses, ...given } = options;
  checkProfile(radii, masses);
  return centralForce(lawOf([...radii], [...masses]), 'Mass', given);
}

function lawOf(radii: readonly number[], masses: readonly number[]) {
  const shells = Float64Array.from(
    radii.slice(1).flatMap((outer, i) => {
      const mass = masses[i + 1] - masses[i];
      return [radii[i], outer, mass, mass / (outer - radii[i])];
    }),
  );
  const { of: shellsAt, release } = forceMemory((world, take) => {
    const at = take(shells.byteLength, 'a mass profile');
    new Float64Array(world.memory.buffer, at, shells.length).set(shells);
    return { at, count: shells.length / SHELL.length };
  });
  const parameters = {
    gravitationalConstant: scalar('m³/(kg s²)', { default: GRAVITATIONAL_CONSTANT, ...POSITIVE }),
    coreRadius: suppliedScalar(() => radii[0]),
    coreMass: suppliedScalar(() => masses[0]),
    shells: table(SHELL, shellsAt),
  };
  const law: CentralLaw<typeof parameters> = {
    name: 'enclosed mass gravity',
    formula: 'F = -m G M(<r) r / |r|³',
    source: 'Newton, Principia (1687), book I, propositions 70 and 71.',
    parameters,
    field(r, { gravitationalConstant, coreRadius, coreMass, shells: rows }) {
      const distance = r.length();
      const mass = coreMass.add(rows.sum((shell) => massWithin(distance, shell)));
      // Within the core the field is that at its surface times r/R.
      const inverse = constant(1).div(distance.max(coreRadius));
      return r.mul(inverse).mul(gravitationalConstant.mul(mass).mul(inverse).mul(inverse)).negate();
    },
    energy(r, { gravitationalConstant, coreRadius, coreMass, shells: rows }) {
      const distance = r.length();
      const relative = distance.div(coreRadius);
      const inside = constant(3).sub(relative.square()).div(2).div(coreRadius);
      const ofCore = coreMass.mul(select(relative.less(1), inside, constant(1).div(distance)));
      return gravitationalConstant.mul(ofCore.add(rows.sum((shell) => energyOf(distance, shell)))).negate();
    },
    prepare: (world) => void shellsAt(world),
    releaseMemory: release,
  };
  return law;
}

/** Returns the mass of a shell within a distance, kg: exactly the whole mass from its outer radius on. */
function massWithin(distance: Scalar, { inner, outer, mass, perMetre }: Shell): Scalar {
  const massInside = perMetre.mul(distance.sub(inner));
  return select(distance.less(outer), massInside.max(0), mass);
}

/**
 * Returns ∫ᵣ^∞ M(s)/s² ds of a shell, kg/m: M/r beyond its outer radius, and within it the exact integral of a
 * linear M.
 */
function energyOf(distance: Scalar, { inner, outer, mass, perMetre }: Shell): Scalar {
  const clamped = distance.max(inner).min(outer);
  const between = outer.div(clamped).log().sub(inner.div(clamped)).add(inner.div(outer));
  return mass.div(distance.max(outer)).add(perMetre.mul(between));
}

function checkProfile(radii: readonly number[], masses: readonly number[]): void {
  checkList(radii, 'enclosedMassGravity.radii');
  checkList(masses, 'enclosedMassGravity.masses');
  const count = radii?.length ?? 0;
  if (count === 0 || masses?.length !== count) {
    throw new PhysicsError(
      'E_RANGE',
      `enclosedMassGravity has ${count} radii and ${masses?.length ?? 0} masses. Give equal numbers, at least one of each.`,
      {
        field: 'masses',
        value: masses,
      },
    );
  }
  for (let i = 0; i < count; i++) {
    const [minRadius, minMass] = i === 0 ? [0, 0] : [radii[i - 1], masses[i - 1]];
    checkNumber(radii[i], `enclosedMassGravity.radii[${i}]`, { ...LENGTH_BOUNDS, above: minRadius });
    checkNumber(masses[i], `enclosedMassGravity.masses[${i}]`, { ...NOT_NEGATIVE, min: minMass });
  }
}
