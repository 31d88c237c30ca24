import type { EvaluateForces } from '../../dynamics/evaluate-forces.ts';
import type { Spans } from '../../ecs/ranges.ts';
import type { Scheme } from '../../laws/scheme.ts';
import type { PhysicsWorld } from '../../world/create-world.ts';

/**
 * A scheme that moves positions and velocities by one step. It owns the step: it asks for forces when it wants them.
 * The state at the start is in `world.previousAddresses.Position` and `world.scratch.at.startVelocity`; `stage1` and
 * `stage2` of the scratch are free.
 */
export interface Integrator {
  readonly name: string;
  /** Order of the global error in dt. */
  readonly order: number;
  /** Keeps the energy of a conservative system bounded for ever. */
  readonly symplectic: boolean;
  /** Force evaluations a step. */
  readonly evaluations: number;
  /**
   * By what part of a step its velocities are those of an earlier moment than its positions; default 0. Walls and
   * contacts need it to find speed and height at the instant of an impact.
   */
  readonly velocityLag?: number;
  /**
   * Whether a damped oscillator stays bounded: `stiffness` is ω² dt², `damping` is γ dt, for x″ = -ω² x - γ x′. Springs
   * ask before the step; without an answer they do not check.
   */
  isStable?(stiffness: number, damping: number): boolean;
  /** Columns of reals it takes from the world's memory; a world made with it has room for them. */
  readonly columns?: number;
  /** It solves springs itself, as constraints: the force `springs()` then adds nothing but its potential. */
  readonly solvesSprings?: boolean;
  /** It must see all bodies at once, so that no step of it runs tile by tile. */
  readonly wholeWorld?: boolean;
  /** Called once a step, before anything moves: takes memory. What it throws comes out of `step`. */
  prepare?(world: PhysicsWorld, dt: number): void;
  /** A scheme of fixed stages as expressions: it becomes one loop with the laws. */
  readonly scheme?: Scheme;
  /** Moves the bodies by one step. Where there is one, the scheme is not used. */
  advance?(world: PhysicsWorld, spans: Spans, dt: number, evaluateForces: EvaluateForces): void;
}
