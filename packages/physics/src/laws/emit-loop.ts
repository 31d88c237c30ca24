// The loop over bodies: its stores, the checks before them, and the handling of bodies at a wall.
import { NodeEmitter } from './emit-nodes.ts';
import type { ModuleSource } from './encode.ts';
import type { LaneTypes } from './function-builder.ts';
import type { Node, Operation } from './node.ts';

/** A column and the value to store there for every body. */
export interface Store {
  readonly address: number;
  readonly node: Node;
}

/** Wall test: bodies that are not inside are appended to a list, and additional values are stored for them. */
export interface WallTest {
  readonly inside: Node;
  readonly stores: readonly Store[];
  /**
   * Address of the end of a list, followed by the list: byte offsets of bodies in a column of reals. The loop appends.
   */
  readonly list: number;
  /** If the condition holds for all bodies of a vector, the vector is not listed, and `stores` replaces its results. */
  readonly resting?: { readonly condition: Node; readonly stores: readonly Store[] } | undefined;
}

/** A loop as arithmetic. */
export interface LoopSource {
  readonly name: string;
  readonly types: LaneTypes;
  readonly stores: readonly Store[];
  /** If this is false for a body, the loop stops before it stores anything for the vector. */
  readonly inRange?: Node | undefined;
  readonly walls?: WallTest | undefined;
  /** A cheap sufficient condition for the two above, true for almost all bodies. */
  readonly fastCheck?: Node | undefined;
  /** A value that is summed over all bodies. */
  readonly total?: Node | undefined;
  /** Describes an address in printed code. */
  readonly noteOf: (address: number) => string | undefined;
}

const [FIRST, LAST, CHECKED, OFFSET, END, LIST_END, TOTAL] = [0, 1, 2, 3, 4, 5, 6];

const TWO_ARGUMENTS = new Set<Operation>(['pow', 'atan2']);

/**
 * The function `run(first, last, checked)` over rows [first, last), multiples of 16. If `checked` is not 0 it stops at
 * bodies that are out of range and returns the first row of their vector; otherwise it returns `last`.
 */
export function emitLoop(source: LoopSource): ModuleSource {
  const { walls, total, types } = source;
  const emitter = new NodeEmitter(types, 3, OFFSET, source.noteOf);
  for (const type of ['i32', 'i32', 'i32', 'v128'] as const) emitter.local(type);
  const shift = types.stored === 'f32' ? 2 : 3;
  const { code } = emitter;
  emitter.begin(rootsOf(source));
  if (walls !== undefined)
    code.add('i32.const', 0).memory('i32.load', walls.list, 'end of the list').add('local.set', LIST_END);
  code.add('local.get', FIRST).add('i32.const', shift).add('i32.shl').add('local.set', OFFSET);
  code.add('local.get', LAST).add('i32.const', shift).add('i32.shl').add('local.set', END);
  code.add('local.get', OFFSET).add('local.get', END).add('i32.lt_u').add('if').add('loop');
  emitBodies(emitter, source);
  code
    .add('local.get', OFFSET)
    .add('i32.const', emitter.lanes << shift)
    .add('i32.add')
    .add('local.tee', OFFSET);
  code.add('local.get', END).add('i32.lt_u').add('br_if', 0).add('end').add('end');
  if (walls !== undefined) storeListEnd(emitter, walls);
  if (total === undefined) code.add('local.get', LAST);
  else for (const lane of [0, 1]) code.add('local.get', TOTAL).add('f64x2.extract_lane', lane);
  if (total !== undefined) code.add('f64.add');
  return {
    name: source.name,
    imports: emitter.imports.map((name) => ({ name, parameters: parametersOf(name) })),
    parameters: ['i32', 'i32', 'i32'],
    result: total === undefined ? 'i32' : 'f64',
    locals: emitter.locals,
    code,
  };
}

function rootsOf({ stores, inRange, walls, fastCheck, total }: LoopSource): Node[] {
  const stored = [...stores, ...(walls?.stores ?? []), ...(walls?.resting?.stores ?? [])].map(({ node }) => node);
  return [...stored, inRange, walls?.inside, walls?.resting?.condition, fastCheck, total].filter(
    (node) => node !== undefined,
  );
}

function parametersOf(name: Operation): ModuleSource['parameters'] {
  if (name === 'noise') return ['f64', 'f64', 'i32', 'i32'];
  return TWO_ARGUMENTS.has(name) ? ['f64', 'f64'] : ['f64'];
}

/**
 * Emits the code for one vector of bodies. Everything is computed before anything is stored, because columns are both
 * read and written.
 */
function emitBodies(emitter: NodeEmitter, source: LoopSource): void {
  const { code } = emitter;
  const { stores, fastCheck, total, noteOf } = source;
  const results = stores.map(({ address, node }) => storeResult(emitter, node, mayRest(source, address)));
  if (total !== undefined) {
    code.add('local.get', TOTAL);
    emitter.push(total);
    emitter.lane('add');
    code.add('local.set', TOTAL);
  }
  if (fastCheck !== undefined) {
    pushFails(emitter, fastCheck);
    code.add('if');
  }
  emitter.branch(() => emitChecks(emitter, source, results));
  if (fastCheck !== undefined) code.add('end');
  stores.forEach(({ address }, i) => {
    code.add('local.get', OFFSET).add('local.get', results[i]).memory('v128.store', address, noteOf(address));
  });
}

function mayRest({ walls }: LoopSource, address: number): boolean {
  return walls?.resting?.stores.some((store) => store.address === address) === true;
}

/** Returns the local of a result, a separate one if another value may replace it. */
function storeResult(emitter: NodeEmitter, node: Node, isReplaceable: boolean): number {
  const local = emitter.toLocal(node);
  if (!isReplaceable) return local;
  const copy = emitter.local('v128');
  emitter.code.add('local.get', local).add('local.set', copy);
  return copy;
}

/** Keeps resting bodies in place; otherwise returns if a value is out of range, and lists bodies outside. */
function emitChecks(emitter: NodeEmitter, source: LoopSource, results: readonly number[]): void {
  const { code } = emitter;
  const { walls, stores } = source;
  if (walls?.resting === undefined) {
    emitFailures(emitter, source);
    return;
  }
  const { resting } = walls;
  pushFails(emitter, resting.condition);
  code.add('if');
  emitter.branch(() => emitFailures(emitter, source));
  code.add('else');
  emitter.branch(() => {
    for (const { address, node } of resting.stores) {
      emitter.push(node);
      code.add('local.set', results[stores.findIndex((store) => store.address === address)]);
    }
  });
  code.add('end');
}

function emitFailures(emitter: NodeEmitter, { inRange, walls, types }: LoopSource): void {
  const { code } = emitter;
  if (inRange !== undefined) {
    pushFails(emitter, inRange);
    code.add('local.get', CHECKED).add('i32.and').add('if');
    if (walls !== undefined) storeListEnd(emitter, walls);
    code
      .add('local.get', OFFSET)
      .add('i32.const', types.stored === 'f32' ? 2 : 3)
      .add('i32.shr_u')
      .add('return');
    code.add('end');
  }
  if (walls === undefined) return;
  pushFails(emitter, walls.inside);
  code.add('if').add('local.get', LIST_END).add('local.get', OFFSET).memory('i32.store', 0, 'list of bodies at walls');
  code.add('local.get', LIST_END).add('i32.const', 4).add('i32.add').add('local.set', LIST_END);
  for (const { address, node } of walls.stores) emitStore(emitter, address, node, 'velocity at the start');
  code.add('end');
}

function emitStore(emitter: NodeEmitter, address: number, node: Node, note: string | undefined): void {
  const local = emitter.toLocal(node);
  emitter.code.add('local.get', OFFSET).add('local.get', local).memory('v128.store', address, note);
}

/** Pushes 1 if the condition fails for any body, otherwise 0. */
function pushFails(emitter: NodeEmitter, condition: Node): void {
  const { code, lanes } = emitter;
  emitter.push(condition);
  code
    .add(lanes === 4 ? 'i32x4.bitmask' : 'i64x2.bitmask')
    .add('i32.const', lanes === 4 ? 15 : 3)
    .add('i32.ne');
}

function storeListEnd({ code }: NodeEmitter, { list }: WallTest): void {
  code.add('i32.const', 0).add('local.get', LIST_END).memory('i32.store', list, 'end of the list');
}
