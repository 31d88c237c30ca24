// A world put aside, and brought back to the bit: for rewinding, for trying something out, for networks that roll back.
//
// All numbers lie in the world's one memory, so that a snapshot is a copy of it. Beside it go the entities of bitECS,
// the lists of forces and systems, and what features remember outside the memory.
import { PhysicsError } from '../faults/physics-error';
import { PHASES, type System } from '../schedule/phases';
import { assertIdle } from '../store/guards';
import { ResourceKey } from '../store/resource';
import type { PhysicsWorld } from '../world';
import { restoreEntities, type SavedEntities, saveEntities } from './entities';
import { type MemoryImage, putImage, takeImage } from './memory-image';
import { type PutBack, savePlain } from './plain-state';

declare const content: unique symbol;

/** A world as it was. It belongs to that world, and serves any number of times. */
export interface Snapshot {
  /** Simulated time, s, and steps done. */
  readonly time: number;
  readonly tick: number;
  /** Memory it takes. */
  readonly bytes: number;
  readonly [content]?: never;
}

/** What a snapshot holds. */
interface Content {
  readonly world: PhysicsWorld;
  readonly image: MemoryImage;
  readonly entities: SavedEntities;
  readonly putBack: PutBack;
  readonly resources: ReadonlyMap<object, unknown>;
}

const contents = new WeakMap<Snapshot, Content>();

/**
 * Puts the world aside: bodies and their components, pools of emitters, random streams, contacts, memories of
 * integrators, forces, systems, faults. Not: handlers of events, components of your own, and whatever your own systems
 * keep for themselves. Cost: one copy of the memory in use, and some microseconds.
 * @param spare a snapshot of this world that is no longer needed: its memory is used again, and it cannot be restored
 * @throws PhysicsError E_REENTRANT inside a step, E_TYPE, E_DESTROYED
 */
export function snapshot(world: PhysicsWorld, spare?: Snapshot): Snapshot {
  assertIdle(world, 'snapshot');
  const old = spare === undefined ? undefined : contentOf(world, spare, 'snapshot');
  if (spare !== undefined) contents.delete(spare);
  const resources = new Map([...world.internal.resources].filter(([key]) => isState(key)));
  const image = takeImage(world, old?.image);
  const taken: Snapshot = { time: world.time, tick: world.tick, bytes: image.bytes.length };
  contents.set(taken, {
    world,
    image,
    entities: saveEntities(world),
    putBack: saveRecords(world, resources),
    resources,
  });
  return taken;
}

/**
 * Makes the world what it was: the next steps are the same to the bit as those after the snapshot. Bodies that came and
 * went since do so again, and observers hear of it; a body brought back has its components of physics only. References,
 * emitters and contact lists handed out since belong to the future that was given up. Queries may list bodies in
 * another order; `bodies(world)` does not.
 * @throws PhysicsError E_TYPE for a snapshot of another world or one given away as spare, E_REENTRANT, E_DESTROYED:
 *   nothing is changed
 * @throws AggregateError of what observers threw, when all is restored
 */
export function restore(world: PhysicsWorld, taken: Snapshot): void {
  assertIdle(world, 'restore');
  const { image, entities, putBack, resources } = contentOf(world, taken, 'restore');
  const thrown = restoreEntities(world, entities);
  const { resources: present } = world.internal;
  for (const key of [...present.keys()]) if (isState(key)) present.delete(key);
  for (const [key, state] of resources) present.set(key, state);
  putImage(world, image);
  putBack();
  world.versions.restored++;
  if (thrown.length > 0) throw new AggregateError(thrown, `restore: observers threw ${thrown.length} error(s).`);
}

/** Kernels, and who listens, are not state. */
function isState(key: object): boolean {
  return key instanceof ResourceKey && !key.outlives;
}

function contentOf(world: PhysicsWorld, taken: Snapshot, caller: string): Content {
  const found = typeof taken === 'object' && taken !== null ? contents.get(taken) : undefined;
  if (found?.world === world) return found;
  const problem =
    found === undefined ? 'this is no snapshot, or it was given away' : 'this snapshot is of another world';
  throw new PhysicsError('E_TYPE', `${caller}: ${problem}.`, {
    field: 'snapshot',
    hint: 'Use what `snapshot(world)` returned for this very world.',
  });
}

/** Everything outside the memory. */
function saveRecords(world: PhysicsWorld, resources: ReadonlyMap<object, unknown>): PutBack {
  const { time, tick, lastId, integrator, forces, phases, spans, faults, internal } = world;
  const versions = { ...world.versions };
  const lists = { forces: [...forces], phases: PHASES.map((phase) => [...phases[phase]]) };
  const { counts, incomplete, templates, bodyList, spansVersion, sweptRows } = internal;
  const spanCount = spans.count;
  const bodyCount = bodyList.count;
  const { buffer } = world.memory;
  // Forces and systems are told by name in the lists; what they are made of is theirs.
  const isForeign = (value: object) => value === world || (ArrayBuffer.isView(value) && value.buffer === buffer);
  const records = savePlain([counts, incomplete, templates, faults, ...resources.values()], isForeign);
  return () => {
    records();
    Object.assign(world, { time, tick, lastId, integrator });
    Object.assign(world.versions, versions, { restored: world.versions.restored });
    Object.assign(internal, { spansVersion, sweptRows });
    spans.count = spanCount;
    bodyList.count = bodyCount;
    refill(forces, lists.forces);
    for (const [p, phase] of PHASES.entries()) refill<System>(phases[phase], lists.phases[p]);
  };
}

function refill<T>(list: T[], items: readonly T[]): void {
  list.length = 0;
  list.push(...items);
}
