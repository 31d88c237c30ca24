// Impulses: instantaneous changes of velocity.
//
//   Δv = J/m        Δω = (p - r) × J/I
//
//   J  impulse, N s    p  point of application, m    r  centre of mass, m
//
// An impulse is the limit of a large force for a short time: Goldstein, Classical Mechanics, section 1.1.

import { warnAboutImpulse } from '#warnings';
import { rotationKernels } from '../dynamics/rotation-kernels.ts';
import { isOpen } from '../ecs/rows.ts';
import { checkPoint, checkVector, type VectorInput } from '../errors/validate.ts';
import { ANY, POSITION_BOUNDS } from '../forces/support/bounds.ts';
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
  const p = point === undefined ? undefined : checkPoint(point, 'point', POSITION_BOUNDS);
  const { Mass, Velocity: v, Position, Inertia, AngularVelocity: w } = world.components;
  const mass = Mass.value[eid];
  if (!(mass > 0) || isOpen(world, eid, 'Kinematic')) {
    warnAboutImpulse(world, eid);
    return;
  }
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
