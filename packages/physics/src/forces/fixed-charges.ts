// The Coulomb force of fixed charges: every body with Charge but no Mass acts on every body with Charge and Mass.
//
//   F = k q Q r/|r|³        potential  U = k q Q/|r|
//
//   q, Q  charges, C    k = 1/(4π ε₀)  Coulomb constant, N m²/C²    r  from the source to the body, m
//
// Coulomb (1785). Like charges repel. A source acts only outside its collider's radius; inside, the potential is that
// at the surface, as in a hollow conductor. Valid for sources at rest: no retardation and no magnetic field. The
// force between mobile charges is `mutualCoulomb`, which includes fixed ones. Cost: a square root, a division and
// about 20 operations per body and source.

import { Charge } from '../components/charge.ts';
import { bitOf } from '../components/membership.ts';
import { defineLaw } from '../dynamics/define-law.ts';
import { type EntityList, emptyEntityList, refreshEntityList } from '../ecs/entity-list.ts';
import { reportFault } from '../errors/report-fault.ts';
import { type Scalar, select, type Vector, vec3 } from '../laws/expression.ts';
import { scalar } from '../laws/parameter.ts';
import { type TableLocation, table } from '../laws/table.ts';
import { SOURCE_BYTES, SOURCE_FIELDS } from '../memory/layouts.gen.ts';
import { namedResource } from '../memory/resource.ts';
import type { Force, PhysicsWorld } from '../world/types.ts';
import { POSITIVE } from './support/bounds.ts';
import { inverseWhere } from './support/central-force.ts';
import { forceKernels } from './support/force-kernels.ts';

/** 1/(4π ε₀), N m²/C²: CODATA 2022. */
export const COULOMB_CONSTANT = 8.9875517862e9;

/** A source at the start of the step, kernels/forces/charges.ts: position, charge and radius. */
type Source = Readonly<Record<(typeof SOURCE_FIELDS)[number], Scalar>>;

interface Sources extends EntityList {
  /** The listed charges without mass. */
  readonly fixed: { at: number; count: number };
}

const sourcesOf = namedResource('fixed charges', (): Sources => ({ fixed: { at: 0, count: 0 }, ...emptyEntityList() }));

const law = /* @__PURE__ */ defineLaw({
  name: 'fixed charges',
  formula: 'F = k q Q r / |r|³',
  source: 'Coulomb, Histoire de l’Académie Royale des Sciences, 569 (1785).',
  reads: { charge: Charge },
  parameters: { constant: scalar('N m²/C²', POSITIVE), sources: table(SOURCE_FIELDS, sourcesAtStart) },
  force: ({ position, charge }, { constant, sources }) =>
    sources.sum((source) => fieldOf(source, position, constant)).mul(charge),
  potential: ({ position, charge }, { constant, sources }) =>
    sources.sum((source) => voltageOf(source, position, constant)).mul(charge),
  prepare: (world) => void gather(world),
});

/**
 * The Coulomb force of every body with charge and without mass on those with both: F = k q Q r/|r|³, N. Like charges
 * repel.
 *
 * @param constant k, N m²/C²; default 8.9875517862e9, that of the vacuum
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE
 */
export function fixedCharges(constant: number = COULOMB_CONSTANT): Force {
  return law({ constant });
}

/** Multiplies magnitude and direction separately, which stay in the range of f32 where r³ does not. */
function fieldOf({ x, y, z, charge, radius }: Source, position: Vector, constant: Scalar): Vector {
  const r = position.sub(vec3(x, y, z));
  const distance = r.length();
  const inverse = inverseWhere(distance.greater(radius).and(distance.greater(0)), distance);
  return r.mul(inverse).mul(charge.mul(constant).mul(inverse).mul(inverse));
}

/** Returns the potential; inside a source its value at the surface. */
function voltageOf({ x, y, z, charge, radius }: Source, position: Vector, constant: Scalar): Scalar {
  const distance = position
    .sub(vec3(x, y, z))
    .length()
    .max(radius);
  return select(distance.greater(0), charge.mul(constant).div(distance), 0);
}

/** Returns the sources at the start of the step; outside a step the current ones. */
function sourcesAtStart(world: PhysicsWorld): TableLocation {
  return world.state === 'stepping' ? sourcesOf(world).fixed : gather(world);
}

/** Lists the charges if entities changed, and copies the current state of those without mass. */
function gather(world: PhysicsWorld): TableLocation {
  const sources = sourcesOf(world);
  refreshEntityList(world, sources, 'Charge', SOURCE_BYTES, bitOf('Charge') | bitOf('Position'));
  const { fixed, ids, at } = sources;
  const count = forceKernels(world).gatherCharges(ids, sources.count, world.addresses.Charge.value, at);
  fixed.at = at;
  fixed.count = count < 0 ? -1 - count : count;
  if (count < 0) repair(world, sources);
  return fixed;
}

/** Sets a non-finite charge of a source to 0 and reports a fault. */
function repair(world: PhysicsWorld, { ids, count }: Sources): void {
  const { Charge: charges, Mass } = world.components;
  for (const entity of new Uint32Array(world.memory.buffer, ids, count)) {
    const value = charges.value[entity];
    if (Mass.value[entity] !== 0 || Number.isFinite(value)) continue;
    charges.value[entity] = 0;
    reportFault(world, { code: 'E_NONFINITE', entity, field: 'Charge.value', value, phase: 'begin' });
  }
}
