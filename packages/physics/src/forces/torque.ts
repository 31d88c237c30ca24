// Torques: a constant one on every body that can rotate, and drag on rotation.
//
//   constantTorque  τ = T, or with T in the body's axes  τ = R T        angularDrag  τ = -k ω
//
//   τ  torque, N m    k  the column AngularDrag, N m s; Stokes: 8 π η r³ for a sphere    ω  angular velocity, rad/s
//
// A body with Inertia and AngularVelocity rotates: dω/dt = τ/I, by semi-implicit Euler, with one moment of inertia
// for all axes. In 2D only z. In 3D an InertiaTensor gives one for each axis of the body. Keep k dt/I below 1. Goldstein,
// Classical Mechanics, section 5. Cost: one multiply-add per axis; in the body's axes two cross products more.
import { AngularDrag } from '../components/drag.ts';
import { Inertia } from '../components/inertia.ts';
import { InertiaTensor } from '../components/inertia-tensor.ts';
import { defineLaw } from '../dynamics/define-law.ts';
import { checkKeys, type VectorInput } from '../errors/validate.ts';
import { axial3, type Scalar, select, type Vector } from '../laws/expression.ts';
import { axialVector } from '../laws/parameter.ts';
import type { Force } from '../world/types.ts';
import { ANY } from './support/bounds.ts';
import { checkFrame } from './support/frame.ts';

const source = 'Goldstein, Classical Mechanics, section 5.';

const constantLaw = /* @__PURE__ */ defineLaw({
  name: 'constant torque',
  formula: 'τ = T',
  source,
  reads: { inertia: Inertia, tensor: InertiaTensor },
  parameters: {
    /** T, N m; in 2D its z. */
    torque: axialVector('N m', ANY),
  },
  torque: ({ inertia, tensor }, { torque }) => ofRotating(inertia, tensor, torque),
});

const bodyLaw = /* @__PURE__ */ defineLaw({
  name: 'constant torque',
  formula: 'τ = R T',
  source,
  reads: { inertia: Inertia, tensor: InertiaTensor },
  parameters: {
    /** T in the body's axes, N m; in 2D its z. */
    torque: axialVector('N m', ANY),
  },
  torque: ({ inertia, tensor, rotate }, { torque }) => ofRotating(inertia, tensor, rotate(torque)),
});

/** A torque on bodies that can rotate. */
function ofRotating(inertia: Scalar, tensor: Vector, torque: Vector): Vector {
  return select(inertia.add(tensor.x).greater(0), torque, axial3(0, 0, 0));
}

const dragLaw = /* @__PURE__ */ defineLaw({
  name: 'angular drag',
  formula: 'τ = -k ω',
  source,
  reads: { k: AngularDrag },
  torque: ({ angularVelocity, k }) => angularVelocity.mul(k).negate(),
});

/** Options of `constantTorque`. */
export interface ConstantTorqueOptions {
  /** Whether the torque is in axes of the world (default) or of the body, as that of thrusters. */
  readonly frame?: 'world' | 'body';
}

/**
 * A constant torque, N m, on every body that can rotate, in the axes of the world or of the body.
 *
 * @param torque T, N m; in 2D its z
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function constantTorque(torque: VectorInput, options: ConstantTorqueOptions = {}): Force {
  checkKeys(options, 'constantTorque', ['frame']);
  const frame = checkFrame(options.frame ?? 'world', 'constantTorque.frame');
  return frame === 'world' ? constantLaw({ torque }) : bodyLaw({ torque });
}

/** Drag on the rotation of bodies with `AngularDrag`. */
export function angularDrag(): Force {
  return dragLaw();
}
