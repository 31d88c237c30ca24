// Explosions: an impulse on each body outwards, weaker with the distance.
//
//   J(d) = J₀ (1 - d/R)ⁿ,  d < R
//
//   J  impulse, N s    d  distance from the centre, m    R  radius, m
//
// A game model, not the blast wave of Sedov (1946).

import { BITS_HINT } from '../components/collider.ts';
import { assertUsable } from '../ecs/guards.ts';
import { isOpen } from '../ecs/rows.ts';
import { checkKeys, checkNumber, checkPoint, checkWhole, type VectorInput } from '../errors/validate.ts';
import { ANY, LENGTH_BOUNDS, POSITION_BOUNDS } from '../forces/support/bounds.ts';
import { pow } from '../math/elementary.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** Options of `explode`. */
export interface ExplosionOptions {
  /** Position, m; default the origin. */
  readonly centre?: VectorInput;
  /** Impulse J₀ at the centre, N s; negative implodes. */
  readonly impulse: number;
  /** Radius R, m. */
  readonly radius: number;
  /** Exponent n, 0 to 16: 0 is uniform within R, 1 (default) falls linearly to zero at R, above 1 it falls more steeply. */
  readonly falloff?: number;
  /** Layers, one bit each: bodies that are on none of them are left out. What has no collider is on all. Default all. */
  readonly mask?: number;
}

/**
 * Accelerates every body with mass within the radius outwards, unless it is kinematic. A body exactly at the centre has no
 * direction and is not moved.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN, E_DESTROYED
 */
export function explode(world: PhysicsWorld, options: ExplosionOptions): void {
  assertUsable(world);
  checkKeys(options, 'explode', ['centre', 'impulse', 'radius', 'falloff', 'mask']);
  const centre = checkPoint(options.centre ?? {}, 'explode.centre', POSITION_BOUNDS);
  const impulse = checkNumber(options.impulse, 'explode.impulse', ANY);
  const radius = checkNumber(options.radius, 'explode.radius', LENGTH_BOUNDS);
  const falloff = checkNumber(options.falloff ?? 1, 'explode.falloff', { min: 0, max: 16 });
  const mask = checkWhole(options.mask ?? 0xffffffff, 'explode.mask', 0, 0xffffffff, BITS_HINT);
  const { Mass, Position, Velocity: v } = world.components;
  const isSolid = world.dimensions === 3;
  for (let id = 1; id <= world.lastId; id++) {
    const mass = Mass.value[id];
    if (!(mass > 0) || isOpen(world, id, 'Kinematic') || !isOnLayer(world, id, mask)) continue;
    const x = Position.x[id] - centre.x;
    const y = Position.y[id] - centre.y;
    const z = isSolid ? Position.z[id] - centre.z : 0;
    const d = Math.sqrt(x * x + y * y + z * z);
    if (!(d > 0) || d >= radius) continue;
    let factor = impulse / (mass * d);
    // Whole exponents are products, without the rounding of a power.
    const whole = Math.floor(falloff);
    for (let i = 0; i < whole; i++) factor *= 1 - d / radius;
    if (falloff > whole) factor *= pow(1 - d / radius, falloff - whole);
    v.x[id] += factor * x;
    v.y[id] += factor * y;
    if (isSolid) v.z[id] += factor * z;
  }
}

function isOnLayer(world: PhysicsWorld, id: number, mask: number): boolean {
  return !isOpen(world, id, 'Collider') || (world.components.Collider.layers[id] & mask) !== 0;
}
