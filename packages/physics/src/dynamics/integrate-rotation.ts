// Integrates rotation: the torque of the last force evaluation changes the angular velocity, then the angle (2D) or
// quaternion (3D) advances with the new angular velocity. Semi-implicit Euler, first order; skipped while no body
// rotates.
//
//   ω' = ω + τ/I dt        θ' = θ + ω' dt
import { bitOf } from '../components/all.ts';
import { forEachRange } from '../ecs/ranges.ts';
import type { LocalSystem, PhysicsWorld } from '../world/types.ts';
import { anyForceAppliesTorque } from './evaluate-forces.ts';

export const integrateRotation: LocalSystem = {
  name: 'rotation',
  role: 'rotate',
  run: forEachRange((world, first, last, dt) => {
    if (world.internal.counts.AngularVelocity === 0) return;
    if (anyForceAppliesTorque(world)) kickRange(world, first, last, dt);
    rotateRange(world, first, last, dt);
  }),
};

/** A body without inertia or without AngularVelocity does not rotate. */
function kickRange(world: PhysicsWorld, first: number, last: number, dt: number): void {
  const { kernels, addresses, scratch, internal } = world;
  const { AngularVelocity: w, Inertia } = addresses;
  const bit = bitOf('AngularVelocity');
  const axes = world.dimensions === 2 ? SPIN_2D : SPIN_3D;
  for (let a = 0; a < axes.length; a++) {
    const axis = axes[a];
    const torque = scratch.at.torque[axis];
    kernels.kickSpinAxis(w[axis], torque, Inertia.value, internal.membersAt, bit, dt, first, last);
  }
}

const SPIN_2D = ['z'] as const;
const SPIN_3D = ['x', 'y', 'z'] as const;

function rotateRange(world: PhysicsWorld, first: number, last: number, dt: number): void {
  const { kernels, addresses } = world;
  const { AngularVelocity: w, Orientation: q, Rotation } = addresses;
  if (world.dimensions === 2) kernels.driftAxis(Rotation.angle, w.z, dt, first, last);
  else kernels.rotateQuaternion(q.x, q.y, q.z, q.w, dt, first, last);
}
