import { describe, type FaultCode, PhysicsError } from './physics-error.ts';

/** Bounds of a number; `above` and `below` exclude the bound itself. */
export interface Bounds {
  readonly min?: number | undefined;
  readonly max?: number | undefined;
  readonly above?: number | undefined;
  readonly integer?: boolean | undefined;
  /** The hint of the error for a number that is out of bounds. Default none. */
  readonly hint?: string | undefined;
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
  const isNumber = typeof value === 'number';
  const expected = !isNumber ? 'a number' : !Number.isFinite(value) ? 'finite' : outOfBounds(value, bounds);
  if (expected === undefined) return value as number;
  const code = !isNumber ? 'E_TYPE' : Number.isFinite(value) ? 'E_RANGE' : 'E_NONFINITE';
  throw mustBe(expected, value, field, code, entity, hint ?? (code === 'E_RANGE' ? bounds.hint : undefined));
}

/** `checkNumber` for an integer; allocates no object, for values that are checked in every step. */
export function checkWhole(value: unknown, field: string, min: number, max: number, hint?: string): number {
  const isWhole = Number.isInteger(value) && (value as number) >= min && (value as number) <= max;
  return isWhole ? (value as number) : checkNumber(value, field, { min, max, integer: true }, undefined, hint);
}

/** Returns the error for an invalid value: "mass must be a number, got an object." */
export function mustBe(
  expected: string,
  value: unknown,
  field: string,
  code: FaultCode = 'E_TYPE',
  entity?: number,
  hint?: string,
): PhysicsError {
  return new PhysicsError(code, `${field} must be ${expected}, got ${describe(value)}.`, {
    entity,
    field,
    value,
    hint,
  });
}

/** Returns the error for an unknown name: "position has no field "w". Valid: x, y, z." */
export function unknownName(
  what: string,
  kind: string,
  name: unknown,
  known: readonly string[],
  entity?: number,
  more = '',
): PhysicsError {
  const hint = `Valid: ${known.join(', ') || 'none'}.${more}`;
  const field = typeof name === 'string' ? name : kind;
  const text = typeof name === 'string' ? `"${name}"` : describe(name);
  return new PhysicsError('E_UNKNOWN', `${what} has no ${kind} ${text}.`, { entity, field, value: name, hint });
}

/** Returns whether `checkNumber` accepts the value. */
export function isWithin(value: unknown, bounds: Bounds): value is number {
  return Number.isFinite(value) && outOfBounds(value as number, bounds) === undefined;
}

/**
 * Returns whether a column holds the value of a number within bounds: a column of f32 may round one that is near a bound to beyond it,
 * and what was read from a column must be accepted again.
 */
export function isStorable(value: unknown, bounds: Bounds): value is number {
  if (isWithin(value, bounds)) return true;
  return bounds.integer !== true && (isRoundingOf(value, bounds.min) || isRoundingOf(value, bounds.max));
}

function isRoundingOf(value: unknown, bound: number | undefined): boolean {
  return bound !== undefined && value === Math.fround(bound);
}

function outOfBounds(value: number, bounds: Bounds): string | undefined {
  if (bounds.integer === true && !Number.isInteger(value)) return 'a whole number';
  if (bounds.above !== undefined && !(value > bounds.above)) return `greater than ${bounds.above}`;
  if (bounds.min !== undefined && value < bounds.min) return `at least ${bounds.min}`;
  if (bounds.max !== undefined && value > bounds.max) return `at most ${bounds.max}`;
  return undefined;
}

/** A vector given by a caller: omitted axes are zero. */
export interface VectorInput {
  /** Default 0. */
  readonly x?: number;
  /** Default 0. */
  readonly y?: number;
  /** Default 0. */
  readonly z?: number;
}

/** A vector with all three axes. */
export interface Vector {
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

/**
 * Returns a validated copy of a vector.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE; E_UNKNOWN for a key that is not an axis
 */
export function checkVector(value: unknown, field: string, bounds: Bounds = {}): Vector {
  checkKeys(value, field, ['x', 'y', 'z'], 'axis');
  const vector = { x: 0, y: 0, z: 0 };
  // Points such as DOMPoint have accessors on the prototype, which Object.keys does not list.
  for (const axis of ['x', 'y', 'z'] as const) {
    const component = (value as VectorInput)[axis];
    if (component !== undefined || Object.hasOwn(value as object, axis)) {
      vector[axis] = checkNumber(component, `${field}.${axis}`, bounds);
    }
  }
  return vector;
}

/**
 * `checkVector` for a place. What a query found is one, whatever it tells beside x and y; a velocity or a direction it is not.
 * @throws PhysicsError as `checkVector`
 */
export function checkPoint(value: unknown, field: string, bounds: Bounds = {}): Vector {
  const isFound = isRecord(value) && typeof value.isWall === 'boolean';
  return checkVector(isFound ? { x: value.x, y: value.y } : value, field, bounds);
}

/**
 * Validates a vector and writes its three axes to `out[at…]`; allocates no object, for values that are read in every
 * step.
 * @throws PhysicsError as `checkVector`; `out` may then be partly written
 */
export function readVector(out: Float64Array, at: number, value: VectorInput, field: string, bounds: Bounds): void {
  if (!isRecord(value)) checkVector(value, field, bounds);
  out[at] = out[at + 1] = out[at + 2] = 0;
  for (const axis in value) {
    const index = axis === 'x' ? 0 : axis === 'y' ? 1 : axis === 'z' ? 2 : -1;
    const component = value[axis as 'x'];
    if (index >= 0 && isWithin(component, bounds)) out[at + index] = component;
    // This call throws the error with the details.
    else checkVector(value, field, bounds);
  }
}

/**
 * Rejects values that are not objects, and keys that are not in `known`; the message lists the valid keys.
 * @param kind the kind of key: an option, an axis
 * @throws PhysicsError E_TYPE, E_UNKNOWN
 */
export function checkKeys(value: unknown, what: string, known: readonly string[], kind = 'option'): void {
  if (!isRecord(value)) throw mustBe(`{ ${known.join(', ')} }`, value, what);
  for (const key of Object.keys(value)) {
    if (!known.includes(key)) throw unknownName(what, kind, key, known);
    if (value[key] === null) throw mustBe('left out or given a value', null, `${what}.${key}`);
  }
}

/** @throws PhysicsError E_TYPE */
export function checkFunction(value: unknown, field: string): void {
  if (typeof value !== 'function') throw mustBe('a function', value, field);
}

/** Validates an optional flag and returns it; the default is false. @throws PhysicsError E_TYPE */
export function checkFlag(value: unknown, field: string): boolean {
  if (value !== undefined && typeof value !== 'boolean') throw mustBe('true or false', value, field);
  return value === true;
}

/** Validates a text and returns it. @throws PhysicsError E_TYPE */
export function checkText(value: unknown, field: string): string {
  if (typeof value !== 'string') throw mustBe('a text', value, field);
  return value;
}

/** Validates a choice and returns it. @throws PhysicsError E_RANGE unless it is one of `choices` */
export function checkChoice<T extends string | number>(value: unknown, field: string, choices: readonly T[]): T {
  if (choices.includes(value as T)) return value as T;
  throw mustBe(choices.map(describe).join(' or '), value, field, 'E_RANGE');
}

/** @throws PhysicsError E_TYPE unless `value` is an object or an array */
export function checkObject(value: unknown, field: string): void {
  if (!isRecord(value) && !Array.isArray(value)) throw mustBe('an object', value, field);
}

/** @throws PhysicsError E_TYPE unless `value` is an array, or undefined */
export function checkList(value: unknown, field: string): void {
  if (value !== undefined && !Array.isArray(value)) throw mustBe('an array', value, field);
}

/** @throws PhysicsError E_TYPE unless `value` is an object whose `method` is a function */
export function checkHas(value: unknown, method: string, field: string, hint: string): void {
  if (isRecord(value) && typeof value[method] === 'function') return;
  throw mustBe(`an object with a function ${method}`, value, field, 'E_TYPE', undefined, hint);
}

/** Returns whether a value is an object with string keys. */
export function isRecord(value: unknown): value is Readonly<Record<string, unknown>> {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}
