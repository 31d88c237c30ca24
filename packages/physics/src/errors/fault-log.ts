import type { FaultCode } from './physics-error.ts';
import { checkList } from './validate.ts';

/** A fault the step found and dealt with. */
export interface Fault {
  readonly code: FaultCode;
  readonly entity: number;
  /** Component and field, as in "Velocity.x". */
  readonly field: string;
  /** The value that was found. */
  readonly value: number;
  /** `world.tick` of the step it was found in. */
  readonly step: number;
  /**
   * Where in the step: before it ('begin': someone wrote the value), in the integrator ('integrate': it could not keep its
   * tolerance) or after ('finish': a force or contact made it).
   */
  readonly phase: 'begin' | 'integrate' | 'finish';
  /** The law whose force was not finite, where that is known. */
  readonly law?: string | undefined;
  /** What to do about it. */
  readonly hint?: string | undefined;
}

/** The faults since the log was last cleared: the first 1024, and how many more there were. */
export interface FaultLog {
  readonly faults: Fault[];
  /** Faults not kept because the log was full. */
  droppedCount: number;
}

export function createFaultLog(): FaultLog {
  return { faults: [], droppedCount: 0 };
}

/** Empties the log. @throws PhysicsError E_TYPE for what is no log */
export function clearFaults(log: FaultLog): void {
  checkList(log?.faults ?? null, 'clearFaults: log.faults');
  log.faults.length = 0;
  log.droppedCount = 0;
}
