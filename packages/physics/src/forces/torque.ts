// Torques: a steady one on every body that can turn, and drag on the turning.
//
//   constantTorque  τ = T        angularDrag  τ = -k ω
//
//   τ  torque, N m    k  the column AngularDrag, N m s; Stokes: 8 π η r³ for a sphere    ω  angular velocity, rad/s
//
// A body turns when it has Inertia and AngularVelocity: dω/dt = τ/I, by semi-implicit Euler, with one moment of inertia
// for all axes. In 2D only z. Keep k dt/I below 1. Goldstein, Classical Mechanics, section 5.
// Cost: one multiply-add an axis.
import { checkVector, type VectorInput } from '../faults/validate';
import { ANY } from './bounds';
import type { Force } from './force';
import { lawKernels } from './law-kernels';
import { shownVector } from './time-vector';

/**
 * @param torque T, N m; in 2D its z
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function constantTorque(torque: VectorInput): Force {
  const t = checkVector(torque, 'constantTorque', ANY);
  return {
    name: 'constant torque',
    equation: 'τ = T',
    parameters: shownVector('torque', 'N m', t),
    reads: ['Inertia'],
    local: true,
    timeless: true,
    turns: true,
    accumulate(world, first, last) {
      const kernels = lawKernels(world);
      const { x, y, z } = world.scratch.at.torque;
      const inertia = world.addresses.Inertia.value;
      kernels.pushAxis(z, inertia, t.z, first, last);
      if (world.dimensions === 2) return;
      kernels.pushAxis(x, inertia, t.x, first, last);
      kernels.pushAxis(y, inertia, t.y, first, last);
    },
  };
}

/** Drag on the turning of bodies with `AngularDrag`. */
export function angularDrag(): Force {
  return {
    name: 'angular drag',
    equation: 'τ = -k ω',
    reads: ['AngularVelocity', 'AngularDrag'],
    local: true,
    timeless: true,
    turns: true,
    accumulate(world, first, last) {
      const { kernels, addresses } = world;
      const { AngularVelocity: w, AngularDrag } = addresses;
      const { x, y, z } = world.scratch.at.torque;
      kernels.linearDragAxis(z, w.z, AngularDrag.coefficient, 0, first, last);
      if (world.dimensions === 2) return;
      kernels.linearDragAxis(x, w.x, AngularDrag.coefficient, 0, first, last);
      kernels.linearDragAxis(y, w.y, AngularDrag.coefficient, 0, first, last);
    },
  };
}
