// The Wisdom-Holman map for planetary systems: one body dominates, and all others move on perturbed Kepler orbits
// about it.
//
//   H = Σ Kepler(Jacobi coordinates) + interaction        step: drift dt/2, kick dt, drift dt/2
//
// The drift follows the Kepler orbits exactly (universal variables, kernels/integrators/kepler.ts: ellipses and
// hyperbolas alike); the kick contains all remaining forces of the world, which must include the attraction of all
// pairs, and may include corrections such as `postNewtonian`. Second order; the error is that of leapfrog times the
// mass ratio of planets to star, so a twentieth of the shortest period suffices as step. Symplectic and reversible
// for forces that depend only on position: energy errors stay bounded for ever. Not for close encounters between
// planets. One force evaluation.
//
// Jacobi coordinates measure each body from the centre of mass of the star and of the bodies before it: create the bodies
// by increasing distance; moons are not supported. The star comes first wherever it was created. The order is that of the
// entities and is not changed in a run, where that would break the map. Test particles are measured in the same way, and
// count in no centre. Bodies without mass do not move, so that test particles need one, of any size. A body whose orbit
// passes through the centre of the star stays, and an E_STEP is reported.
//
// Wisdom and Holman, Astron. J. 102, 1528 (1991); Rein and Tamayo, MNRAS 452, 376 (2015).

import { bitOf } from '../components/membership.ts';
import { emptyEntityList, refreshEntityList } from '../ecs/entity-list.ts';
import { checkKeys, checkNumber } from '../errors/validate.ts';
import { GRAVITATIONAL_CONSTANT } from '../forces/enclosed-mass-gravity.ts';
import { PLANET_BYTES } from '../memory/layouts.gen.ts';
import { namedResource } from '../memory/resource.ts';
import type { Integrator, PhysicsWorld } from '../world/types.ts';
import { integratorKernels } from './support/integrator-kernels.ts';
import { reportUnderflow } from './support/sub-steps.ts';

/** The gravity of the Kepler orbits. */
export interface WisdomHolmanOptions {
  /** Gravitational constant, as in the world's gravity; default 6.6743e-11 m³/(kg s²). */
  readonly G?: number;
  /** The dominant body; default the one with the largest mass that is no test particle. */
  readonly central?: number;
}

const planetsOf = namedResource('planets', emptyEntityList);

/**
 * Planets on Kepler orbits about a star, which `mutualGravity` of the same G disturbs. Create the planets by increasing distance
 * from the star: each moves about the common centre of those before it, and another order makes the error up to a hundred times as
 * large. Test particles move about the centre of those before them, and are in no centre themselves. Moons are not supported.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function wisdomHolman(options: WisdomHolmanOptions = {}): Integrator {
  checkKeys(options, 'wisdomHolman', ['G', 'central']);
  const G = checkNumber(options.G ?? GRAVITATIONAL_CONSTANT, 'G', { above: 0, max: 1e30 });
  const central = checkNumber(options.central ?? 0, 'central', { min: 0, integer: true });
  return {
    name: 'Wisdom-Holman',
    parameters: { G: { unit: 'm³/(kg s²)', value: G } },
    order: 2,
    symplectic: true,
    evaluations: 1,
    wholeWorld: true,
    // A step has one kick, so that a drag may take at most twice the velocity in it.
    isStable: (_, damping) => damping <= 2,
    prepare: list,
    advance(world, ranges, dt, evaluateForces) {
      const { at } = planetsOf(world);
      const star = centralBody(world, central);
      if (star === 0) return;
      const kernels = integratorKernels(world);
      const { force } = world.scratch.at;
      const n = gather(world, star, G);
      kernels.toJacobi(at, n);
      const failedRow = kernels.driftKepler(at, n, dt / 2);
      kernels.fromJacobi(at, n);
      evaluateForces(world, ranges, world.time + dt / 2);
      kernels.kickJacobi(at, n, force.x, force.y, world.dimensions === 3 ? force.z : 0, dt);
      const laterFailedRow = kernels.driftKepler(at, n, dt / 2);
      kernels.fromJacobi(at, n);
      if (failedRow + laterFailedRow > 0) reportUnderflow(world, failedRow > 0 ? failedRow : laterFailedRow, dt / 2);
    },
  };
}

/** The named body if it can be the star, else the heaviest source, among test particles alone the heaviest; 0 if there is none. */
function centralBody(world: PhysicsWorld, named: number): number {
  if (isMassive(world, named) && !isTest(world, named)) return named;
  const { value } = world.components.Mass;
  const { ids, count } = world.internal.bodyList;
  let [source, any] = [0, 0];
  for (let i = 0; i < count; i++) {
    const id = ids[i];
    if (value[id] > value[any]) any = id;
    if (value[id] > value[source] && !isTest(world, id)) source = id;
  }
  return source > 0 ? source : any;
}

function isMassive({ components, internal, rows }: PhysicsWorld, entity: number): boolean {
  const required = bitOf('Position') | bitOf('Mass');
  return (
    entity > 0 &&
    entity < rows &&
    (internal.members[entity] & required) === required &&
    components.Mass.value[entity] > 0
  );
}

function isTest({ internal }: PhysicsWorld, entity: number): boolean {
  return (internal.members[entity] & bitOf('TestParticle')) !== 0;
}

/** Lists the bodies with mass. @throws PhysicsError E_CAPACITY */
function list(world: PhysicsWorld): void {
  refreshEntityList(world, planetsOf(world), 'Position', PLANET_BYTES, bitOf('Position') | bitOf('Mass'));
}

/** Gathers the bodies, the star first; returns their number. */
function gather(world: PhysicsWorld, star: number, G: number): number {
  const { at, ids, count } = planetsOf(world);
  return integratorKernels(world).gatherPlanets(at, ids, count, star, bitOf('TestParticle'), G);
}
