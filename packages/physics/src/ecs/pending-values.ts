// What edits of the running step will write when it ends. A component that is completed from the values that it has (values.ts) is
// completed from these too, so that two edits of one step add up as they do between steps.
import type { ComponentName } from '../components/all.ts';
import type { FieldValues, PhysicsWorld } from '../world/types.ts';

const keyOf = (eid: number, name: ComponentName) => `${name} ${eid}`;

/** The values that will be written to a component by then; undefined if there are none. */
export function pendingValues({ internal }: PhysicsWorld, eid: number, name: ComponentName): FieldValues | undefined {
  return internal.edits.pending.get(keyOf(eid, name));
}

/** Notes values that are written when the step ends. */
export function notePending(world: PhysicsWorld, eid: number, name: ComponentName, values: FieldValues): void {
  if (world.state !== 'stepping') return;
  world.internal.edits.pending.set(keyOf(eid, name), { ...pendingValues(world, eid, name), ...values });
}

/** Forgets what was to be written to a component that has been added since. */
export function forgetPending({ internal }: PhysicsWorld, eid: number, name: ComponentName): void {
  const { pending } = internal.edits;
  if (pending.size > 0) pending.delete(keyOf(eid, name));
}
