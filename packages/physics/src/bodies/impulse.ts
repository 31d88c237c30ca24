// Impulses: instantaneous changes of velocity.
//
//   Δv = J/m        Δω = (p - r) × J/I        explosion: J(d) = J₀ (1 - d/R)ⁿ outwards, d < R
//
//   J  impulse, N s    p  point of application, m    r  centre of mass, m    d  distance from the explosion, m
//
// An impulse is the limit of a large force for a short time: Goldstein, Classical Mechanics, section 1.1. The law of
// the explosion is a game model, not the blast wave of Sedov (1946).

import { bitOf } from '../components/membership.ts';
import { rotationKernels } from '../dynamics/rotation-kernels.ts';
import { assertUsable } from '../ecs/guards.ts';
import { isOpen } from '../ecs/rows.ts';
import { checkKeys, checkNumber, checkVector, checkWhole, type VectorInput } from '../errors/validate.ts';
import { ANY, LENGTH_BOUNDS, POSITION_BOUNDS } from '../forces/support/bounds.ts';
import { forceKernels } from '../forces/support/force-kernels.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { bodyOf } from './parts.ts';

/**
 * Applies an impulse through the centre of mass of a body or at a point, which also changes the spin of a body with
 * Inertia or an InertiaTensor, and AngularVelocity. Of a part it acts on its body. A body that is kinematic or without mass is
 * not moved.
 * @param impulse N s
 * @param point point of application, m, in world coordinates
 * @throws PhysicsError E_STALE, E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN, E_DESTROYED
 */
export function applyImpulse(world: PhysicsWorld, id: number, impulse: VectorInput, point?: VectorInput): void {
  const eid = bodyOf(world, id);
  const j = checkVector(impulse, 'impulse', ANY);
  const p = point === undefined ? undefined : checkVector(point, 'point', POSITION_BOUNDS);
  const { Mass, Velocity: v, Position, Inertia, AngularVelocity: w } = world.components;
  const mass = Mass.value[eid];
  if (!(mass > 0) || isOpen(world, eid, 'Kinematic')) return;
  const solid = world.dimensions === 3;
  v.x[eid] += j.x / mass;
  v.y[eid] += j.y / mass;
  if (solid) v.z[eid] += j.z / mass;
  if (p === undefined || !isOpen(world, eid, 'AngularVelocity')) return;
  const x = p.x - Position.x[eid];
  const y = p.y - Position.y[eid];
  const z = solid ? p.z - Position.z[eid] : 0;
  if (solid && isOpen(world, eid, 'InertiaTensor') && isOpen(world, eid, 'Orientation')) {
    rotationKernels(world).kickTensor(eid, y * j.z - z * j.y, z * j.x - x * j.z, x * j.y - y * j.x);
    return;
  }
  const inertia = Inertia.value[eid];
  if (!(inertia > 0)) return;
  w.z[eid] += (x * j.y - y * j.x) / inertia;
  if (!solid) return;
  w.x[eid] += (y * j.z - z * j.y) / inertia;
  w.y[eid] += (z * j.x - x * j.z) / inertia;
}

export interface ExplosionOptions {
  /** Position, m; default the origin. */
  readonly centre?: VectorInput;
  /** Impulse J₀ at the centre, N s; negative implodes. */
  readonly impulse: number;
  /** Radius R, m. */
  readonly radius: number;
  /** Exponent n: 0 is uniform within R, 1 (default) falls linearly to zero at R, 2 and above fall more steeply. */
  readonly falloff?: number;
}

/**
 * Accelerates every body with mass within the radius outwards, unless it is kinematic. A body exactly at the centre has no
 * direction and is not moved.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN, E_DESTROYED
 */
export function explode(world: PhysicsWorld, options: ExplosionOptions): void {
  assertUsable(world);
  checkKeys(options, 'explode', ['centre', 'impulse', 'radius', 'falloff']);
  const { x, y, z } = checkVector(options.centre ?? {}, 'explode.centre', POSITION_BOUNDS);
  const impulse = checkNumber(options.impulse, 'explode.impulse', ANY);
  const radius = checkNumber(options.radius, 'explode.radius', LENGTH_BOUNDS);
  const falloff = checkWhole(options.falloff ?? 1, 'explode.falloff', 0, 16);
  const depth = world.dimensions === 3 ? z : 0;
  forceKernels(world).blast(x, y, depth, impulse, radius, falloff, bitOf('Kinematic'), world.lastId + 1);
}
