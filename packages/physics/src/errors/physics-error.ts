/** The kind of an error, for programs; the message is for people. */
export type FaultCode =
  | 'E_TYPE'
  | 'E_NONFINITE'
  | 'E_RANGE'
  | 'E_UNKNOWN'
  | 'E_STALE'
  | 'E_CAPACITY'
  | 'E_REENTRANT'
  | 'E_DESTROYED'
  | 'E_STIFF'
  | 'E_STEP'
  | 'E_CONVERGENCE'
  | 'E_SPEED';

/**
 * Where and with which value an error occurred. All fields are optional, because not every error has an entity or a
 * field.
 */
export interface FaultDetails {
  readonly entity?: number | undefined;
  readonly field?: string | undefined;
  readonly value?: unknown;
  /** How to fix it. */
  readonly hint?: string | undefined;
}

/** The error class of this package. A function that throws it leaves the world unchanged. */
export class PhysicsError extends Error {
  override readonly name = 'PhysicsError';
  readonly entity: number | undefined;
  readonly field: string | undefined;
  declare readonly value: unknown;
  readonly hint: string | undefined;

  constructor(
    readonly code: FaultCode,
    problem: string,
    details: FaultDetails = {},
  ) {
    super(`${code}: ${problem}${details.hint === undefined ? '' : ` ${details.hint}`}`);
    this.entity = details.entity;
    this.field = details.field;
    // Consoles print the enumerable properties of an uncaught error: a list of points would hide the message.
    const { value } = details;
    Object.defineProperty(this, 'value', { value, enumerable: typeof value !== 'object' });
    this.hint = details.hint;
  }
}

/** Formats a value for a message: strings are quoted, objects named by their kind. */
export function describe(value: unknown): string {
  if (typeof value === 'string') return JSON.stringify(value);
  if (typeof value === 'bigint') return `${value}n`;
  if (typeof value === 'function') return 'a function';
  if (value === null || typeof value !== 'object') return String(value);
  return Array.isArray(value) ? 'an array' : 'an object';
}
