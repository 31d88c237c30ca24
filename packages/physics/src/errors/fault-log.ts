import type { FaultCode } from './physics-error.ts';
import { checkList } from './validate.ts';

/** A fault that the step found and handled. */
export interface Fault {
  readonly code: FaultCode;
  readonly entity: number;
  /** Component and field, as in "Velocity.x"; of E_STEP "sub-step". */
  readonly field: string;
  /** The value that was found; of E_STEP the sub-step that the body would have needed, s. */
  readonly value: number;
  /** `world.tick` of the step that found it. */
  readonly step: number;
  /**
   * Where the step found it: before the step ('begin': user code wrote the value), in the integrator ('integrate': it
   * could not keep its tolerance) or after ('finish': a force or contact caused it).
   */
  readonly phase: 'begin' | 'integrate' | 'finish';
  /** The law whose force was not finite, if known. */
  readonly law?: string | undefined;
  /** How to fix it. */
  readonly hint?: string | undefined;
}

/** The first 1024 faults since the log was last cleared, and the number of further faults. */
export interface FaultLog {
  readonly faults: Fault[];
  /** Number of faults not kept because the log was full. */
  droppedCount: number;
}

export function createFaultLog(): FaultLog {
  return { faults: [], droppedCount: 0 };
}

/** Clears the log. @throws PhysicsError E_TYPE if the argument is not a fault log */
export function clearFaults(log: FaultLog): void {
  checkList(log?.faults ?? null, 'clearFaults: log.faults');
  log.faults.length = 0;
  log.droppedCount = 0;
}
