// Walls of an axis-aligned box, with the instant of impact found inside the step (kernels/walls/box.ts has the maths).
import { checkKeys, checkNumber, checkVector, mustBe, type VectorInput } from '../faults/validate';
import type { LocalSystem } from '../schedule/phases';
import { AXES } from '../store/axes';
import { eachRun } from '../store/spans';

/** A box that keeps bodies inside. An axis left out of `min` or `max` has no wall on that side. */
export interface BoxWallsOptions {
  /** Corner with the smallest coordinates, m. */
  readonly min?: VectorInput;
  /** Corner with the largest coordinates, m. */
  readonly max?: VectorInput;
  /** Restitution of the walls; a contact's is the larger of this and the body's. Default 0: the body decides. */
  readonly restitution?: number;
  /** Friction of the walls; a contact's is the geometric mean of this and the body's. Default: the body's own. */
  readonly friction?: number;
}

/** No coordinate a world takes reaches this: a wall there is no wall. */
const FAR = 1e30;

/**
 * A system for the `walls` phase. Acts on bodies with Mass and Collider.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function boxWalls(options: BoxWallsOptions): LocalSystem {
  checkKeys(options, 'boxWalls', ['min', 'max', 'restitution', 'friction']);
  checkVector(options.min ?? {}, 'boxWalls.min');
  checkVector(options.max ?? {}, 'boxWalls.max');
  const low = { x: -FAR, y: -FAR, z: -FAR, ...options.min };
  const high = { x: FAR, y: FAR, z: FAR, ...options.max };
  for (const axis of AXES[3]) {
    if (low[axis] < high[axis]) continue;
    throw mustBe(`below max.${axis} (${high[axis]})`, low[axis], `boxWalls.min.${axis}`, 'E_RANGE');
  }
  const restitution = checkNumber(options.restitution ?? 0, 'boxWalls.restitution', { min: 0, max: 10 });
  const friction =
    options.friction === undefined ? -1 : checkNumber(options.friction, 'boxWalls.friction', { min: 0, max: 100 });
  return {
    name: 'box walls',
    usesScratch: true,
    run: eachRun(({ kernels, addresses, dimensions, scratch, integrator }, first, last, dt) => {
      const { Position, Velocity } = addresses;
      const start = scratch.at.startVelocity;
      const lag = (integrator.velocityLag ?? 0) * dt;
      for (let a = 0; a < dimensions; a++) {
        const axis = AXES[3][a];
        const x = Position[axis];
        const v = Velocity[axis];
        kernels.boxAxis(a, x, v, start[axis], low[axis], high[axis], restitution, friction, dt, lag, first, last);
      }
    }),
  };
}
