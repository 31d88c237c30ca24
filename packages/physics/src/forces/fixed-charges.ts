// The Coulomb force of fixed charges: every body with Charge and no Mass acts on every body with Charge and Mass.
//
//   F = k q Q r/|r|³        potential  U = k q Q/|r|
//
//   q, Q  charges, C    k = 1/(4π ε₀)  Coulomb constant, N m²/C²    r  from the source to the body, m
//
// Coulomb (1785). Like charges repel. A source acts outside its collider's radius only; inside, the potential is that at
// the surface, as in a hollow conductor. Valid for sources at rest: their fields do not lag behind and are not magnetic.
// The pull of mobile charges on each other is in `mutualCoulomb`, which takes fixed ones along. Cost: a square root, a division and some 15 operations a
// body and source.
import { bitOf } from '../components/all';
import { reportFault } from '../faults/fault-log';
import { checkNumber } from '../faults/validate';
import { resource } from '../store/resource';
import { emptyRoster, type Roster, refreshRoster } from '../store/roster';
import type { PhysicsWorld } from '../world';
import { POSITIVE } from './bounds';
import type { Force } from './force';
import { lawKernels } from './law-kernels';

/** 1/(4π ε₀), N m²/C²: CODATA 2022. */
export const COULOMB_CONSTANT = 8.9875517862e9;

/** Bytes of one source, kernels/forces/electromagnetic.ts. */
const SOURCE_BYTES = 40;

interface Sources extends Roster {
  /** How many of those listed have no mass. */
  fixed: number;
}

/**
 * @param constant k, N m²/C²
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE
 */
export function fixedCharges(constant: number = COULOMB_CONSTANT): Force {
  const k = checkNumber(constant, 'fixedCharges', POSITIVE);
  const sourcesOf = resource((): Sources => ({ fixed: 0, ...emptyRoster() }));
  return {
    name: 'fixed charges',
    equation: 'F = k q Q r / |r|³',
    parameters: { constant: { unit: 'N m²/C²', value: k } },
    reads: ['Position', 'Charge', 'Mass'],
    local: true,
    timeless: true,
    prepare(world) {
      gather(world, sourcesOf(world), k);
    },
    accumulate(world, first, last) {
      const { at, fixed } = sourcesOf(world);
      const { x, y, z } = world.scratch.at.force;
      lawKernels(world).coulombForce(x, y, z, world.addresses.Charge.value, at, fixed, first, last);
    },
    potential(world) {
      const { at, fixed } = gather(world, sourcesOf(world), k);
      return lawKernels(world).coulombPotential(world.addresses.Charge.value, at, fixed, world.lastId + 1);
    },
  };
}

/** Lists the charges anew when entities changed, and copies those without mass as they are now. */
function gather(world: PhysicsWorld, sources: Sources, k: number): Sources {
  refreshRoster(world, sources, 'Charge', SOURCE_BYTES, bitOf('Charge') | bitOf('Position'));
  const charge = world.addresses.Charge.value;
  const count = lawKernels(world).gatherCharges(sources.ids, sources.count, charge, k, sources.at);
  sources.fixed = count < 0 ? -1 - count : count;
  if (count < 0) repair(world, sources);
  return sources;
}

/** The charge of a source that somebody made NaN or infinite becomes 0, with a fault. */
function repair(world: PhysicsWorld, { ids, count }: Sources): void {
  const { Charge, Mass } = world.components;
  for (const entity of new Uint32Array(world.memory.buffer, ids, count)) {
    const value = Charge.value[entity];
    if (Mass.value[entity] !== 0 || Number.isFinite(value)) continue;
    Charge.value[entity] = 0;
    reportFault(world, { code: 'E_NONFINITE', entity, field: 'Charge.value', value, phase: 'begin' });
  }
}
