// Variants of the scene `particles` for the bench: all bodies at rest on the floor, and more laws.
import {
  bodies,
  electricField,
  type Force,
  linearDrag,
  magneticField,
  type PhysicsWorld,
  thrust,
  uniformSphereGravity,
  vortex,
} from '@principia/physics';
import type { Particles, SceneRun } from '@principia/scenes';
import { addComponent, set } from 'bitecs';

/** Numbers of laws that `--laws` accepts; the scene has two. */
export const LAW_COUNTS = [2, 3, 5, 8] as const;

export interface Variant {
  /** All bodies start on the floor and restitution is zero, so that every body rests on it in every step. */
  readonly resting: boolean;
  readonly laws: (typeof LAW_COUNTS)[number];
}

export const PLAIN: Variant = { resting: false, laws: 2 };

/** A run of the scene in a variant; absent for the plain scene. */
export type ParticlesRun = Particles & { readonly variant?: Variant };

/** The scene parameters that a variant sets. */
export function variantParameters({ resting }: Variant): { readonly restitution?: number } {
  return resting ? { restitution: 0 } : {};
}

/** Applies a variant to a new scene. */
export function applyVariant(run: SceneRun, variant: Variant): SceneRun {
  if (!variant.resting && variant.laws === 2) return run;
  const varied: ParticlesRun = { ...(run as Particles), variant };
  if (variant.resting) putOnFloor(run.world);
  addLaws(varied, variant.laws);
  return varied;
}

/** Puts every body at rest on the floor, at y = 0. */
function putOnFloor(world: PhysicsWorld): void {
  const { ids, count } = bodies(world);
  const { Position, Velocity, Collider } = world.components;
  for (const id of ids.subarray(0, count)) {
    Position.y[id] = Collider.radius[id];
    for (const axis of ['x', 'y', 'z'] as const) Velocity[axis][id] = 0;
  }
}

/**
 * Sets the components that the further laws read, so that forces are at most comparable to the weight, and adds the
 * laws.
 */
function addLaws({ world, side }: Particles, laws: number): void {
  if (laws === 2) return;
  const centre = { x: side / 2, y: side / 2, ...(world.dimensions === 3 ? { z: side / 2 } : {}) };
  const further: readonly Force[] = [
    linearDrag(),
    magneticField({ z: 0.5 }),
    electricField({ x: 1, y: 2 }),
    thrust(),
    vortex({ centre, strength: 0.01, radius: side / 4 }),
    uniformSphereGravity({ centre, mu: 1000, radius: side / 4 }),
  ];
  world.forces.push(...further.slice(0, laws - 2));
  const { LinearDrag, Charge, Thrust } = world.components;
  const { ids, count } = bodies(world);
  for (const id of Uint32Array.from(ids.subarray(0, count))) {
    addComponent(world, id, set(LinearDrag, { coefficient: 0.05 }));
    if (laws >= 5) addComponent(world, id, set(Charge, { value: 1 }));
    if (laws >= 8) addComponent(world, id, set(Thrust, { x: 0.5 - (id % 2), y: 0.1 }));
  }
}
