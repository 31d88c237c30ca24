import type { Fault } from '../faults/fault-log';
import { assertUsable } from '../store/guards';
import { resource } from '../store/resource';
import type { PhysicsWorld } from '../world';

/** What a handler can be told of, and what it gets. */
export interface EventMap {
  /** Two bodies touched in this step: `index` into the arrays of `contacts(world)`. */
  contact: number;
  /** The step put a body right; see `world.faults`. */
  fault: Fault;
}

export type EventName = keyof EventMap;
export type Handler<Name extends EventName> = (event: EventMap[Name], world: PhysicsWorld) => void;

type Handlers = { [Name in EventName]: Handler<Name>[] };

const handlersOf = resource<Handlers>(() => ({ contact: [], fault: [] }));

/**
 * Calls `handler` for each event of a step, in the step's last phase. A handler may edit the world: its edits take
 * effect when the step ends. What it throws comes out of `step` as an AggregateError; the world goes on.
 * @returns a function that takes the handler away again
 * @throws PhysicsError E_DESTROYED
 */
export function on<Name extends EventName>(world: PhysicsWorld, name: Name, handler: Handler<Name>): () => void {
  assertUsable(world);
  const list: Handler<Name>[] = handlersOf(world)[name];
  list.push(handler);
  return () => {
    const at = list.indexOf(handler);
    if (at >= 0) list.splice(at, 1);
  };
}

/** Whether anybody listens. */
export function hasHandlers(world: PhysicsWorld, name: EventName): boolean {
  return handlersOf(world)[name].length > 0;
}

/** Tells every handler; what one throws does not stop the others. */
export function emit<Name extends EventName>(world: PhysicsWorld, name: Name, event: EventMap[Name]): void {
  const list: Handler<Name>[] = handlersOf(world)[name];
  for (let i = 0; i < list.length; i++) {
    try {
      (list[i] as Handler<Name>)(event, world);
    } catch (error) {
      world.internal.thrown.push(error);
    }
  }
}

/** System of the `events` phase: tells of this step's faults. */
export function tellFaults(world: PhysicsWorld): void {
  const { newFaults } = world.internal;
  if (newFaults === 0 || !hasHandlers(world, 'fault')) return;
  for (const fault of world.faults.faults.slice(-newFaults)) emit(world, 'fault', fault);
}
