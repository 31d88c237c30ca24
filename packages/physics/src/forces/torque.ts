// Torques: a constant one on every body that can rotate, and drag on rotation.
//
//   constantTorque  τ = T        angularDrag  τ = -k ω
//
//   τ  torque, N m    k  the column AngularDrag, N m s; Stokes: 8 π η r³ for a sphere    ω  angular velocity, rad/s
//
// A body with Inertia and AngularVelocity rotates: dω/dt = τ/I, by semi-implicit Euler, with one moment of inertia
// for all axes. In 2D only z. Keep k dt/I below 1. Goldstein, Classical Mechanics, section 5. Cost: one multiply-add
// per axis.
import { AngularDrag } from '../components/drag.ts';
import { Inertia } from '../components/inertia.ts';
import { defineLaw } from '../dynamics/define-law.ts';
import type { VectorInput } from '../errors/validate.ts';
import { axial3, select } from '../laws/expression.ts';
import { axialVector } from '../laws/parameter.ts';
import type { Force } from '../world/types.ts';
import { ANY } from './support/bounds.ts';

const source = 'Goldstein, Classical Mechanics, section 5.';

const constantLaw = /* @__PURE__ */ defineLaw({
  name: 'constant torque',
  formula: 'τ = T',
  source,
  reads: { inertia: Inertia },
  parameters: {
    /** T, N m; in 2D its z. */
    torque: axialVector('N m', ANY),
  },
  torque: ({ inertia }, { torque }) => select(inertia.greater(0), torque, axial3(0, 0, 0)),
});

const dragLaw = /* @__PURE__ */ defineLaw({
  name: 'angular drag',
  formula: 'τ = -k ω',
  source,
  reads: { k: AngularDrag },
  torque: ({ angularVelocity, k }) => angularVelocity.mul(k).negate(),
});

/**
 * @param torque T, N m; in 2D its z
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function constantTorque(torque: VectorInput): Force {
  return constantLaw({ torque });
}

/** Drag on the rotation of bodies with `AngularDrag`. */
export function angularDrag(): Force {
  return dragLaw();
}
