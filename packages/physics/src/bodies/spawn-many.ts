// Bodies by the million. bitECS spends 0.8 µs and 200 bytes on an entity alone and calls three observers for three
// components, which doubles that; here a body costs one `addEntity` and, for all its components together, one write of
// its membership mask. That reaches into bitECS's own tables (public by its `$internal` symbol, and its version is
// pinned); a test holds the result against the component-by-component path.
import { $internal, addEntity, type ComponentData, type WorldContext } from 'bitecs';
import { bitOf, COMPONENTS, type ComponentName } from '../components/all';
import type { FieldSpec } from '../components/define';
import { describe, PhysicsError } from '../faults/physics-error';
import { checkKeys, checkNumber } from '../faults/validate';
import { initialValues } from '../store/attach';
import { assertUsable } from '../store/guards';
import type { PhysicsWorld } from '../world';
import { type BodyInput, capacityError, componentOfKey } from './spawn';

/** A value for each body: one number for all, or as many as there are bodies. */
export type Many = number | ArrayLike<number>;

/** Like `BodyInput`, with an array wherever bodies differ. */
export type ManyInput = {
  readonly [Key in keyof BodyInput]?:
    | { readonly [F in keyof Exclude<NonNullable<BodyInput[Key]>, number>]?: Many }
    | (Extract<NonNullable<BodyInput[Key]>, number> extends never ? never : Many);
};

/** Called as bodies are made, with how many are. */
export type Progress = (made: number, count: number) => void;

const CHUNK = 65536;

interface Filling {
  readonly name: ComponentName;
  readonly fields: readonly (readonly [string, Many])[];
}

/**
 * Makes `count` entities with the same components.
 * @returns their ids, ascending when the world never lost a body
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN (all values are checked first), E_CAPACITY,
 *   E_REENTRANT (during a step), E_DESTROYED
 */
export function spawnMany(world: PhysicsWorld, count: number, values: ManyInput, progress?: Progress): Uint32Array {
  assertUsable(world);
  checkNumber(count, 'count', { min: 0, max: 0xffffffff, integer: true });
  if (world.state === 'stepping') {
    throw new PhysicsError('E_REENTRANT', 'spawnMany cannot run inside a step.', { hint: 'Use spawn, or wait.' });
  }
  const fillings = checkMany(values, count);
  const context = (world as unknown as { [$internal]: WorldContext })[$internal];
  if (context.entityIndex.aliveCount + count > world.capacity) throw capacityError(world, count);
  const ids = makeEntities(world, context, fillings, count, progress);
  for (const filling of fillings) fill(world, filling, ids);
  finish(world, fillings, ids);
  return ids;
}

function checkMany(values: ManyInput, count: number): Filling[] {
  if (typeof values !== 'object' || values === null) checkKeys(values, 'spawnMany', []);
  const fillings: Filling[] = [];
  for (const [key, data] of Object.entries(values)) {
    if (data === undefined) continue;
    const name = componentOfKey(key);
    const spec = COMPONENTS[name];
    const isScalar = typeof data === 'number' || isList(data);
    const scalar = 'scalar' in spec ? spec.scalar : undefined;
    if (isScalar && scalar === undefined) {
      throw new PhysicsError('E_TYPE', `${key} must be { ${Object.keys(spec.fields).join(', ')} }.`, { field: key });
    }
    const given = (isScalar ? { [scalar as string]: data } : data) as Record<string, Many>;
    checkKeys(given, key, Object.keys(spec.fields));
    const fields = Object.entries(given).filter(([, many]) => many !== undefined);
    for (const [field, many] of fields) checkColumn(`${key}.${field}`, spec.fields[field as never], many, count);
    fillings.push({ name, fields });
  }
  return fillings;
}

function isList(value: unknown): value is ArrayLike<number> {
  return Array.isArray(value) || (ArrayBuffer.isView(value) && !(value instanceof DataView));
}

function checkColumn(field: string, spec: FieldSpec, many: unknown, count: number): void {
  if (typeof many === 'number') {
    checkNumber(many, field, spec.bounds, undefined, spec.hint);
    return;
  }
  if (!isList(many)) {
    throw new PhysicsError('E_TYPE', `${field} must be a number or an array, got ${describe(many)}.`, { field });
  }
  if (many.length !== count) {
    throw new PhysicsError('E_RANGE', `${field} has ${many.length} values for ${count} bodies.`, { field });
  }
  for (let i = 0; i < count; i++) {
    const value = many[i];
    if (typeof value !== 'number' || !(value - value === 0)) checkNumber(value, `${field}[${i}]`, spec.bounds);
  }
  checkRange(field, spec, many, count);
}

function checkRange(field: string, spec: FieldSpec, many: ArrayLike<number>, count: number): void {
  const { min = -Infinity, max = Infinity, above = -Infinity, integer = false } = spec.bounds;
  for (let i = 0; i < count; i++) {
    const value = many[i] as number;
    if (value < min || value > max || value <= above || (integer && !Number.isInteger(value))) {
      checkNumber(value, `${field}[${i}]`, spec.bounds, undefined, spec.hint);
    }
  }
}

function makeEntities(
  world: PhysicsWorld,
  context: WorldContext,
  fillings: readonly Filling[],
  count: number,
  progress: Progress | undefined,
): Uint32Array {
  const components = fillings.map(({ name }) => world.components[name]);
  const data = components.map((component) => context.componentMap.get(component) as ComponentData);
  const flags = data.reduce((all, { bitflag }) => all | bitflag, 0);
  const masks = context.entityMasks[(data[0] as ComponentData | undefined)?.generationId ?? 0] as number[];
  const ids = new Uint32Array(count);
  for (let i = 0; i < count; i++) {
    const eid = addEntity(world);
    ids[i] = eid;
    masks[eid] = ((masks[eid] as number | undefined) ?? 0) | flags;
    const owned = context.entityComponents.get(eid) as Set<unknown>;
    for (let c = 0; c < components.length; c++) owned.add(components[c]);
    if (progress !== undefined && (i + 1) % CHUNK === 0) progress(i + 1, count);
  }
  joinQueries(context, data, ids);
  progress?.(count, count);
  return ids;
}

/** Adds the entities to every query they match: ours by component, and the user's. */
function joinQueries(context: WorldContext, data: readonly ComponentData[], ids: Uint32Array): void {
  const queries = new Set(data.flatMap(({ queries }) => [...queries]));
  for (const query of queries) {
    const required = Object.entries(query.masks);
    const refused = Object.entries(query.notMasks);
    const anyOf = Object.entries(query.orMasks);
    const sample = ids[0];
    if (sample === undefined) return;
    const has = (generation: string) => context.entityMasks[Number(generation)]?.[sample] ?? 0;
    const matches =
      required.every(([g, mask]) => (has(g) & mask) === mask) &&
      refused.every(([g, mask]) => (has(g) & mask) === 0) &&
      (anyOf.length === 0 || anyOf.some(([g, mask]) => (has(g) & mask) !== 0));
    if (matches) for (let i = 0; i < ids.length; i++) query.add(ids[i] as number);
    else for (let i = 0; i < ids.length; i++) if (query.has(ids[i] as number)) query.remove(ids[i] as number);
  }
}

function fill(world: PhysicsWorld, { name, fields }: Filling, ids: Uint32Array): void {
  const columns = world.components[name] as unknown as Record<string, Float64Array>;
  const values: Record<string, Many> = { ...initialValues(name), ...Object.fromEntries(fields) };
  for (const field of Object.keys(values)) writeColumn(columns[field] as Float64Array, values[field] as Many, ids);
  if (name in world.previous) {
    const previous = (world.previous as unknown as Record<string, Record<string, Float64Array>>)[name];
    for (const field of Object.keys(values)) {
      writeColumn(previous?.[field] as Float64Array, values[field] as Many, ids);
    }
  }
}

function writeColumn(column: Float64Array, many: Many, ids: Uint32Array): void {
  const count = ids.length;
  const first = ids[0] as number;
  const dense = count > 0 && (ids[count - 1] as number) - first === count - 1;
  if (dense && typeof many === 'number') column.fill(many, first, first + count);
  else if (dense && isAscending(ids)) column.set(many as ArrayLike<number>, first);
  else if (typeof many === 'number') for (let i = 0; i < count; i++) column[ids[i] as number] = many;
  else for (let i = 0; i < count; i++) column[ids[i] as number] = many[i] as number;
}

function isAscending(ids: Uint32Array): boolean {
  for (let i = 1; i < ids.length; i++) if ((ids[i] as number) <= (ids[i - 1] as number)) return false;
  return true;
}

function finish(world: PhysicsWorld, fillings: readonly Filling[], ids: Uint32Array): void {
  const { internal, versions } = world;
  let bits = 0;
  for (const { name } of fillings) {
    bits |= bitOf(name);
    internal.counts[name] += ids.length;
  }
  for (let i = 0; i < ids.length; i++) {
    const eid = ids[i] as number;
    internal.members[eid] = (internal.members[eid] as number) | bits;
    if (eid > world.lastId) world.lastId = eid;
  }
  versions.membership++;
  versions.style++;
  versions.pose++;
}
