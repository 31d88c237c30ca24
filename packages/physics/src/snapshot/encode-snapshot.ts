// Writes a snapshot as bytes, for a file or another machine.
import { isShape } from '../collision/shapes/2d/shape.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { type Block, blocksOf, type CarriedState } from '../memory/force-memory.ts';
import { KERNEL_SOURCES } from '../memory/layouts.gen.ts';
import { COMPUTED_ANEW, isImmutable, type ResourceKey } from '../memory/resource.ts';
import { PHASES } from '../world/phases.ts';
import type { PhysicsWorld, System } from '../world/types.ts';
import { addPlainObjects, type Content, type Scalars, type Snapshot } from './content.ts';
import { contentsOf, HOLE } from './contents.ts';
import { isDeeplyFrozen } from './deeply-frozen.ts';
import { type EncodedObject, type EncodedValue, partsOfWorld, prototypeOf, type WorldLists } from './encoded-values.ts';
import { keptForms } from './keep-state.ts';
import { type Copy, copyOf, ObjectCopy } from './object-copies.ts';
import { type ArrayPlace, BytesWriter, isNumberArray } from './packed-bytes.ts';
import { contentOf } from './snapshot.ts';

/** What the world must have in common with the one of the snapshot. */
export interface WorldForm {
  readonly version: string;
  readonly dimensions: number;
  readonly precision: string;
  readonly seed: number;
  readonly capacity: number;
  readonly memory: number;
  readonly components: readonly string[];
  readonly integrator: string;
  readonly forces: readonly string[];
  readonly systems: readonly string[];
  readonly kept: readonly string[];
}

export interface EncodedSnapshot {
  readonly form: WorldForm;
  readonly scalars: Readonly<Scalars>;
  readonly image: { readonly runs: readonly number[]; readonly top: number; readonly staggered: number };
  readonly imageBytes: ArrayPlace;
  readonly entities: Readonly<Record<'length' | 'alive' | 'maxId' | 'rows', number>>;
  readonly dense: ArrayPlace;
  readonly members: ArrayPlace;
  readonly moreMembers: ArrayPlace;
  /** The objects of the world that are in no resource. */
  readonly roots: readonly EncodedValue[];
  /** By the name of the resource, and its number among those of the same name. */
  readonly resources: readonly { readonly name: string; readonly number: number; readonly state: EncodedValue }[];
  readonly objects: readonly EncodedObject[];
  /** For each force, its memory if that changes what follows. */
  readonly forces: readonly (EncodedForce | null)[];
  readonly idle: readonly Block[];
}

export interface EncodedForce {
  readonly form: string;
  readonly state: CarriedState;
}

/**
 * Returns a snapshot as bytes, for a file, a worker or another machine, where `decodeSnapshot` reads them in a world made in the same way by
 * the same version of the package. Saved games that are to outlive an update are better written as JSON of what the game needs.
 * @throws PhysicsError E_TYPE for a value that is no snapshot; E_UNKNOWN if a resource of one's own has no `name`
 */
export function encodeSnapshot(snapshot: Snapshot): Uint8Array {
  const content = contentOf(snapshot, 'encodeSnapshot');
  const { world, parts } = content;
  const { scalars, image, entities } = parts;
  const bytes = new BytesWriter();
  const encoder = new ValueEncoder(content, bytes);
  const { top, staggered, layout } = image;
  const { runs, length } = layout;
  const roots: EncodedValue[] = [];
  addPlainObjects(world, (object) => roots.push(encoder.value(object)));
  const { dense, members, moreMembers, length: ids, alive, maxId, rows } = entities;
  const encoded: EncodedSnapshot = {
    form: formOf(world, content.lists, content.kept),
    scalars,
    image: { runs, top, staggered },
    imageBytes: bytes.add(image.bytes.subarray(0, length)),
    entities: { length: ids, alive, maxId, rows },
    dense: bytes.add(dense.subarray(0, ids)),
    members: bytes.add(members.subarray(0, rows)),
    moreMembers: bytes.add(moreMembers.subarray(0, rows)),
    roots,
    resources: encodeResources(content, encoder),
    objects: encoder.finish(),
    ...encodeForces(content),
  };
  return bytes.finish(encoded);
}

/** The memory of forces that is state, and that of the others, which is free in another world. */
function encodeForces({ lists, parts }: Content): Pick<EncodedSnapshot, 'forces' | 'idle'> {
  const states = new Map(parts.keys.map((key, i) => [key, parts.states[i]]));
  const forces = lists.forces.map(({ memory }) => {
    if (memory === undefined || !states.has(memory.key)) return null;
    return { form: memory.form, state: states.get(memory.key) as CarriedState };
  });
  for (const { memory } of lists.forces) if (memory !== undefined) states.delete(memory.key);
  return { forces, idle: [...parts.idle, ...[...states].flatMap(([key, state]) => blocksOf(key, state) ?? [])] };
}

/** The state of most forces and of boxes follows from their options: other worlds compute it again. */
function encodeResources({ parts: { keys, states } }: Content, encoder: ValueEncoder): EncodedSnapshot['resources'] {
  const counts = new Map<string, number>();
  const resources: EncodedSnapshot['resources'][number][] = [];
  keys.forEach((key, i) => {
    const { name } = key as ResourceKey;
    if (name === COMPUTED_ANEW || blocksOf(key, states[i]) !== undefined) return;
    if (name === '') throw withoutName(states[i]);
    const number = counts.get(name) ?? 0;
    counts.set(name, number + 1);
    resources.push({ name, number, state: encoder.value(states[i]) });
  });
  return resources;
}

function withoutName(state: unknown): PhysicsError {
  return new PhysicsError('E_UNKNOWN', 'encodeSnapshot: a resource has no name by which another world could find it.', {
    field: 'resource',
    value: state,
    hint: "Give it one: resource(create, { name: 'score' }).",
  });
}

/** What the world must have in common with another that takes its snapshot. */
export function formOf(
  world: PhysicsWorld,
  { integrator, forces, phases }: WorldLists,
  kept: readonly object[] | undefined,
): WorldForm {
  const { dimensions, precision, seed, capacity, memory, internal } = world;
  const nameOf = (each: { readonly name: string }) => each.name;
  return {
    version: KERNEL_SOURCES,
    dimensions,
    precision,
    seed,
    capacity,
    memory: memory.buffer.byteLength,
    components: [...internal.ownComponents.keys()].map(({ fields }) => Object.keys(fields).join(' ')),
    integrator: integrator.name,
    forces: forces.map(nameOf),
    systems: PHASES.flatMap((phase) => phases[phase].map((system) => `${phase}: ${nameOfSystem(system)}`)),
    kept: keptForms(kept),
  };
}

/** A name that minifiers leave alone. */
function nameOfSystem(system: System): string {
  return typeof system === 'function' ? (system.systemName ?? 'a function') : system.name;
}

class ValueEncoder {
  readonly #memory: ArrayBufferLike;
  readonly #bytes: BytesWriter;
  readonly #copies: ReadonlyMap<object, Copy>;
  /** The objects that values refer to, and their numbers. */
  readonly #numbers = new Map<object, number>();
  readonly #partNames: ReadonlyMap<unknown, string>;

  constructor({ world, lists, copies }: Content, bytes: BytesWriter) {
    this.#memory = world.memory.buffer;
    this.#bytes = bytes;
    this.#partNames = new Map([...partsOfWorld(world, lists)].map(([name, part]) => [part, name]));
    this.#copies = new Map(copies.map((copy) => [copy.target, copy]));
  }

  /** The objects that values refer to, after the values of all roots; each comes after one that refers to it. */
  finish(): EncodedObject[] {
    const objects: EncodedObject[] = [];
    // Further objects are added to the map meanwhile.
    for (const object of this.#numbers.keys()) objects.push(this.#object(object));
    return objects;
  }

  #object(object: object): EncodedObject {
    const copy = this.#copies.get(object) ?? copyOfFrozen(object);
    const { kind, values, names, numbers } = contentsOf(copy);
    const prototype = prototypeOf(copy.target);
    return {
      kind,
      values: values.map((value) => this.value(value)),
      ...(names && { names }),
      ...(numbers && { numbers: this.#bytes.add(numbers) }),
      ...(prototype && { prototype }),
      ...(!this.#copies.has(object) && { isFrozen: true }),
    };
  }

  value(value: unknown): EncodedValue {
    if (typeof value === 'number') return Number.isFinite(value) && !Object.is(value, -0) ? value : numberText(value);
    if (value === null || typeof value === 'string' || typeof value === 'boolean') return value;
    if (value === undefined) return ['undefined'];
    if (value === HOLE) return ['hole'];
    if (typeof value === 'bigint') return ['bigint', String(value)];
    const part = this.#partNames.get(value);
    if (part !== undefined) return ['world', part];
    return typeof value === 'object' ? this.#objectValue(value) : ['same'];
  }

  #objectValue(value: object): EncodedValue {
    if (ArrayBuffer.isView(value) && value.buffer === this.#memory && isNumberArray(value)) {
      return ['memory', [value.constructor.name, value.byteOffset, value.length]];
    }
    if (this.#copies.has(value)) return ['object', this.#numberOf(value)];
    if (isShape(value)) return ['shape', value];
    if (isImmutable(value)) return isPlainData(value, MAX_DEPTH) ? this.#immutable(value) : ['same'];
    return isDeeplyFrozen(value) ? ['object', this.#numberOf(value)] : ['same'];
  }

  #numberOf(object: object): number {
    const number = this.#numbers.get(object) ?? this.#numbers.size;
    this.#numbers.set(object, number);
    return number;
  }

  #immutable(value: object): EncodedValue {
    const encode = (item: unknown) =>
      typeof item === 'object' && item !== null ? this.#immutable(item) : this.value(item);
    if (Array.isArray(value)) return ['immutable', { kind: 'array', values: value.map(encode) }];
    return ['immutable', { kind: 'object', names: Object.keys(value), values: Object.values(value).map(encode) }];
  }
}

/** Frozen data does not change, so that a snapshot needs no copy of it until it is written. */
function copyOfFrozen(value: object): Copy {
  const copy = Object.getPrototypeOf(value) === null ? new ObjectCopy(value) : (copyOf(value) as Copy);
  copy.take(() => {});
  return copy;
}

/** Options are objects in objects, but not deep. */
const MAX_DEPTH = 8;

/** Whether a value consists of arrays, plain objects and what these may contain in JSON. */
function isPlainData(value: unknown, depth: number): boolean {
  if (typeof value !== 'object' || value === null) return typeof value !== 'function' && typeof value !== 'symbol';
  if (depth === 0 || (!Array.isArray(value) && Object.getPrototypeOf(value) !== Object.prototype)) return false;
  return Object.values(value).every((item) => isPlainData(item, depth - 1));
}

function numberText(value: number): EncodedValue {
  return ['number', Object.is(value, -0) ? '-0' : String(value)];
}
