// Saves a world and restores it bitwise: for rewinding, for look-ahead, for networks with rollback.
//
// All numbers are in the world's one memory, so a snapshot is a copy of it. It also holds the entities of bitECS, the
// lists of forces and systems, and state of features outside the memory.

import { assertIdle } from '../ecs/guards.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { isImmutable, ResourceKey } from '../memory/resource.ts';
import { PHASES } from '../world/phases.ts';
import type { PhysicsWorld, System } from '../world/types.ts';
import { noEntities, restoreEntities, saveEntities } from './entities.ts';
import { noImage, putImage, takeImage } from './memory-image.ts';
import { PlainRecord } from './plain-record.ts';

/** A saved state of a world. It can be restored to that world any number of times. */
export interface Snapshot {
  /** Simulated time, s, and number of steps. */
  readonly time: number;
  readonly tick: number;
  /** Size in bytes. */
  readonly bytes: number;
}

/**
 * Saves the world: bodies and their components, particle pools of emitters, random streams, contacts, state of
 * integrators, forces, systems, faults, and the objects passed to `keepState`. It does not save event handlers and
 * bitECS components that are not in the world's memory. Cost: one copy of the memory in use, and some microseconds.
 * @param spare a snapshot of this world that is no longer needed: it is overwritten and returned. Nothing is allocated
 *   then unless the world has grown
 * @throws PhysicsError E_REENTRANT inside a step, E_TYPE, E_DESTROYED
 */
export function snapshot(world: PhysicsWorld, spare?: Snapshot): Snapshot {
  assertIdle(world, 'snapshot');
  const content = spare === undefined ? new Content(world) : contentOf(world, spare, 'snapshot');
  content.take();
  return content;
}

/**
 * Restores the world: the next steps are bitwise equal to those after the snapshot. Bodies created since are removed,
 * bodies removed since are created again, and observers are called; a recreated body has the components of the package
 * and those that the world was created with. References, emitters and contact lists obtained since are invalid. Queries
 * may list bodies in another order; `bodies(world)` does not.
 * @throws PhysicsError E_TYPE for a snapshot of another world, E_REENTRANT, E_DESTROYED: nothing is changed
 * @throws AggregateError of exceptions of observers, after everything is restored
 */
export function restore(world: PhysicsWorld, snapshot: Snapshot): void {
  assertIdle(world, 'restore');
  const content = contentOf(world, snapshot, 'restore');
  content.assertWritable();
  const thrown = content.putBack();
  world.versions.restored++;
  if (thrown.length > 0) throw new AggregateError(thrown, `restore: observers threw ${thrown.length} exception(s).`);
}

/** Kernels and event listeners are not state. */
function isState(key: object): boolean {
  return key instanceof ResourceKey && !key.excludeFromSnapshot;
}

function contentOf(world: PhysicsWorld, snapshot: Snapshot, caller: string): Content {
  const found = Content.isContent(snapshot) ? snapshot : undefined;
  if (found?.world === world && found.isWhole) return found;
  const problem =
    found === undefined ? 'the argument is not a snapshot' : 'the snapshot is of another world, or incomplete';
  throw new PhysicsError('E_TYPE', `${caller}: ${problem}.`, {
    field: 'snapshot',
    hint: 'Pass a value that `snapshot(world)` returned for the same world.',
  });
}

/** The contents of a snapshot; the buffers are reused when the snapshot is taken again. */
class Content implements Snapshot {
  readonly #world: PhysicsWorld;
  time = 0;
  tick = 0;
  /** True once the snapshot was taken completely. */
  isWhole = false;
  readonly #image = noImage();
  readonly #entities = noEntities();
  /** Resources and their keys. */
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

  /** Unlike `instanceof`, it refuses objects that only inherit from a snapshot. */
  static isContent(value: unknown): value is Content {
    return typeof value === 'object' && value !== null && #world in value;
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
    // The lists hold forces and systems by reference; the snapshot does not save their own state.
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

  /** @throws PhysicsError E_TYPE if an object passed to `keepState` was frozen since the snapshot */
  assertWritable(): void {
    const frozen = this.#plain.findFrozen();
    if (frozen === undefined) return;
    throw new PhysicsError('E_TYPE', 'an object of the state was frozen since the snapshot, and cannot be restored.', {
      field: 'keepState',
      value: frozen,
      hint: 'Do not freeze what keepState was given, or mark what never changes with markImmutable.',
    });
  }

  /**
   * @returns exceptions of observers
   */
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
    world.internal.lastId = this.#lastId;
    world.time = this.time;
    world.tick = this.tick;
    // Compiled loops contain addresses of objects created since.
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
