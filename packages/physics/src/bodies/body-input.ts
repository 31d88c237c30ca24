// What `spawn` takes, with the comments that editors show.
import type { COMPONENTS, ComponentName } from '../components/all.ts';
import type { ShapeInput } from './collider-shape.ts';

type FieldsOf<Name extends ComponentName> = keyof (typeof COMPONENTS)[Name]['fields'] extends never
  ? Record<string, never>
  : ValuesOf<Name>;

type ValuesOf<Name extends ComponentName> = {
  readonly [F in keyof (typeof COMPONENTS)[Name]['fields']]?: (typeof COMPONENTS)[Name]['fields'][F] extends {
    readonly isFlag: true;
  }
    ? number | boolean
    : number;
};

type NamesWithScalar = {
  [Name in ComponentName]: (typeof COMPONENTS)[Name] extends { readonly scalar?: infer S }
    ? S extends string
      ? Name
      : never
    : never;
}[ComponentName];

type AllKeys = { [Name in ComponentName as Uncapitalize<Name>]: Name };

/** The component of each key. */
interface ComponentOfKey extends AllKeys {
  /** Position of the centre of mass, m; `{}` is the origin. What has one is a body. */
  position: 'Position';
  /** Velocity of the centre of mass, m/s; default 0 for a body with a mass, and else none. */
  velocity: 'Velocity';
  /** Mass, kg. Default none: no force moves the body. It may follow from `collider.density`. */
  mass: 'Mass';
  /** Moment of inertia about the centre, kg m². Default none, or that of the shape and the mass. */
  inertia: 'Inertia';
  /** Angle in 2D, rad, anticlockwise from +x. Default none, or 0 for a body with a shape. */
  rotation: 'Rotation';
  /** Orientation in 3D, a unit quaternion; `{}` is that of the axes of the world. Default none: the body does not turn. */
  orientation: 'Orientation';
  /** Angular velocity, rad/s; in 2D a number. Default none, or 0 for a body with a shape and a mass. */
  angularVelocity: 'AngularVelocity';
  /** What meets others: the radius of a disc or ball, m, or a shape, with its density and its surface. Default none: it touches nothing. */
  collider: 'Collider';
  /** Coefficient of the force `linearDrag()`, kg/s. Default none. */
  linearDrag: 'LinearDrag';
  /** Coefficient of the force `quadraticDrag()`, kg/m. Default none. */
  quadraticDrag: 'QuadraticDrag';
  /** Colour and drawn size, as of `rgba(1, 0.5, 0)`. Default none: the renderer decides. */
  appearance: 'Appearance';
  /** A spring between two bodies, of an entity of its own: `springs()` or `xpbd()` solves it. */
  spring: 'Spring';
  /** A centre that attracts or repels bodies, of an entity of its own: see `attractors()`. */
  attractor: 'Attractor';
  /** A wall from (ax, ay) to (bx, by), m, in 2D, of an entity of its own. */
  segmentWall: 'SegmentWall';
  /** A wall behind a plane with a normal, of an entity of its own; `{}` is the ground at y = 0. */
  planeWall: 'PlaneWall';
  /** Electric charge, C. Default none. */
  charge: 'Charge';
  /** What displaces a fluid: see `buoyancy()`. Default none. */
  hull: 'Hull';
  /** Coefficient of the force `lift()`. Default none. */
  lift: 'Lift';
  /** Coefficient of the torque `angularDrag()`, N m s. Default none. */
  angularDrag: 'AngularDrag';
  /** A force that you steer, N: see `thrust()`. Default none. */
  thrust: 'Thrust';
  /** An engine of constant power, W: see `motors()`. Default none. */
  motor: 'Motor';
  /** A rocket engine with its fuel: see `rocketEngines()`. Default none. */
  engine: 'Engine';
  /** `{}` for a body that feels `mutualGravity()` and exerts none. */
  testParticle: 'TestParticle';
  /** Given to bodies with a fault by the step. */
  quarantined: 'Quarantined';
  /** Written by `createJoint`. A copy of a joint takes its columns, but for the generations and `started`. */
  joint: 'Joint';
  /** Written by `spawnCompound`: the body of which this is a part. */
  attachment: 'Attachment';
  /** `{}` for a body that moves by its velocity, whatever its mass and what acts on it. Rigid bodies only. */
  kinematic: 'Kinematic';
  /** Factor of the acceleration by `uniformGravity()`; default 1. */
  gravityScale: 'GravityScale';
  /** Directions in which a rigid body does not move, or the angle. Default none. */
  motionLocks: 'MotionLocks';
  /** `{}` for a rigid body that does not fall asleep. */
  neverSleep: 'NeverSleep';
  /** Principal moments of inertia of a body in 3D, kg m². Default none. */
  inertiaTensor: 'InertiaTensor';
}

/**
 * The components of a new body: `{ position: { x: 1 }, velocity: { y: 2 }, mass: 3, collider: { radius: 0.5 } }`, or with
 * a shape `{ position: { x: 1 }, collider: { shape: box(1, 0.5), density: 1000 } }`.
 */
export type BodyInput = { readonly [Key in keyof ComponentOfKey]?: InputOf<ComponentOfKey[Key]> | undefined };

type InputOf<Name extends ComponentName> =
  | (Name extends 'Collider' ? Omit<FieldsOf<Name>, 'shape'> & ShapeInput : FieldsOf<Name>)
  | (Name extends NamesWithScalar ? number : never);
