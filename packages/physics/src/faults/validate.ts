import { describe, PhysicsError } from './physics-error';

/** Bounds of a number; `above` and `below` exclude the bound itself. */
export interface Bounds {
  readonly min?: number | undefined;
  readonly max?: number | undefined;
  readonly above?: number | undefined;
  readonly integer?: boolean | undefined;
}

/**
 * Returns `value` when it is a finite number within bounds.
 * @throws PhysicsError E_TYPE (not a number), E_NONFINITE (NaN, infinite), E_RANGE (out of bounds)
 */
export function checkNumber(
  value: unknown,
  field: string,
  bounds: Bounds = {},
  entity?: number,
  hint?: string,
): number {
  if (typeof value !== 'number') {
    throw new PhysicsError('E_TYPE', `${field} must be a number, got ${describe(value)}.`, {
      entity,
      field,
      value,
      hint,
    });
  }
  if (!Number.isFinite(value)) {
    throw new PhysicsError('E_NONFINITE', `${field} must be finite, got ${value}.`, { entity, field, value, hint });
  }
  const problem = outOfBounds(value, bounds);
  if (problem !== undefined) {
    throw new PhysicsError('E_RANGE', `${field} must be ${problem}, got ${value}.`, { entity, field, value, hint });
  }
  return value;
}

function outOfBounds(value: number, bounds: Bounds): string | undefined {
  if (bounds.integer === true && !Number.isInteger(value)) return 'a whole number';
  if (bounds.above !== undefined && !(value > bounds.above)) return `greater than ${bounds.above}`;
  if (bounds.min !== undefined && value < bounds.min) return `at least ${bounds.min}`;
  if (bounds.max !== undefined && value > bounds.max) return `at most ${bounds.max}`;
  return undefined;
}

/** A vector a caller gives: absent axes are zero. */
export interface VectorInput {
  readonly x?: number;
  readonly y?: number;
  readonly z?: number;
}

/** A vector with all three axes. */
export interface Vector {
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

/**
 * A validated copy of a vector.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE; E_UNKNOWN for a key that is not an axis
 */
export function checkVector(value: unknown, field: string, bounds: Bounds = {}): Vector {
  if (typeof value !== 'object' || value === null) {
    throw new PhysicsError('E_TYPE', `${field} must be a vector { x, y, z }, got ${describe(value)}.`, {
      field,
      value,
    });
  }
  const vector = { x: 0, y: 0, z: 0 };
  for (const [axis, component] of Object.entries(value)) {
    if (axis !== 'x' && axis !== 'y' && axis !== 'z') {
      throw new PhysicsError('E_UNKNOWN', `${field} has no axis "${axis}".`, {
        field,
        value,
        hint: 'Give x, y and z.',
      });
    }
    vector[axis] = checkNumber(component, `${field}.${axis}`, bounds);
  }
  return vector;
}

/**
 * Writes the three axes of a vector to `out[at…]`, when it is one; makes no object, for what is called in every step.
 * @throws PhysicsError as `checkVector`; `out` may then hold a part of it
 */
export function readVector(out: Float64Array, at: number, value: VectorInput, field: string, bounds: Bounds): void {
  if (typeof value !== 'object' || value === null) checkVector(value, field, bounds);
  out[at] = out[at + 1] = out[at + 2] = 0;
  for (const axis in value) {
    const place = axis === 'x' ? 0 : axis === 'y' ? 1 : axis === 'z' ? 2 : -1;
    const component = value[axis as 'x'];
    const isGood = place >= 0 && Number.isFinite(component) && outOfBounds(component as number, bounds) === undefined;
    // Says what is wrong.
    if (!isGood) checkVector(value, field, bounds);
    else out[at + place] = component as number;
  }
}

/**
 * Refuses keys that are not in `known`, naming the nearest list of valid ones.
 * @throws PhysicsError E_TYPE, E_UNKNOWN
 */
export function checkKeys(value: unknown, what: string, known: readonly string[]): void {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) {
    throw new PhysicsError('E_TYPE', `${what} must be an object, got ${describe(value)}.`, { field: what, value });
  }
  for (const key of Object.keys(value)) {
    if (!known.includes(key)) {
      throw new PhysicsError('E_UNKNOWN', `${what} has no option "${key}".`, {
        field: key,
        value,
        hint: `Valid: ${known.join(', ')}.`,
      });
    }
  }
}

/** @throws PhysicsError E_TYPE */
export function checkFunction(value: unknown, field: string): void {
  if (typeof value !== 'function') {
    throw new PhysicsError('E_TYPE', `${field} must be a function, got ${describe(value)}.`, { field, value });
  }
}

/** The flag; false when it is left out. @throws PhysicsError E_TYPE */
export function checkFlag(value: unknown, field: string): boolean {
  if (value === undefined || typeof value === 'boolean') return value === true;
  throw new PhysicsError('E_TYPE', `${field} must be true or false, got ${describe(value)}.`, { field, value });
}

/** The word or number. @throws PhysicsError E_RANGE unless it is one of `choices` */
export function checkChoice<T extends string | number>(value: unknown, field: string, choices: readonly T[]): T {
  if (choices.includes(value as T)) return value as T;
  const all = choices.map((choice) => (typeof choice === 'string' ? `'${choice}'` : choice)).join(' or ');
  throw new PhysicsError('E_RANGE', `${field} must be ${all}, got ${String(value)}.`, { field, value });
}

/** @throws PhysicsError E_TYPE unless `value` is an object */
export function checkObject(value: unknown, field: string): void {
  if (typeof value === 'object' && value !== null) return;
  throw new PhysicsError('E_TYPE', `${field} must be an object, got ${describe(value)}.`, { field, value });
}

/** @throws PhysicsError E_TYPE unless `value` is an array, or undefined */
export function checkList(value: unknown, field: string): void {
  if (value !== undefined && !Array.isArray(value)) {
    throw new PhysicsError('E_TYPE', `${field} must be an array, got ${describe(value)}.`, { field, value });
  }
}

/** @throws PhysicsError E_TYPE unless `value` is an object whose `method` is a function */
export function checkHas(value: unknown, method: string, field: string, hint: string): void {
  const holder = value as Record<string, unknown> | null | undefined;
  if (typeof holder === 'object' && holder !== null && typeof holder[method] === 'function') return;
  throw new PhysicsError('E_TYPE', `${field} has no function \`${method}\`; it is ${describe(value)}.`, {
    field,
    value,
    hint,
  });
}
