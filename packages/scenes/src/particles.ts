// Particles that fall through a still medium in a closed box without collisions: the simplest world, made of four local
// systems (gravity, quadratic drag, semi-implicit Euler, box walls). It measures the cost of composition against a
// hand-written loop.
import {
  boxWalls,
  createPhysicsWorld,
  quadraticDrag,
  semiImplicitEuler,
  spawnMany,
  uniformGravity,
} from '@principia/physics';
import { countOf, defineScene, type SceneRun } from './scene.ts';
import { seededUniforms } from './seeded.ts';

/** A run with the constants of its box. */
export interface Particles extends SceneRun {
  /** Acceleration downwards, m/s². */
  readonly gravity: number;
  /** Edge of the box, m. */
  readonly side: number;
  /** Restitution of the walls. */
  readonly restitution: number;
}

/** Particles under gravity and quadratic drag that bounce in a box. */
export const particles = defineScene({
  name: 'particles',
  description: 'particles under gravity and quadratic drag that bounce in a box',
  precision: 'f32',
  parameters: {
    count: countOf('particles', 100_000, 8_000_000),
    gravity: { about: 'acceleration of free fall', unit: 'm/s²', initial: 9.80665, min: 0, max: 1000 },
    drag: { about: 'largest drag coefficient of a particle', unit: 'kg/m', initial: 0.01, min: 0, max: 10 },
    restitution: { about: 'restitution of the walls', unit: '', initial: 0.8, min: 0, max: 1 },
    side: { about: 'edge of the box', unit: 'm', initial: 100, min: 1, max: 100_000 },
    radius: { about: 'radius of a particle', unit: 'm', initial: 0.1, min: 0.001, max: 0.4 },
    speed: { about: 'largest initial speed along an axis', unit: 'm/s', initial: 20, min: 0, max: 10_000 },
  },
  build({ dimensions, precision, seed, progress, parameters }): Particles {
    const { count, gravity, drag, restitution, side, radius, speed } = parameters;
    const world = createPhysicsWorld({
      dimensions,
      precision,
      seed,
      capacity: count,
      arenaBytes: 2 ** 20,
      integrator: semiImplicitEuler,
      forces: [uniformGravity({ y: -gravity }), quadraticDrag()],
      walls: [boxWalls({ min: { x: 0, y: 0, z: 0 }, max: { x: side, y: side, z: side }, restitution, friction: 0 })],
    });
    const uniform = seededUniforms(seed, count);
    const place = () => uniform(radius, side - radius);
    const push = () => uniform(-speed, speed);
    spawnMany(
      world,
      count,
      {
        position: { x: place(), y: place(), ...(dimensions === 3 ? { z: place() } : {}) },
        velocity: { x: push(), y: push(), ...(dimensions === 3 ? { z: push() } : {}) },
        mass: uniform(0.5, 1.5),
        quadraticDrag: uniform(0.1 * drag, drag),
        collider: radius,
      },
      progress,
    );
    return { world, dt: 1 / 60, losesEnergy: 'drag and inelastic walls dissipate energy', gravity, side, restitution };
  },
});
