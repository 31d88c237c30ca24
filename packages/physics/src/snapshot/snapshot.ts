// A world put aside, and brought back to the bit: for rewinding, for trying something out, for networks that roll back.
//
// All numbers lie in the world's one memory, so that a snapshot is a copy of it. Beside it go the entities of bitECS,
// the lists of forces and systems, and what features remember outside the memory.

import { assertIdle } from '../ecs/guards.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { isImmutable, ResourceKey } from '../memory/resource.ts';
import { PHASES } from '../world/phases.ts';
import type { PhysicsWorld, System } from '../world/types.ts';
import { noEntities, restoreEntities, saveEntities } from './entities.ts';
import { noImage, putImage, takeImage } from './memory-image.ts';
import { PlainRecord } from './plain-record.ts';

/** A world as it was. It belongs to that world, and serves any number of times. */
export interface Snapshot {
  /** Simulated time, s, and steps done. */
  readonly time: number;
  readonly tick: number;
  /** Memory it takes. */
  readonly bytes: number;
}

/**
 * Puts the world aside: bodies and their components, pools of emitters, random streams, contacts, memories of
 * integrators, forces, systems, faults, and what was named to `keepState`. Not: handlers of events, and components of
 * your own. Cost: one copy of the memory in use, and some microseconds.
 * @param spare a snapshot of this world that is no longer needed: it becomes the one of now and is returned. Nothing
 *   is allocated then, unless the world has grown
 * @throws PhysicsError E_REENTRANT inside a step, E_TYPE, E_DESTROYED
 */
export function snapshot(world: PhysicsWorld, spare?: Snapshot): Snapshot {
  assertIdle(world, 'snapshot');
  const content = spare === undefined ? new Content(world) : contentOf(world, spare, 'snapshot');
  content.take();
  return content;
}

/**
 * Makes the world what it was: the next steps are the same to the bit as those after the snapshot. Bodies that came and
 * went since do so again, and observers hear of it; a body brought back has its components of physics only. References,
 * emitters and contact lists handed out since belong to the future that was given up. Queries may list bodies in
 * another order; `bodies(world)` does not.
 * @throws PhysicsError E_TYPE for a snapshot of another world, E_REENTRANT, E_DESTROYED: nothing is changed
 * @throws AggregateError of what observers threw, when all is restored
 */
export function restore(world: PhysicsWorld, taken: Snapshot): void {
  assertIdle(world, 'restore');
  const content = contentOf(world, taken, 'restore');
  content.assertWritable();
  const thrown = content.putBack();
  world.versions.restored++;
  if (thrown.length > 0) throw new AggregateError(thrown, `restore: observers threw ${thrown.length} error(s).`);
}

/** Kernels, and who listens, are not state. */
function isState(key: object): boolean {
  return key instanceof ResourceKey && !key.outlives;
}

function contentOf(world: PhysicsWorld, taken: Snapshot, caller: string): Content {
  const found = taken instanceof Content ? taken : undefined;
  if (found?.world === world && found.isWhole) return found;
  const problem = found === undefined ? 'this is no snapshot' : 'this snapshot is of another world, or incomplete';
  throw new PhysicsError('E_TYPE', `${caller}: ${problem}.`, {
    field: 'snapshot',
    hint: 'Use what `snapshot(world)` returned for this very world.',
  });
}

/** What a snapshot holds: everything it needs is kept and written again when it is taken anew. */
class Content implements Snapshot {
  readonly #world: PhysicsWorld;
  time = 0;
  tick = 0;
  /** Whether it was taken to the end. */
  isWhole = false;
  readonly #image = noImage();
  readonly #entities = noEntities();
  /** Resources, and under which keys. */
  readonly #keys: object[] = [];
  readonly #states: unknown[] = [];
  #count = 0;
  readonly #plain: PlainRecord;
  readonly #forces: unknown[] = [];
  readonly #phases = PHASES.map((): System[] => []);
  #integrator: PhysicsWorld['integrator'];
  #lastId = 0;
  #rangesVersion = 0;
  #sweptRows = 0;

  constructor(world: PhysicsWorld) {
    this.#world = world;
    this.#integrator = world.integrator;
    const { buffer } = world.memory;
    this.#plain = new PlainRecord(
      (value) => value === world || isImmutable(value) || (ArrayBuffer.isView(value) && value.buffer === buffer),
    );
  }

  get world(): PhysicsWorld {
    return this.#world;
  }

  get bytes(): number {
    const { dense, members } = this.#entities;
    return this.#image.bytes.length + dense.byteLength + members.byteLength;
  }

  take(): void {
    this.isWhole = false;
    const { world } = this;
    const { internal } = world;
    takeImage(world, this.#image);
    saveEntities(world, this.#entities);
    this.#takePlain();
    // Forces and systems are told by name in the lists; what they are made of is theirs.
    refill(this.#forces, world.forces);
    for (let p = 0; p < PHASES.length; p++) refill(this.#phases[p], world.phases[PHASES[p]]);
    this.#integrator = world.integrator;
    this.#lastId = world.lastId;
    this.#rangesVersion = internal.rangesVersion;
    this.#sweptRows = internal.sweptRows;
    this.time = world.time;
    this.tick = world.tick;
    this.isWhole = true;
  }

  /** @throws PhysicsError E_TYPE when an object named to `keepState` was frozen since */
  assertWritable(): void {
    const frozen = this.#plain.findFrozen();
    if (frozen === undefined) return;
    throw new PhysicsError('E_TYPE', 'an object of the state was frozen since the snapshot, and cannot be restored.', {
      field: 'keepState',
      value: frozen,
      hint: 'Do not freeze what keepState was given, or mark what never changes with markImmutable.',
    });
  }

  /** @returns what observers threw */
  putBack(): unknown[] {
    const { world } = this;
    const { internal, versions } = world;
    const thrown = restoreEntities(world, this.#entities);
    const { resources } = internal;
    for (const key of [...resources.keys()]) if (isState(key)) resources.delete(key);
    for (let i = 0; i < this.#keys.length; i++) resources.set(this.#keys[i], this.#states[i]);
    putImage(world, this.#image);
    const { restored } = versions;
    this.#plain.putBack();
    versions.restored = restored;
    refill(world.forces, this.#forces as typeof world.forces);
    for (let p = 0; p < PHASES.length; p++) refill(world.phases[PHASES[p]], this.#phases[p]);
    world.integrator = this.#integrator;
    world.lastId = this.#lastId;
    world.time = this.time;
    world.tick = this.tick;
    // Compiled loops know addresses of what was made since.
    internal.plan = undefined;
    internal.rangesVersion = this.#rangesVersion;
    internal.sweptRows = this.#sweptRows;
    return thrown;
  }

  #takePlain(): void {
    const { faults, versions, ranges, internal } = this.world;
    const { counts, partialEntities, templates, bodyList, resources } = internal;
    this.#count = 0;
    resources.forEach(this.#noteResource);
    this.#keys.length = this.#count;
    this.#states.length = this.#count;
    const plain = this.#plain;
    plain.begin();
    plain.add(counts);
    plain.add(partialEntities);
    plain.add(templates);
    plain.add(faults);
    plain.add(versions);
    plain.add(ranges);
    plain.add(bodyList);
    for (let i = 0; i < this.#states.length; i++) plain.add(this.#states[i]);
    plain.end();
  }

  readonly #noteResource = (state: unknown, key: object): void => {
    if (!isState(key)) return;
    this.#keys[this.#count] = key;
    this.#states[this.#count++] = state;
  };
}

function refill<T>(list: T[], items: readonly T[]): void {
  if (list.length !== items.length) list.length = items.length;
  for (let i = 0; i < items.length; i++) list[i] = items[i];
}
