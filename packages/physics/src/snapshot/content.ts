// The contents of a snapshot: the memory, the entities, the lists of forces and systems, and plain objects.

import { PhysicsError } from '../errors/physics-error.ts';
import { addIdleBlocks, type Block } from '../memory/force-memory.ts';
import { isImmutable, ResourceKey } from '../memory/resource.ts';
import { PHASES } from '../world/phases.ts';
import type { PhysicsWorld, Plan, System } from '../world/types.ts';
import type { WorldLists } from './encoded-values.ts';
import { noEntities, restoreEntities, type SavedEntities, saveEntities } from './entities.ts';
import { KEPT, keptList, keptObjects } from './keep-state.ts';
import { type MemoryImage, noImage, putImage, takeImage } from './memory-image.ts';
import type { ArrayCopy, Copy } from './object-copies.ts';
import { PlainRecord } from './plain-record.ts';
import { pathTo, refuseLoss } from './refuse-state.ts';

/** A saved state of a world. It can be restored to that world any number of times. */
export interface Snapshot {
  /** Simulated time, s, and number of steps. */
  readonly time: number;
  readonly tick: number;
  /** Size in bytes. */
  readonly bytes: number;
}

/** Numbers and flags of a world that are not in its memory. */
export interface Scalars {
  time: number;
  tick: number;
  lastId: number;
  rangesVersion: number;
  leavesOutWaiting: boolean;
  sweptRows: number;
  firstGeneration: number;
  recordsContacts: boolean;
  breaksSprings: boolean;
}

/** What a snapshot contains. */
export interface SnapshotParts {
  readonly scalars: Readonly<Scalars>;
  readonly image: MemoryImage;
  readonly entities: SavedEntities;
  /** Resources and their keys. */
  readonly keys: readonly object[];
  readonly states: readonly unknown[];
  /** Memory of forces that no longer exist. */
  readonly idle: readonly Block[];
}

/** Visits the objects of a world outside its memory that are in no resource and change as its state does. */
export function addPlainObjects({ faults, versions, ranges, internal }: PhysicsWorld, add: (o: object) => void): void {
  const { counts, partialEntities, templates, bodyList } = internal;
  add(counts);
  add(partialEntities);
  add(templates);
  add(faults);
  add(versions);
  add(ranges);
  add(bodyList);
}

/** Kernels and event listeners are not state. */
function isState(key: object): boolean {
  return key instanceof ResourceKey && !key.excludeFromSnapshot;
}

/** The contents of a snapshot; the buffers are reused when the snapshot is taken again. */
export class Content implements Snapshot {
  readonly #world: PhysicsWorld;
  /** True once the snapshot was taken completely. */
  isWhole = false;
  readonly #scalars: Scalars = { ...NO_SCALARS };
  #image = noImage();
  #entities = noEntities();
  readonly #keys: object[] = [];
  readonly #states: unknown[] = [];
  #count = 0;
  #idle: readonly Block[] = [];
  readonly #plain: PlainRecord;
  readonly #forces: unknown[] = [];
  readonly #phases = PHASES.map((): System[] => []);
  #integrator: PhysicsWorld['integrator'];
  #plan: Plan | undefined;
  /** How much of the plan the memory contains. */
  #made = 0;

  constructor(world: PhysicsWorld) {
    this.#world = world;
    this.#integrator = world.integrator;
    const { buffer } = world.memory;
    this.#plain = new PlainRecord(
      (value) =>
        value === world ||
        value === buffer ||
        isImmutable(value) ||
        (ArrayBuffer.isView(value) && value.buffer === buffer),
    );
  }

  /** Unlike `instanceof`, it refuses objects that only inherit from a snapshot. */
  static isContent(value: unknown): value is Content {
    return typeof value === 'object' && value !== null && #world in value;
  }

  get world(): PhysicsWorld {
    return this.#world;
  }

  get time(): number {
    return this.#scalars.time;
  }

  get tick(): number {
    return this.#scalars.tick;
  }

  get bytes(): number {
    const { dense, members } = this.#entities;
    return this.#image.bytes.length + dense.byteLength + members.byteLength;
  }

  get parts(): SnapshotParts {
    const [scalars, image, entities] = [this.#scalars, this.#image, this.#entities];
    return { scalars, image, entities, keys: this.#keys, states: this.#states, idle: this.#idle };
  }

  /** The lists as they were when the snapshot was taken. */
  get lists(): WorldLists {
    const phases = Object.fromEntries(
      PHASES.map((phase, p) => [phase, this.#phases[p]] as const),
    ) as unknown as WorldLists['phases'];
    return { integrator: this.#integrator, forces: this.#forces as PhysicsWorld['forces'], phases };
  }

  /** The objects that were kept when the snapshot was taken. */
  get kept(): readonly object[] | undefined {
    const list = this.#states[this.#keys.findIndex((key) => (key as ResourceKey).name === KEPT)];
    const copy = this.copies.find(({ target }) => target === list);
    return (copy as ArrayCopy | undefined)?.items as object[] | undefined;
  }

  /** Copies of the objects outside the memory. */
  get copies(): readonly Copy[] {
    return this.#plain.copies;
  }

  take(): void {
    this.isWhole = false;
    const { world } = this;
    takeImage(world, this.#image);
    saveEntities(world, this.#entities);
    this.#takePlain();
    this.#takeLists();
    this.#idle = [];
    copyScalars(this.#scalars, world, world.internal);
    this.#plan = world.internal.plan;
    this.#made = this.#plan?.made ?? 0;
    this.isWhole = true;
  }

  /** Takes the contents of another world, whose objects were turned into those of this one. */
  fill({ scalars, image, entities, keys, states, idle }: SnapshotParts, copies: readonly Copy[]): void {
    Object.assign(this.#scalars, scalars);
    this.#image = image;
    this.#entities = entities;
    refill(this.#keys, keys);
    refill(this.#states, states);
    this.#idle = idle;
    this.#plain.begin();
    for (const copy of copies) this.#plain.addCopy(copy);
    this.#plain.end();
    this.#takeLists();
    this.#plan = undefined;
    this.isWhole = true;
  }

  /** @throws PhysicsError E_TYPE if an object of the state cannot be written and differs from the snapshot */
  assertWritable(): void {
    const value = this.#plain.findUnwritable();
    if (value === undefined) return;
    const place = `object${pathTo(value, keptObjects(this.#world)) ?? ''}`;
    throw new PhysicsError('E_TYPE', `restore: ${place} is frozen or sealed, and differs from the snapshot.`, {
      field: place,
      value,
      hint: 'Freeze states as a whole and put others in their place, or do not freeze them.',
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
    const kept = keptList(world);
    const all = kept?.slice() ?? [];
    for (const [key, state] of [...resources]) if (isState(key) && state !== kept) resources.delete(key);
    for (let i = 0; i < this.#keys.length; i++) resources.set(this.#keys[i], this.#states[i]);
    putImage(world, this.#image);
    const { restored } = versions;
    this.#plain.putBack();
    // Of the kept objects the snapshot has those that came first; the others stay kept, with the values that they have.
    if (kept !== undefined) for (const object of all.slice(kept.length)) kept.push(object);
    // What the memory remembers of another world's versions must not come true here: sums of them only grow.
    versions.restored = Math.max(restored, versions.restored);
    addIdleBlocks(world, this.#idle);
    refill(world.forces, this.#forces as typeof world.forces);
    for (let p = 0; p < PHASES.length; p++) refill(world.phases[PHASES[p]], this.#phases[p]);
    world.integrator = this.#integrator;
    const { time, tick, ...others } = this.#scalars;
    Object.assign(world, { time, tick });
    Object.assign(internal, others);
    this.#putPlanBack();
    return thrown;
  }

  /** Compiled loops contain addresses, and values in memory: the plan stays only if all that it has was there already. */
  #putPlanBack(): void {
    const { internal, versions } = this.world;
    const { plan, reviewed } = internal;
    if (plan !== this.#plan || plan?.made !== this.#made) internal.plan = undefined;
    // Other bodies may come, by which the version gets the number that was reviewed.
    if (reviewed.membership !== versions.membership) reviewed.membership = -1;
  }

  /** The lists hold forces and systems by reference; the snapshot does not save their own state. */
  #takeLists(): void {
    const { world } = this;
    refill(this.#forces, world.forces);
    for (let p = 0; p < PHASES.length; p++) refill(this.#phases[p], world.phases[PHASES[p]]);
    this.#integrator = world.integrator;
  }

  #takePlain(): void {
    this.#count = 0;
    this.world.internal.resources.forEach(this.#noteResource);
    this.#keys.length = this.#count;
    this.#states.length = this.#count;
    const plain = this.#plain;
    plain.begin();
    plain.inspect = undefined;
    addPlainObjects(this.world, plain.add);
    for (let i = 0; i < this.#states.length; i++) {
      plain.inspect = (this.#keys[i] as ResourceKey).name === KEPT ? this.#inspect : undefined;
      plain.add(this.#states[i]);
    }
    plain.end();
  }

  readonly #inspect = (value: object, isCopied: boolean): void => refuseLoss(value, isCopied, keptObjects(this.#world));

  readonly #noteResource = (state: unknown, key: object): void => {
    if (!isState(key)) return;
    this.#keys[this.#count] = key;
    this.#states[this.#count++] = state;
  };
}

const NO_SCALARS: Readonly<Scalars> = {
  time: 0,
  tick: 0,
  lastId: 0,
  rangesVersion: 0,
  leavesOutWaiting: false,
  sweptRows: 0,
  firstGeneration: 0,
  recordsContacts: false,
  breaksSprings: false,
};

function copyScalars(into: Scalars, world: PhysicsWorld, internal: PhysicsWorld['internal']): void {
  into.time = world.time;
  into.tick = world.tick;
  into.lastId = internal.lastId;
  into.rangesVersion = internal.rangesVersion;
  into.leavesOutWaiting = internal.leavesOutWaiting;
  into.sweptRows = internal.sweptRows;
  into.firstGeneration = internal.firstGeneration;
  into.recordsContacts = internal.recordsContacts;
  into.breaksSprings = internal.breaksSprings;
}

function refill<T>(list: T[], items: readonly T[]): void {
  if (list.length !== items.length) list.length = items.length;
  for (let i = 0; i < items.length; i++) list[i] = items[i];
}
