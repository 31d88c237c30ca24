// Reads a snapshot that another world wrote: what it says of objects is told of those of this world.
import { isShape, type Shape } from '../collision/shapes/2d/shape.ts';
import { adoptShape } from '../collision/shapes/store-shape.ts';
import { assertIdle } from '../ecs/guards.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import type { Block } from '../memory/force-memory.ts';
import { isImmutable, markImmutable, onlyKeyNamed, ResourceKey, stateAt } from '../memory/resource.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { addPlainObjects, Content, type Snapshot } from './content.ts';
import { type Contents, copyWith, HOLE } from './contents.ts';
import { type EncodedSnapshot, formOf, type WorldForm } from './encode-snapshot.ts';
import { type EncodedObject, type EncodedValue, partsOfWorld, prototypeOf } from './encoded-values.ts';
import { keptList } from './keep-state.ts';
import type { Copy } from './object-copies.ts';
import { type ArrayPlace, BytesReader, makeArray } from './packed-bytes.ts';

/**
 * Reads what `encodeSnapshot` wrote, as a snapshot of this world: `restore` then makes this world go on as the other would have,
 * to the bit. The world must have been made as the other was: with the same options, forces, systems, emitters and calls of
 * `keepState`. Its bodies, joints and springs may differ. Of kept objects the number, the kinds and the fields at the time of
 * `keepState` are compared: two with the same fields in another order cannot be told apart. The world stays as it is until `restore`,
 * after which lists such as `contacts(world)` have to be asked for again, because they lie elsewhere in the memory.
 * @throws PhysicsError E_TYPE for bytes that are no snapshot or of a world made otherwise, E_REENTRANT, E_DESTROYED
 */
export function decodeSnapshot(world: PhysicsWorld, bytes: Uint8Array): Snapshot {
  assertIdle(world, 'decodeSnapshot');
  const reader = new BytesReader(bytes);
  const encoded = reader.header as EncodedSnapshot;
  assertSameForm(world, encoded.form);
  const { keys, existing } = findResources(world, encoded.resources);
  const decoder = new ValueDecoder(world, encoded.objects, reader);
  let root = 0;
  addPlainObjects(world, (object) => decoder.value(encoded.roots[root++], object, 'the world'));
  const states = encoded.resources.map(({ name, state }, i) => decoder.value(state, existing[i], name));
  const copies = decoder.finish();
  const { runs, top, staggered } = encoded.image;
  const image = reader.array<Uint8Array>(encoded.imageBytes);
  const [dense, members, moreMembers] = [encoded.dense, encoded.members, encoded.moreMembers].map((place) =>
    reader.array<Uint32Array>(place),
  );
  const content = new Content(world);
  const parts = {
    scalars: encoded.scalars,
    image: { layout: { runs, views: [], length: image.length, top }, bytes: image, top, staggered },
    entities: { ...encoded.entities, dense, members, moreMembers },
    keys,
    states,
    idle: [...encoded.idle],
  };
  takeForces(world, encoded.forces, parts);
  content.fill(parts, copies);
  return content;
}

function assertSameForm(world: PhysicsWorld, form: WorldForm): void {
  const here = formOf(world, world, keptList(world));
  for (const field of Object.keys(here) as (keyof WorldForm)[]) {
    if (field === 'kept') assertSameKept(form.kept, here.kept);
    const [theirs, ours] = [JSON.stringify(form[field]), JSON.stringify(here[field])];
    if (theirs !== ours) throw differs(field === 'version' ? 'the version of the package' : field, theirs, ours);
  }
}

/** Kept objects have no names: the first of one world gets the values of the first of the other, and so on. */
function assertSameKept(theirs: readonly string[], ours: readonly string[]): void {
  const hint =
    'Pass keepState as many objects as in the program that saved, in the same order, and with the same fields. What has other names from game to game belongs in a Map, or in a field of a kept object.';
  if (theirs.length !== ours.length) {
    throw differs('the number of objects passed to keepState', String(theirs.length), String(ours.length), hint);
  }
  const i = theirs.findIndex((form, at) => form !== ours[at]);
  if (i >= 0) throw differs(`object[${i}] of those passed to keepState`, theirs[i], ours[i], hint);
}

function differs(
  what: string,
  theirs: string,
  ours: string,
  hint = 'Make the world as the one that was saved, with the same options, forces and systems.',
): PhysicsError {
  return new PhysicsError('E_TYPE', `decodeSnapshot: the world differs in ${what}: ${theirs} saved, ${ours} here.`, {
    field: 'world',
    hint,
  });
}

/** The keys of resources, and their states in this world, where those that are absent are created. */
function findResources(world: PhysicsWorld, encoded: EncodedSnapshot['resources']) {
  const { resources } = world.internal;
  const ofName = new Map<string, ResourceKey[]>();
  for (const key of resources.keys()) {
    if (!(key instanceof ResourceKey) || key.name === '') continue;
    ofName.set(key.name, [...(ofName.get(key.name) ?? []), key]);
  }
  const keys: ResourceKey[] = encoded.map(({ name, number }) => {
    const found = ofName.get(name)?.[number] ?? (number === 0 ? onlyKeyNamed(name) : undefined);
    if (found !== undefined) return found;
    throw absent(`the resource "${name}"`);
  });
  return {
    keys,
    existing: keys.map((key) => (key.create === undefined ? undefined : stateAt(world, key, key.create))),
  };
}

/** Adds the memory of forces that is state. Where a force has other options, its memory is free, and it begins anew. */
function takeForces(
  world: PhysicsWorld,
  encoded: EncodedSnapshot['forces'],
  { keys, states, idle }: { keys: object[]; states: unknown[]; idle: Block[] },
): void {
  encoded.forEach((theirs, i) => {
    const { memory } = world.forces[i];
    if (theirs === null) return;
    if (memory?.form !== theirs.form) idle.push(...theirs.state.blocks);
    else {
      keys.push(memory.key);
      states.push(theirs.state);
    }
  });
}

function absent(what: string): PhysicsError {
  return new PhysicsError('E_TYPE', `decodeSnapshot: this world has nothing in the place of ${what}.`, {
    field: 'world',
    hint: 'Make the world as the one that was saved, with the same emitters and calls of keepState; step it once if that is not enough.',
  });
}

/** Turns the objects of another world into those of this one in the same places, or into new ones. */
class ValueDecoder {
  readonly #objects: readonly EncodedObject[];
  readonly #reader: BytesReader;
  readonly #memory: ArrayBuffer;
  readonly #parts: ReadonlyMap<string, unknown>;
  /** The object of this world for each of the other, and what it is called in errors. */
  readonly #targets: (object | undefined)[];
  readonly #places: string[];
  readonly #taken = new Set<object>();

  constructor(world: PhysicsWorld, objects: readonly EncodedObject[], reader: BytesReader) {
    this.#objects = objects;
    this.#reader = reader;
    this.#memory = world.memory.buffer as ArrayBuffer;
    this.#parts = partsOfWorld(world, world);
    this.#targets = objects.map(() => undefined);
    this.#places = objects.map(() => '');
  }

  /** @param existing what this world has in the place of the value */
  value(encoded: EncodedValue, existing: unknown, place: string): unknown {
    if (typeof encoded !== 'object' || encoded === null) return encoded;
    switch (encoded[0]) {
      case 'undefined':
        return undefined;
      case 'hole':
        return HOLE;
      case 'number':
        return Number(encoded[1]);
      case 'bigint':
        return BigInt(encoded[1]);
      case 'object':
        return this.#targetOf(encoded[1], existing, place);
      case 'memory':
        return this.#viewOf(encoded[1], existing);
      case 'world':
        return this.#parts.get(encoded[1]);
      case 'shape':
        return isShape(existing) && isSameShape(existing, encoded[1])
          ? existing
          : adoptShape({ ...encoded[1], neighbours: encoded[1].neighbours });
      case 'immutable':
        return markImmutable(this.#plainData(encoded[1], place));
      default:
        if (existing === undefined || existing === null) throw absent(place);
        return existing;
    }
  }

  /** All objects with their contents, after the values of all roots; those that are frozen are made here. */
  finish(): Copy[] {
    return this.#objects.flatMap((object, i) => {
      const copy = copyWith(this.#targets[i] as object, this.#contentsOf(i, object));
      if (object.isFrozen !== true) return [copy];
      copy.putBack();
      Object.freeze(copy.target);
      return [];
    });
  }

  #targetOf(number: number, existing: unknown, place: string): object {
    const known = this.#targets[number];
    if (known !== undefined) return known;
    const encoded = this.#objects[number];
    const isFree = typeof existing === 'object' && existing !== null && !this.#taken.has(existing);
    const target = isFree && isAlike(existing, encoded) ? existing : emptyLike(encoded, place);
    this.#taken.add(target);
    this.#targets[number] = target;
    this.#places[number] = place;
    return target;
  }

  #contentsOf(i: number, { kind, values, names, numbers }: EncodedObject): Contents {
    const existing = valuesIn(this.#targets[i] as object, names);
    const place = this.#places[i];
    return {
      kind,
      values: values.map((value, v) => this.value(value, existing[v], `${place}.${names?.[v] ?? v}`)),
      ...(names && { names }),
      ...(numbers && { numbers: this.#reader.array(numbers) }),
    };
  }

  #viewOf([type, offset, length]: readonly [string, number, number], existing: unknown): unknown {
    const isSame =
      ArrayBuffer.isView(existing) &&
      existing.buffer === this.#memory &&
      existing.byteOffset === offset &&
      existing.constructor.name === type &&
      (existing as Float64Array).length === length;
    return isSame ? existing : makeArray(type, this.#memory, offset, length);
  }

  #plainData({ kind, values, names = [] }: EncodedObject, place: string): object {
    const items = values.map((value) =>
      Array.isArray(value) && value[0] === 'immutable'
        ? this.#plainData(value[1], place)
        : this.value(value, undefined, place),
    );
    return kind === 'array' ? items : Object.fromEntries(items.map((item, i) => [names[i], item]));
  }
}

function isAlike(existing: object, { kind, prototype, numbers, isFrozen }: EncodedObject): boolean {
  if (isImmutable(existing) || isFrozen) return false;
  if (kind === 'array') return Array.isArray(existing);
  if (kind === 'map') return existing instanceof Map;
  if (kind === 'set') return existing instanceof Set;
  if (kind === 'date') return existing instanceof Date;
  if (kind === 'object') {
    const isPlain = Object.getPrototypeOf(existing) === Object.prototype;
    return prototypeOf(existing) === prototype && (prototype !== undefined || isPlain);
  }
  if (kind === 'buffer') return existing instanceof ArrayBuffer && existing.byteLength === numbers?.[2];
  if (kind === 'view') return existing instanceof DataView && existing.byteLength === numbers?.[2];
  const { [Symbol.toStringTag]: type, length } = existing as Float64Array;
  return type === numbers?.[0] && length === numbers?.[2];
}

function emptyLike({ kind, prototype, numbers }: EncodedObject, place: string): object {
  if (prototype === 'class') throw absent(place);
  if (kind === 'array') return [];
  if (kind === 'map') return new Map();
  if (kind === 'set') return new Set();
  if (kind === 'date') return new Date(0);
  if (kind === 'object') return prototype === 'none' ? Object.create(null) : {};
  const [type, , length] = numbers as ArrayPlace;
  if (kind === 'buffer') return new ArrayBuffer(length);
  if (kind === 'view') return new DataView(new ArrayBuffer(length));
  return makeArray(type, new ArrayBuffer(8 * length), 0, length);
}

/** What an object contains, in the order of `Contents.values`. */
function valuesIn(target: object, names: readonly string[] | undefined): readonly unknown[] {
  if (names !== undefined) return names.map((name) => (target as Record<string, unknown>)[name]);
  if (target instanceof Map) return [...target].flat();
  if (target instanceof Set) return [...target];
  return Array.isArray(target) ? target : [];
}

function isSameShape(a: Shape, b: Shape): boolean {
  return JSON.stringify(a) === JSON.stringify(b);
}
