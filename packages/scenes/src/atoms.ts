/** Atoms that attract each other at a distance and repel each other when near, in units of their diameter, mass and well. */
import { defineForce, type Force, type PhysicsWorld, pairsWithin } from '@principia/physics';

/** Atoms further apart than this do not act on each other, in diameters. */
export const CUTOFF = 2.5;

/** 4 (r⁻¹² − r⁻⁶), from the square of the distance. */
function energyAt(square: number): number {
  const inverse = 1 / (square * square * square);
  return 4 * inverse * (inverse - 1);
}

/** What is taken off, so that the energy is 0 at the cutoff. */
const SHIFT = energyAt(CUTOFF * CUTOFF);

/**
 * The force between all pairs: U = 4 (r⁻¹² − r⁻⁶), F = 24 (2 r⁻¹² − r⁻⁶)/r. Lennard-Jones, Proc. Phys. Soc. 43, 461 (1931).
 * What is equal and opposite leaves the momentum as it is.
 */
export function betweenAtoms(): Force {
  return defineForce({
    name: 'Lennard-Jones force between atoms',
    equation: 'F = 24 (2 r⁻¹² − r⁻⁶)/r',
    reads: ['Position', 'Mass'],
    readsOfOthers: [],
    local: false,
    accumulate(world) {
      const { x, y, z } = world.components.Position;
      const { force } = world.scratch;
      const isSpace = world.dimensions === 3;
      const { count, a, b } = pairsWithin(world, CUTOFF);
      for (let i = 0; i < count; i++) {
        const dx = x[b[i]] - x[a[i]];
        const dy = y[b[i]] - y[a[i]];
        const dz = isSpace ? z[b[i]] - z[a[i]] : 0;
        const square = dx * dx + dy * dy + dz * dz;
        const inverse = 1 / (square * square * square);
        const push = (24 * inverse * (2 * inverse - 1)) / square;
        force.x[a[i]] -= push * dx;
        force.y[a[i]] -= push * dy;
        force.x[b[i]] += push * dx;
        force.y[b[i]] += push * dy;
        if (!isSpace) continue;
        force.z[a[i]] -= push * dz;
        force.z[b[i]] += push * dz;
      }
    },
    potential: (world) => distancesOf(world).reduce((sum, r) => sum + energyAt(r * r) - SHIFT, 0),
  });
}

/** The distances of all pairs up to the cutoff, or another distance. */
export function distancesOf(world: PhysicsWorld, limit = CUTOFF): number[] {
  const { x, y, z } = world.components.Position;
  const { count, a, b } = pairsWithin(world, limit);
  return Array.from({ length: count }, (_, i) => {
    const dx = x[b[i]] - x[a[i]];
    const dy = y[b[i]] - y[a[i]];
    const dz = world.dimensions === 3 ? z[b[i]] - z[a[i]] : 0;
    return Math.sqrt(dx * dx + dy * dy + dz * dz);
  });
}
