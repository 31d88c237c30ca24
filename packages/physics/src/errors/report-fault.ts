import type { PhysicsWorld } from '../world/types.ts';
import { FAULT_HINTS } from './fault-hints.ts';
import type { Fault } from './fault-log.ts';

/** Maximum number of faults kept per step and in the log. */
const MAX_FAULTS = 1024;

/** Records a fault of the present step in the log and in the step's list for event handlers. */
export function reportFault(world: PhysicsWorld, fault: Omit<Fault, 'step'>): void {
  const { faults: log, internal } = world;
  const dated = { hint: FAULT_HINTS[fault.code], ...fault, step: world.tick };
  if (internal.stepFaults.length < MAX_FAULTS) internal.stepFaults.push(dated);
  if (log.faults.length < MAX_FAULTS) log.faults.push(dated);
  else log.droppedCount++;
}
