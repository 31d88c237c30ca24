/** What went wrong, for programs; the message says it for people. */
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

/** Where and what: all optional, because not every fault has an entity or a field. */
export interface FaultDetails {
  readonly entity?: number | undefined;
  readonly field?: string | undefined;
  readonly value?: unknown;
  /** What to do about it. */
  readonly hint?: string | undefined;
}

/**
 * The one error of this package. Whoever throws it has changed nothing: the world is as it was before the call.
 */
export class PhysicsError extends Error {
  override readonly name = 'PhysicsError';
  readonly entity: number | undefined;
  readonly field: string | undefined;
  readonly value: unknown;
  readonly hint: string | undefined;

  constructor(
    readonly code: FaultCode,
    problem: string,
    details: FaultDetails = {},
  ) {
    super(`${code}: ${problem}${details.hint === undefined ? '' : ` ${details.hint}`}`);
    this.entity = details.entity;
    this.field = details.field;
    this.value = details.value;
    this.hint = details.hint;
  }
}

/** A value as it reads in a message: strings quoted, objects by their kind. */
export function describe(value: unknown): string {
  if (typeof value === 'string') return JSON.stringify(value);
  if (typeof value === 'bigint') return `${value}n`;
  if (typeof value === 'function') return 'a function';
  if (value === null || typeof value !== 'object') return String(value);
  return Array.isArray(value) ? 'an array' : 'an object';
}
