// What the scenes of rigid bodies share. They are arranged as in Box2D's benchmark, in worlds of two dimensions.
import {
  createPhysicsWorld,
  type Integrator,
  PhysicsError,
  type PhysicsWorld,
  type PhysicsWorldOptions,
  type Precision,
  rigidBodies,
  softStep,
  uniformGravity,
} from '@principia/physics';
import type { SceneRun } from '../scene.ts';

/** A run in which other engines take part. */
export interface RigidRun extends SceneRun {
  /** Downward acceleration, m/s². */
  readonly gravity: number;
}

export const MATERIAL = { density: 1, friction: 0.6 };
/** The largest distance by which boxes start apart from where they rest, m. */
export const GAP = 0.01;

/** Standard gravity, m/s². */
export const GRAVITY = 9.80665;

/** A parameter of all rigid scenes: other engines are compared while nothing sleeps. */
export const sleeping = { about: '1 lets bodies sleep', unit: '', initial: 1, min: 0, max: 1, integer: true };

export interface WorldSetup {
  readonly dimensions: 2 | 3;
  readonly precision: Precision;
  readonly seed: number;
  /** A `softStep({ … })`, which then decides whether bodies sleep. The world refuses others. */
  readonly integrator: Integrator | undefined;
  readonly parameters: { readonly sleeping: number };
}

/**
 * @param gravity downward acceleration, m/s²
 * @param more further options of the world
 * @throws PhysicsError E_RANGE for three dimensions
 */
export function rigidWorld(
  { dimensions, precision, seed, integrator, parameters }: WorldSetup,
  capacity: number,
  gravity = GRAVITY,
  more: PhysicsWorldOptions = {},
): PhysicsWorld {
  if (dimensions === 3) {
    throw new PhysicsError('E_RANGE', 'scenes of rigid bodies have two dimensions, got 3.', {
      field: 'dimensions',
      value: dimensions,
      hint: 'Leave `dimensions` out, or take one of circles, gas and bouncing-balls.',
    });
  }
  return createPhysicsWorld({
    preset: rigidBodies,
    integrator: integrator ?? softStep(parameters.sleeping === 1 ? {} : { sleepTime: 0 }),
    precision,
    seed,
    capacity,
    forces: gravity === 0 ? [] : [uniformGravity({ y: -gravity })],
    ...more,
  });
}

export const runOf = (world: PhysicsWorld, gravity = GRAVITY): RigidRun => ({
  world,
  dt: 1 / 60,
  gravity,
  losesEnergy: 'friction and collisions dissipate energy',
});
