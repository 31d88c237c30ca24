import { Appearance } from './appearance.ts';
import { Attachment } from './attachment.ts';
import { Attractor } from './attractor.ts';
import { Charge } from './charge.ts';
import { Collider } from './collider.ts';
import type { ColumnsOf } from './define.ts';
import { AngularDrag, LinearDrag, QuadraticDrag } from './drag.ts';
import { GravityScale } from './gravity-scale.ts';
import { Hull } from './hull.ts';
import { Inertia } from './inertia.ts';
import { InertiaTensor } from './inertia-tensor.ts';
import { Joint } from './joint.ts';
import { Kinematic } from './kinematic.ts';
import { Lift } from './lift.ts';
import { Mass } from './mass.ts';
import { MotionLocks } from './motion-locks.ts';
import { NeverSleep } from './never-sleep.ts';
import { Position } from './position.ts';
import { Engine, Motor, Thrust } from './propulsion.ts';
import { Quarantined } from './quarantined.ts';
import { AngularVelocity, Orientation, Rotation } from './rotation.ts';
import { Spring } from './spring.ts';
import { TestParticle } from './test-particle.ts';
import { Velocity } from './velocity.ts';
import { PlaneWall, SegmentWall } from './wall.ts';

/** Every component of a world, in the order of its membership bits (membership.ts). */
export const COMPONENTS = {
  Position,
  Velocity,
  Mass,
  Inertia,
  Rotation,
  Orientation,
  AngularVelocity,
  Collider,
  LinearDrag,
  QuadraticDrag,
  Appearance,
  Spring,
  Attractor,
  SegmentWall,
  PlaneWall,
  Charge,
  Hull,
  Lift,
  AngularDrag,
  Thrust,
  Motor,
  Engine,
  TestParticle,
  Quarantined,
  Joint,
  Attachment,
  Kinematic,
  GravityScale,
  MotionLocks,
  NeverSleep,
  InertiaTensor,
} as const;

/** The name of a component of the package, such as `Position`. */
export type ComponentName = keyof typeof COMPONENTS;

/** The type of `world.components`: per component a typed array per field, indexed by entity id. */
export type Components = { readonly [Name in ComponentName]: ColumnsOf<(typeof COMPONENTS)[Name]> };

/** The same shape with the byte address of each column in the world's memory, for kernels. */
export type Addresses = {
  readonly [Name in ComponentName]: { readonly [Field in keyof Components[Name]]: number };
};

/** The names of all components of the package, in the order of `COMPONENTS`. */
export const COMPONENT_NAMES = Object.keys(COMPONENTS) as ComponentName[];

/** Returns a component's name as in `spawn(world, { … })` and in messages: `position` for Position. */
export function keyOf(name: ComponentName): string {
  return name[0].toLowerCase() + name.slice(1);
}

/** The name of a definition of the package; undefined for any other value. */
export function nameOfDefinition(component: unknown): ComponentName | undefined {
  return COMPONENT_NAMES.find((name) => COMPONENTS[name] === component);
}
