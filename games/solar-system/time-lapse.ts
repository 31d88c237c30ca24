/**
 * An integrator for worlds whose time runs faster than the clock: each step of the world advances the bodies in intervals
 * that a pacer chooses, whatever the length of the step is. The forces must not depend on time.
 */
import {
  type EvaluateForces,
  gaussRadau,
  type Integrator,
  type PhysicsWorld,
  type Ranges,
  wisdomHolman,
} from '@principia/physics';

/** Decides how a step of the world is divided. */
export interface Pacer {
  /** Called once a step. @param seconds length of the step */
  begin(seconds: number): void;
  /** The next interval, s; 0 ends the step. */
  next(): number;
  /** Called after each interval. */
  passed(interval: number): void;
  /** Whether the next interval is taken by the Wisdom-Holman map instead of Gauss-Radau. */
  readonly usesMap: boolean;
}

/**
 * Largest last term of the series of Gauss-Radau relative to the acceleration. Ten years of planets differ by less than a
 * hundred metres from those with the default of 1e-9.
 */
const TOLERANCE = 1e-6;

export function timeLapse(pacer: Pacer): Integrator {
  const radau = gaussRadau({ tolerance: TOLERANCE });
  const map = wisdomHolman({ G: 1 });
  return {
    ...radau,
    name: 'Time lapse',
    prepare(world, dt) {
      radau.prepare?.(world, dt);
      map.prepare?.(world, dt);
    },
    advance(world: PhysicsWorld, ranges: Ranges, dt: number, evaluate: EvaluateForces) {
      pacer.begin(dt);
      for (let interval = pacer.next(); interval > 0; interval = pacer.next()) {
        const scheme = pacer.usesMap ? map : radau;
        scheme.advance?.(world, ranges, interval, evaluate);
        pacer.passed(interval);
      }
    },
  };
}
