// A vector that is constant or a function of time.
import { collectThrown } from '../errors/collect-thrown.ts';
import { type Bounds, checkNumber, checkVector, type Vector, type VectorInput } from '../errors/validate.ts';
import type { ForceParameter, PhysicsWorld } from '../world/types.ts';

/**
 * A vector, or a function of the time in seconds that returns one. The function must return equal vectors for equal
 * times, and may return the same object each time, which avoids garbage.
 */
export type VectorOverTime = VectorInput | ((time: number) => VectorInput);

/** A vector with a value at every time. */
export interface TimeVector {
  /** The vector, if it is constant. */
  readonly steady: Vector | undefined;
  at(world: PhysicsWorld, time: number): Vector;
}

/**
 * Creates the vector. A constant vector is validated immediately. A function is called once per time; if it throws or
 * returns an invalid vector, the step reports the error and the last valid vector is used.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function timeVector(value: VectorOverTime, caller: string, name: string, bounds: Bounds): TimeVector {
  if (typeof value !== 'function') {
    const steady = checkVector(value, caller, bounds);
    return { steady, at: () => steady };
  }
  const current = { x: 0, y: 0, z: 0 };
  const [nameX, nameY, nameZ] = [`${name}.x`, `${name}.y`, `${name}.z`];
  // The time is in a typed array, because a captured number would allocate a heap object at every change.
  const lastTime = new Float64Array([Number.NaN]);
  return {
    steady: undefined,
    at(world, time) {
      if (time === lastTime[0]) return current;
      lastTime[0] = time;
      try {
        const { x = 0, y = 0, z = 0 } = value(time);
        checkNumber(x, nameX, bounds);
        checkNumber(y, nameY, bounds);
        checkNumber(z, nameZ, bounds);
        current.x = x;
        current.y = y;
        current.z = z;
      } catch (error) {
        collectThrown(world, error);
      }
      return current;
    },
  };
}

/** The entry in the documentation of a force; empty for a function of time. */
export function shownVector(name: string, unit: string, vector: Vector | undefined): Record<string, ForceParameter> {
  if (vector === undefined) return {};
  const { x, y, z } = vector;
  return { [`${name}X`]: { unit, value: x }, [`${name}Y`]: { unit, value: y }, [`${name}Z`]: { unit, value: z } };
}
