// Fixed centres of Newtonian attraction: every entity with Attractor and Position pulls all bodies with mass.
//
//   F = -m μ r / (r² + ε²)^(3/2)        potential  U = -m μ / √(r² + ε²)
//
//   m  mass, kg     μ = G M  gravitational parameter, m³/s²     r  from the centre to the body, m     ε  softening, m
//
// With a speed of light c every centre is a black hole with the horizon r_s = 2 μ/c², as in `paczynskiWiita`:
//
//   F = -m μ r / (s (s - r_s)²)        potential  U = -m μ/(s - r_s)        s = √(r² + ε²), both zero for s ≤ r_s
//
// Newton (1687); Plummer's softening (1911), as in Dehnen and Read, Eur. Phys. J. Plus 126, 55 (2011), section 2.2;
// Paczyński and Wiita, Astronomy and Astrophysics 88, 23 (1980).
// Valid outside the attracting sphere, or anywhere for ε of its size. In the centre itself (r = 0) the pull is zero,
// with softening or without: never NaN. A centre is not pulled, not by others and not, when it has mass, by itself.
// A centre that moves is taken to go on at its velocity during the step, so that the force reads nothing but its own
// body and the step runs in tiles. Cost: a square root, a division and 14 more operations a body and centre.
import { bitOf } from '../components/all';
import { reportFault } from '../faults/fault-log';
import { checkKeys, checkNumber } from '../faults/validate';
import { resource } from '../store/resource';
import { emptyRoster, type Roster, refreshRoster } from '../store/roster';
import type { PhysicsWorld } from '../world';
import type { Force } from './force';

/** Slower light than a millimetre a second would make horizons of whole worlds. */
const LIGHT_SPEEDS = { min: 1e-3, max: 1e12 };

/** Bytes of one centre, kernels/forces/attractors.ts. */
const CENTRE_BYTES = 80;

const centresOf = resource(emptyRoster);

export interface AttractorsOptions {
  /** Makes black holes of the centres: a speed of light c, m/s. Left out, the pull is Newton's. */
  readonly lightSpeed?: number;
}

/** Attraction by all entities with `Attractor`. @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function attractors(options: AttractorsOptions = {}): Force {
  checkKeys(options, 'attractors', ['lightSpeed']);
  const { lightSpeed } = options;
  if (lightSpeed !== undefined) checkNumber(lightSpeed, 'attractors.lightSpeed', LIGHT_SPEEDS);
  const horizonPerMu = lightSpeed === undefined ? 0 : 2 / (lightSpeed * lightSpeed);
  return {
    name: 'attractors',
    equation: horizonPerMu === 0 ? 'F = -m μ r / (r² + ε²)^(3/2)' : 'F = -m μ r / (s (s - r_s)²)',
    ...(lightSpeed === undefined ? {} : { parameters: { lightSpeed: { unit: 'm/s', value: lightSpeed } } }),
    reads: ['Position', 'Mass'],
    local: true,
    prepare(world) {
      gather(world, horizonPerMu);
    },
    accumulate(world, first, last, time) {
      const { at, count } = centresOf(world);
      if (count === 0) return;
      const { x, y, z } = world.scratch.at.force;
      const lead = time - world.time;
      if (world.dimensions === 2) world.kernels.attract2d(x, y, at, count, lead, first, last);
      else world.kernels.attract3d(x, y, z, at, count, lead, first, last);
    },
    potential(world) {
      const { at, count } = gather(world, horizonPerMu);
      return world.kernels.attractorPotential(at, count, 0, world.lastId + 1);
    },
  };
}

/** Lists the centres anew when entities changed, and copies where they are now. */
function gather(world: PhysicsWorld, horizonPerMu: number): Roster {
  const centres = centresOf(world);
  refreshRoster(world, centres, 'Attractor', CENTRE_BYTES, bitOf('Attractor') | bitOf('Position'));
  const { ids, at, count } = centres;
  const { mu, softening } = world.addresses.Attractor;
  const bad = world.kernels.gatherAttractors(ids, count, mu, softening, horizonPerMu, at);
  if (bad > 0) repair(world, centres);
  return centres;
}

/** Coefficients that somebody made NaN or infinite become 0, with a fault; poses are put right when the step begins. */
function repair(world: PhysicsWorld, { ids, count }: Roster): void {
  const { Attractor } = world.components;
  for (const entity of new Uint32Array(world.memory.buffer, ids, count)) {
    for (const field of ['mu', 'softening'] as const) {
      const value = Attractor[field][entity];
      if (Number.isFinite(value)) continue;
      Attractor[field][entity] = 0;
      reportFault(world, { code: 'E_NONFINITE', entity, field: `Attractor.${field}`, value, phase: 'begin' });
    }
  }
}
