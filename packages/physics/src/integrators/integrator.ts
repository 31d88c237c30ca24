import type { EvaluateForces } from '../forces/evaluate';
import type { Spans } from '../store/spans';
import type { PhysicsWorld } from '../world';

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
  advance(world: PhysicsWorld, spans: Spans, dt: number, evaluateForces: EvaluateForces): void;
}
