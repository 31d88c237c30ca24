import type { PhysicsWorld } from '../world/types.ts';
import { FAULT_HINTS } from './fault-hints.ts';
import type { Fault } from './fault-log.ts';

/** Faults kept of one step, and in the log. */
const MAX_FAULTS = 1024;

/** Enters a fault of the present step in the log, and in the list of the step's that handlers are told of. */
export function reportFault(world: PhysicsWorld, fault: Omit<Fault, 'step'>): void {
  const { faults: log, internal } = world;
  const dated = { hint: FAULT_HINTS[fault.code], ...fault, step: world.tick };
  if (internal.stepFaults.length < MAX_FAULTS) internal.stepFaults.push(dated);
  if (log.faults.length < MAX_FAULTS) log.faults.push(dated);
  else log.droppedCount++;
}
