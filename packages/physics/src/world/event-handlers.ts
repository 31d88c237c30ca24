import { collectThrown } from '../errors/collect-thrown.ts';
import type { Fault } from '../errors/fault-log.ts';
import { checkFunction, unknownName } from '../errors/validate.ts';
import { resource } from '../memory/resource.ts';
import type { PhysicsWorld } from './types.ts';

/** What a handler can be told of, and what it gets. */
export interface EventMap {
  /** Two bodies touched in this step: `index` into the arrays of `contacts(world)`. */
  contact: number;
  /** The step put a body right; see `world.faults`. */
  fault: Fault;
}

export type EventName = keyof EventMap;
export type Handler<Name extends EventName> = (event: EventMap[Name], world: PhysicsWorld) => void;

interface Listener<Name extends EventName> {
  readonly handler: Handler<Name>;
  gone: boolean;
}

/** Lists are replaced, never changed: one that is being told through stays as it is. */
type Listeners = { [Name in EventName]: readonly Listener<Name>[] };

const listenersOf = resource<Listeners>(() => ({ contact: [], fault: [] }), { outlives: true });

/**
 * Calls `handler` for each event of a step, in the step's last phase. A handler may edit the world: its edits take
 * effect when the step ends. What it throws comes out of `step` as an AggregateError; the world goes on. A handler
 * added while handlers are told hears of the next event first; one taken away hears nothing more.
 * @returns a function that takes the handler away again
 * @throws PhysicsError E_UNKNOWN for an event there is not, E_TYPE, E_DESTROYED
 */
export function on<Name extends EventName>(world: PhysicsWorld, name: Name, handler: Handler<Name>): () => void {
  const listeners = listenersOf(world);
  if (!Object.hasOwn(listeners, name)) throw unknownName('a world', 'event', String(name), Object.keys(listeners));
  checkFunction(handler, 'handler');
  const lists = listeners as { [N in EventName]: readonly Listener<Name>[] };
  const listener = { handler, gone: false };
  lists[name] = [...lists[name], listener];
  return () => {
    listener.gone = true;
    lists[name] = lists[name].filter((other) => other !== listener);
  };
}

/** Whether anybody listens. */
export function hasHandlers(world: PhysicsWorld, name: EventName): boolean {
  return listenersOf(world)[name].length > 0;
}

/** Tells every handler; what one throws does not stop the others. */
export function emit<Name extends EventName>(world: PhysicsWorld, name: Name, event: EventMap[Name]): void {
  const list: readonly Listener<Name>[] = listenersOf(world)[name];
  for (let i = 0; i < list.length; i++) {
    if (list[i].gone) continue;
    try {
      list[i].handler(event, world);
    } catch (error) {
      collectThrown(world, error);
    }
  }
}

/** System of the `events` phase: tells of this step's faults. */
export function dispatchFaultEvents(world: PhysicsWorld): void {
  const { stepFaults } = world.internal;
  if (stepFaults.length === 0 || !hasHandlers(world, 'fault')) return;
  for (let f = 0; f < stepFaults.length; f++) emit(world, 'fault', stepFaults[f]);
}
