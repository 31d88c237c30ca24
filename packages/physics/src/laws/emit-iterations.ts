// The iterations of a loop over bodies: each computes the results for one or two vectors of bodies, checks them, and stores
// them.
import { emitChecks, LOCALS, pushIsFalse } from './emit-checks.ts';
import type { NodeEmitter } from './emit-nodes.ts';
import type { LoopSource, WallTest } from './loop-source.ts';
import type { Node } from './node.ts';

/**
 * The inner loop is tried again at offsets that are multiples of this, 64 vectors. Bodies at rest take 5 % longer by it; 7 % if it
 * is a quarter.
 */
const RETRY_BYTES = 1024;

/**
 * Emits the iterations. Everything is computed before anything is stored, because columns are both read and written. An
 * iteration that fails the cheap check leaves the inner loop, so that the inner loop keeps the processor's registers to
 * itself.
 */
export function emitIterations(emitter: NodeEmitter, source: LoopSource): void {
  const { code } = emitter;
  const { fastCheck } = source;
  if (fastCheck === undefined) {
    code.add('loop');
    const results = emitResults(emitter, source);
    emitter.branch(() => emitChecks(emitter, source, results));
    emitStores(emitter, source, results);
    code.add('br_if', 0).add('end');
    return;
  }
  // The labels: everything, all iterations, an iteration that fails, and the others.
  code.add('block').add('loop').add('block').add('loop');
  const results = emitResults(emitter, source);
  emitter.eachVector((v) => {
    emitter.push(fastCheck);
    if (v > 0) code.add('v128.and');
  });
  pushIsFalse(emitter);
  code.add('br_if', 1);
  emitStores(emitter, source, results);
  code.add('br_if', 0).add('end').add('br', 2).add('end');
  const handle = (computed: readonly (readonly number[])[]) => {
    emitChecks(emitter, source, computed);
    emitStores(emitter, source, computed);
  };
  // One vector is computed again, so that the inner loop need not keep its values for the checks; two are not, which would
  // take longer.
  if (results.length === 1)
    emitter.recompute(() => repeatAtRest(emitter, source, () => handle(emitResults(emitter, source))));
  else emitter.branch(() => handle(results));
  code.add('br_if', 0).add('end').add('end');
}

/**
 * Repeats what `handle` emits while bodies are at rest, because where one lies on the floor the next do, too, or are nothing that
 * walls hold, such as unused rows. Bodies inside the box stay here as well, where they take longer, so the inner loop is tried
 * again now and then.
 */
function repeatAtRest({ code }: NodeEmitter, { walls }: LoopSource, handle: () => void): void {
  if (walls?.resting === undefined) {
    handle();
    return;
  }
  code.add('loop');
  handle();
  code.add('local.get', LOCALS.stays).add('i32.and');
  code
    .add('local.get', LOCALS.offset)
    .add('i32.const', RETRY_BYTES - 1)
    .add('i32.and')
    .add('i32.const', 0);
  code.add('i32.ne').add('i32.and').add('br_if', 0).add('end');
  code.add('local.get', LOCALS.offset).add('local.get', LOCALS.end).add('i32.lt_u');
}

/** Computes the results of the vectors of an iteration, and returns their locals. */
function emitResults(emitter: NodeEmitter, { stores, fastCheck, total, walls, vectors = 1 }: LoopSource): number[][] {
  const { code } = emitter;
  const checked = fastCheck === undefined ? [] : [fastCheck];
  if (vectors > 1) emitter.interleave([...stores.map(({ node }) => node), ...checked]);
  const results: number[][] = [];
  emitter.eachVector((v) => {
    results[v] = stores.map(({ address, node }) => storeResult(emitter, node, mayRest(walls, address)));
  });
  if (total !== undefined) {
    code.add('local.get', LOCALS.total);
    emitter.push(total);
    emitter.lane('add');
    code.add('local.set', LOCALS.total);
  }
  return results;
}

/** Stores the results, and pushes whether an iteration follows. */
function emitStores(
  emitter: NodeEmitter,
  { stores, noteOf, vectors = 1 }: LoopSource,
  results: readonly (readonly number[])[],
): void {
  const { code, lanes, realShift } = emitter;
  emitter.eachVector((v) => {
    stores.forEach(({ address }, i) => {
      emitter.storeReal(address, results[v][i], noteOf(address));
    });
  });
  const bytes = (vectors * lanes) << realShift;
  code.add('local.get', LOCALS.offset).add('i32.const', bytes).add('i32.add').add('local.tee', LOCALS.offset);
  code.add('local.get', LOCALS.end).add('i32.lt_u');
}

function mayRest(walls: WallTest | undefined, address: number): boolean {
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
