import { collectThrown } from '../errors/collect-thrown.ts';
import type { Fault } from '../errors/fault-log.ts';
import { reportRejection } from '../errors/report-rejection.ts';
import { checkFunction, unknownName } from '../errors/validate.ts';
import { resource } from '../memory/resource.ts';
import { nameSystem } from './name-system.ts';
import type { PhysicsWorld } from './types.ts';

/** The events and the values that their handlers receive. */
export interface EventMap {
  /** Two bodies touched in this step: `index` into the arrays of `contacts(world)`. */
  contact: number;
  /** A body touched a wall in this step: `index` into the arrays of `wallContacts(world)`. */
  wallContact: number;
  /** The step corrected or quarantined a body; see `world.faults`. */
  fault: Fault;
}

/** The name of an event that `on` takes. */
export type EventName = keyof EventMap;
/** A function that is called for each event of a kind, in the last phase of the step. */
export type Handler<Name extends EventName> = (event: EventMap[Name], world: PhysicsWorld) => void;

interface Listener<Name extends EventName> {
  readonly handler: Handler<Name>;
  removed: boolean;
}

/** A list is replaced and never mutated, so a list that is being iterated does not change. */
type Listeners = { [Name in EventName]: readonly Listener<Name>[] };

const eventsOf = resource(
  () => ({
    listeners: { contact: [], wallContact: [], fault: [] } as Listeners,
    /** The events that systems of the world dispatch if there are handlers. */
    dispatched: new Set<EventName>(['fault']),
  }),
  { excludeFromSnapshot: true },
);

/**
 * Calls `handler` for each event of a step, in the last phase of the step. A handler may edit the world: its edits take
 * effect at the end of the step. An exception of a handler is thrown by `step` in an AggregateError; the world
 * continues. A handler added during dispatch receives the next event first; a removed handler receives no further
 * events.
 * @returns a function that removes the handler
 * @throws PhysicsError E_UNKNOWN for an unknown event, E_TYPE, E_DESTROYED
 */
export function on<Name extends EventName>(world: PhysicsWorld, name: Name, handler: Handler<Name>): () => void {
  const { listeners } = eventsOf(world);
  if (typeof name !== 'string' || !Object.hasOwn(listeners, name))
    throw unknownName('a world', 'event', name, Object.keys(listeners));
  checkFunction(handler, 'handler');
  const lists = listeners as { [N in EventName]: readonly Listener<Name>[] };
  const listener = { handler, removed: false };
  lists[name] = [...lists[name], listener];
  world.internal.reviewed.plan = undefined;
  return () => {
    listener.removed = true;
    lists[name] = lists[name].filter((other) => other !== listener);
  };
}

/** Returns whether the event has handlers. Systems that dispatch an event check this in every step. */
export function hasHandlers(world: PhysicsWorld, name: EventName): boolean {
  const { dispatched, listeners } = eventsOf(world);
  dispatched.add(name);
  return listeners[name].length > 0;
}

/** Returns the events that have handlers and that no system has dispatched so far. */
export function ignoredEvents(world: PhysicsWorld): EventName[] {
  const { dispatched, listeners } = eventsOf(world);
  const names = Object.keys(listeners) as EventName[];
  return names.filter((name) => listeners[name].length > 0 && !dispatched.has(name));
}

/** Calls every handler; an exception of one does not stop the others. */
export function emit<Name extends EventName>(world: PhysicsWorld, name: Name, event: EventMap[Name]): void {
  const list: readonly Listener<Name>[] = eventsOf(world).listeners[name];
  for (let i = 0; i < list.length; i++) {
    if (list[i].removed) continue;
    try {
      const result: unknown = list[i].handler(event, world);
      if (result instanceof Promise) reportRejection(world, `handler of "${name}"`, result);
    } catch (error) {
      collectThrown(world, error);
    }
  }
}

/** System of the `events` phase: dispatches the events of this step's faults. */
export const dispatchFaultEvents = /* @__PURE__ */ nameSystem('dispatch faults', (world: PhysicsWorld) => {
  const { stepFaults } = world.internal;
  if (stepFaults.length === 0 || !hasHandlers(world, 'fault')) return;
  for (let f = 0; f < stepFaults.length; f++) emit(world, 'fault', stepFaults[f]);
});
