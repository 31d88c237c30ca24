import { Appearance } from './appearance';
import { Attractor } from './attractor';
import { Charge } from './charge';
import { Collider } from './collider';
import type { ColumnsOf } from './define';
import { AngularDrag, LinearDrag, QuadraticDrag } from './drag';
import { Hull } from './hull';
import { Inertia } from './inertia';
import { Lift } from './lift';
import { Mass } from './mass';
import { Position } from './position';
import { Engine, Motor, Thrust } from './propulsion';
import { Quarantined } from './quarantined';
import { AngularVelocity, Orientation, Rotation } from './rotation';
import { Spring } from './spring';
import { TestParticle } from './test-particle';
import { Velocity } from './velocity';
import { PlaneWall, SegmentWall } from './wall';

/** Every component of a world, in the order of their membership bits. At most 31, as in one mask of bitECS. */
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
} as const;

export type ComponentName = keyof typeof COMPONENTS;

/** `world.components`: per component, one typed array a field, indexed by entity id. */
export type Components = { readonly [Name in ComponentName]: ColumnsOf<(typeof COMPONENTS)[Name]> };

/** The same shape, with the byte address of each column in the world's memory: what kernels take. */
export type Addresses = {
  readonly [Name in ComponentName]: { readonly [Field in keyof Components[Name]]: number };
};

export const COMPONENT_NAMES = Object.keys(COMPONENTS) as ComponentName[];

/** A component's name as `spawn(world, { … })` and messages write it: Position is position there. */
export function keyOf(name: ComponentName): string {
  return name[0].toLowerCase() + name.slice(1);
}

const BITS = Object.fromEntries(COMPONENT_NAMES.map((name, at) => [name, (1 << at) >>> 0])) as Record<
  ComponentName,
  number
>;

/** The membership bit of a component. */
export function bitOf(name: ComponentName): number {
  return BITS[name];
}
