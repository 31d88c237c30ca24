// The loop over bodies: computes the results for one vector of bodies, checks them, and stores them.
import { emitChecks, LOCALS, pushFails, storeListEnd } from './emit-checks.ts';
import { NodeEmitter } from './emit-nodes.ts';
import type { ModuleSource } from './encode.ts';
import type { LoopSource } from './loop-source.ts';
import type { Node, Operation } from './node.ts';

const TWO_ARGUMENTS = new Set<Operation>(['pow', 'atan2']);

/**
 * The function `run(first, last, checked)` over rows [first, last), multiples of 16. If `checked` is not 0 it stops at
 * bodies that are out of range and returns the first row of their vector; otherwise it returns `last`.
 */
export function emitLoop(source: LoopSource): ModuleSource {
  const { walls, total, types } = source;
  const emitter = new NodeEmitter(types, 3, LOCALS.offset, source.noteOf);
  for (const type of ['i32', 'i32', 'i32', 'v128'] as const) emitter.local(type);
  const shift = types.stored === 'f32' ? 2 : 3;
  const { code } = emitter;
  emitter.begin(rootsOf(source));
  if (walls !== undefined)
    code.add('i32.const', 0).memory('i32.load', walls.list, 'end of the list').add('local.set', LOCALS.listEnd);
  code.add('local.get', LOCALS.first).add('i32.const', shift).add('i32.shl').add('local.set', LOCALS.offset);
  code.add('local.get', LOCALS.last).add('i32.const', shift).add('i32.shl').add('local.set', LOCALS.end);
  code.add('local.get', LOCALS.offset).add('local.get', LOCALS.end).add('i32.lt_u').add('if').add('loop');
  emitBodies(emitter, source);
  code
    .add('local.get', LOCALS.offset)
    .add('i32.const', emitter.lanes << shift)
    .add('i32.add')
    .add('local.tee', LOCALS.offset);
  code.add('local.get', LOCALS.end).add('i32.lt_u').add('br_if', 0).add('end').add('end');
  if (walls !== undefined) storeListEnd(emitter, walls);
  if (total === undefined) code.add('local.get', LOCALS.last);
  else for (const lane of [0, 1]) code.add('local.get', LOCALS.total).add('f64x2.extract_lane', lane);
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
    code.add('local.get', LOCALS.total);
    emitter.push(total);
    emitter.lane('add');
    code.add('local.set', LOCALS.total);
  }
  if (fastCheck !== undefined) {
    pushFails(emitter, fastCheck);
    code.add('if');
  }
  emitter.branch(() => emitChecks(emitter, source, results));
  if (fastCheck !== undefined) code.add('end');
  stores.forEach(({ address }, i) => {
    code.add('local.get', LOCALS.offset).add('local.get', results[i]).memory('v128.store', address, noteOf(address));
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
