// Integrates rotation: the torque of the last force evaluation changes the angular velocity, then the angle (2D) or
// quaternion (3D) advances with the new angular velocity. Semi-implicit Euler, first order; skipped while no body
// rotates.
//
//   ω' = ω + τ/I dt        θ' = θ + ω' dt
//
// Bodies with an InertiaTensor take a symmetric step instead, of second order: they rotate freely for dt/2 before the
// forces are evaluated (`startRotation`), and here the torque acts for dt, followed by the other half of the rotation.
//
//   L' = L + τ dt        L = R I Rᵀ ω, constant in free rotation: see kernels/rotation/rotate-rigidly.ts
import { forEachRange } from '../ecs/ranges.ts';
import type { LocalSystem, PhysicsWorld, Ranges } from '../world/types.ts';
import { anyForceAppliesTorque } from './evaluate-forces.ts';
import { rotationKernels } from './rotation-kernels.ts';

export const integrateRotation: LocalSystem = {
  name: 'rotation',
  role: 'rotate',
  run: forEachRange((world, first, last, dt) => {
    const { AngularVelocity, InertiaTensor } = world.internal.counts;
    if (AngularVelocity === 0) return;
    const hasTorque = anyForceAppliesTorque(world);
    const hasTensors = InertiaTensor > 0 && world.dimensions === 3;
    if (hasTorque) kickRange(world, hasTensors, first, last, dt);
    rotateRange(world, hasTensors, first, last, dt);
    if (hasTensors) rotateRigidly(world, hasTorque ? dt : 0, dt / 2, first, last);
  }),
};

/** The free rotation of the first half of a step; `integrate` calls it before it evaluates forces. */
export function startRotation(world: PhysicsWorld, { bounds, count }: Ranges, dt: number): void {
  if (world.internal.counts.InertiaTensor === 0 || world.dimensions === 2) return;
  for (let r = 0; r < count; r++) rotateRigidly(world, 0, dt / 2, bounds[2 * r], bounds[2 * r + 1]);
}

function rotateRigidly(world: PhysicsWorld, kick: number, dt: number, first: number, last: number): void {
  const { x, y, z } = world.scratch.at.torque;
  rotationKernels(world).rotateRigidly(x, y, z, kick, dt, first, last);
}

/** A body without inertia or without AngularVelocity does not rotate. */
function kickRange(world: PhysicsWorld, hasTensors: boolean, first: number, last: number, dt: number): void {
  const { kernels, addresses, scratch } = world;
  const axes = world.dimensions === 2 ? SPIN_2D : SPIN_3D;
  for (let a = 0; a < axes.length; a++) {
    const axis = axes[a];
    const omega = addresses.AngularVelocity[axis];
    kernels.kickSpinAxis(omega, scratch.at.torque[axis], Number(hasTensors), dt, first, last);
  }
}

const SPIN_2D = ['z'] as const;
const SPIN_3D = ['x', 'y', 'z'] as const;

function rotateRange(world: PhysicsWorld, hasTensors: boolean, first: number, last: number, dt: number): void {
  const { kernels, addresses } = world;
  if (world.dimensions === 2) kernels.driftAxis(addresses.Rotation.angle, addresses.AngularVelocity.z, dt, first, last);
  else kernels.rotateQuaternion(dt, Number(hasTensors), first, last);
}
