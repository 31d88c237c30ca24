// Fixed centres of Newtonian attraction: every entity with Attractor and Position pulls all bodies with mass.
//
//   F = -m μ r / (r² + ε²)^(3/2)        potential  U = -m μ / √(r² + ε²)
//
//   m  mass, kg     μ = G M  gravitational parameter, m³/s²     r  from the centre to the body, m     ε  softening, m
//
// Newton (1687); Plummer's softening (1911), as in Dehnen and Read, Eur. Phys. J. Plus 126, 55 (2011), section 2.2.
// Valid outside the attracting sphere, or anywhere for ε of its size. In the centre itself (r = 0) the pull is zero,
// with softening or without: never NaN. A centre is not pulled, not by others and not, when it has mass, by itself.
// A centre that moves is taken to go on at its velocity during the step, so that the force reads nothing but its own
// body and the step runs in tiles. Cost: a square root, a division and 14 more operations a body and centre.
import { bitOf } from '../components/all';
import { reportFault } from '../faults/fault-log';
import { allocate } from '../store/arena';
import { resource } from '../store/resource';
import type { PhysicsWorld } from '../world';
import type { Force } from './force';

/** Bytes of one centre, kernels/forces/attractors.ts. */
const CENTRE_BYTES = 72;

interface Centres {
  ids: number;
  at: number;
  room: number;
  count: number;
  version: number;
}

const centresOf = resource((): Centres => ({ ids: 0, at: 0, room: 0, count: 0, version: -1 }));

/** Attraction by all entities with `Attractor`. */
export function attractors(): Force {
  return {
    name: 'attractors',
    equation: 'F = -m μ r / (r² + ε²)^(3/2)',
    reads: ['Position', 'Mass'],
    local: true,
    prepare(world) {
      gather(world);
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
      const { at, count } = gather(world);
      return world.kernels.attractorPotential(at, count, 0, world.lastId + 1);
    },
  };
}

/** Lists the centres anew when entities changed, and copies where they are now. */
function gather(world: PhysicsWorld): Centres {
  const centres = centresOf(world);
  const { kernels, internal, versions, addresses } = world;
  if (centres.version !== versions.membership) {
    makeRoom(world, centres);
    const wanted = bitOf('Attractor') | bitOf('Position');
    const none = internal.counts.Attractor === 0;
    centres.count = none ? 0 : kernels.listIds(internal.membersAt, wanted, world.lastId + 1, centres.ids);
    centres.version = versions.membership;
  }
  const { mu, softening } = addresses.Attractor;
  const bad = kernels.gatherAttractors(centres.ids, centres.count, mu, softening, centres.at);
  if (bad > 0) repair(world, centres);
  return centres;
}

/** Coefficients that somebody made NaN or infinite become 0, with a fault; poses are put right when the step begins. */
function repair(world: PhysicsWorld, { ids, count }: Centres): void {
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

function makeRoom(world: PhysicsWorld, centres: Centres): void {
  const { arena, counts } = world.internal;
  if (counts.Attractor <= centres.room) return;
  centres.room = Math.max(16, 2 * counts.Attractor);
  centres.ids = allocate(arena, centres.room * 4, 'attractors');
  centres.at = allocate(arena, centres.room * CENTRE_BYTES, 'attractors');
}
