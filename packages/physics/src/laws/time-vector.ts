// A vector that is given once, or as a function of time.
import { collectThrown } from '../errors/collect-thrown.ts';
import { type Bounds, checkNumber, checkVector, type Vector, type VectorInput } from '../errors/validate.ts';
import type { ForceParameter, PhysicsWorld } from '../world/types.ts';

/**
 * A vector, or a function of the time in seconds that returns one. The function must give the same vector for the same
 * time, and may return the same object each time, which makes no garbage.
 */
export type VectorOverTime = VectorInput | ((time: number) => VectorInput);

/** The vector at a moment. */
export interface TimeVector {
  /** The vector, when it does not change. */
  readonly steady: Vector | undefined;
  at(world: PhysicsWorld, time: number): Vector;
}

/**
 * A steady vector is checked here. One that changes is asked once per moment; when it throws, or returns what is no
 * vector within bounds, the step reports that and the last good one goes on.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function timeVector(value: VectorOverTime, caller: string, name: string, bounds: Bounds): TimeVector {
  if (typeof value !== 'function') {
    const steady = checkVector(value, caller, bounds);
    return { steady, at: () => steady };
  }
  const now = { x: 0, y: 0, z: 0 };
  const [nameX, nameY, nameZ] = [`${name}.x`, `${name}.y`, `${name}.z`];
  // In a cell: a number that a function keeps is a new one on the heap whenever it changes.
  const asked = new Float64Array([Number.NaN]);
  return {
    steady: undefined,
    at(world, time) {
      if (time === asked[0]) return now;
      asked[0] = time;
      try {
        const { x = 0, y = 0, z = 0 } = value(time);
        checkNumber(x, nameX, bounds);
        checkNumber(y, nameY, bounds);
        checkNumber(z, nameZ, bounds);
        now.x = x;
        now.y = y;
        now.z = z;
      } catch (error) {
        collectThrown(world, error);
      }
      return now;
    },
  };
}

/** As a force's documentation shows it: nothing for one that changes. */
export function shownVector(name: string, unit: string, vector: Vector | undefined): Record<string, ForceParameter> {
  if (vector === undefined) return {};
  const { x, y, z } = vector;
  return { [`${name}X`]: { unit, value: x }, [`${name}Y`]: { unit, value: y }, [`${name}Z`]: { unit, value: z } };
}
