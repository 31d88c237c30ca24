// The checks of a loop on its results, and the handling of bodies at a wall.
import { LISTED_VECTOR_BYTES, LISTED_VECTOR_SIZE } from '../memory/layouts.gen.ts';
import type { NodeEmitter } from './emit-nodes.ts';
import type { LoopSource, WallTest } from './loop-source.ts';
import type { Node } from './node.ts';

/** The parameters of a loop, `first`, `last` and `checked`, and its own locals. */
export const LOCALS = {
  first: 0,
  last: 1,
  checked: 2,
  offset: 3,
  end: 4,
  listEnd: 5,
  listStart: 6,
  total: 7,
  /** Whether the last vector that failed the cheap check was at rest or nothing that walls hold: then the next often is. */
  stays: 8,
} as const;

/** Checks the vectors of an iteration, with the locals of their results. */
export function emitChecks(emitter: NodeEmitter, source: LoopSource, results: readonly (readonly number[])[]): void {
  const { code } = emitter;
  const { fastCheck, walls } = source;
  // What an iteration appended to the list is dropped if one of its vectors is out of range.
  if (walls !== undefined) code.add('local.get', LOCALS.listEnd).add('local.set', LOCALS.listStart);
  emitter.eachVector((v) => {
    const isOneOfSeveral = fastCheck !== undefined && results.length > 1;
    if (isOneOfSeveral) {
      pushFails(emitter, fastCheck);
      code.add('if');
    }
    emitter.branch(() => checkVector(emitter, source, results[v]));
    if (isOneOfSeveral) code.add('end');
  });
}

/** Keeps resting bodies in place; otherwise returns if a value is out of range, and lists bodies outside. */
function checkVector(emitter: NodeEmitter, source: LoopSource, results: readonly number[]): void {
  const { code } = emitter;
  const { walls, stores } = source;
  if (walls?.resting === undefined) {
    emitFailures(emitter, source);
    return;
  }
  const { resting } = walls;
  // The labels: all of it, and what is not at rest.
  code.add('i32.const', 0).add('local.set', LOCALS.stays);
  code.add('block').add('block');
  pushFails(emitter, resting.atRest);
  code.add('br_if', 0);
  emitter.branch(() => {
    pushFails(emitter, resting.canRest);
    code.add('br_if', 0);
    for (const { address, node } of resting.stores) {
      emitter.push(node);
      code.add('local.set', results[stores.findIndex((store) => store.address === address)]);
    }
  });
  code.add('i32.const', 1).add('local.set', LOCALS.stays).add('br', 1).add('end');
  emitter.branch(() => emitFailures(emitter, source));
  code.add('end');
}

function emitFailures(emitter: NodeEmitter, { inRange, walls }: LoopSource): void {
  const { code } = emitter;
  if (inRange !== undefined) {
    pushFails(emitter, inRange);
    code.add('local.get', LOCALS.checked).add('i32.and').add('if');
    if (walls !== undefined) storeListEnd(emitter, walls, LOCALS.listStart);
    code.add('local.get', LOCALS.offset).add('i32.const', emitter.realShift).add('i32.shr_u').add('return');
    code.add('end');
  }
  if (walls === undefined) return;
  pushFails(emitter, walls.inside);
  code.add('if');
  listVector(emitter, walls);
  code.add('else').add('i32.const', 1).add('local.set', LOCALS.stays).add('end');
}

/** Appends the vector to the list. */
function listVector(emitter: NodeEmitter, { startVelocity }: WallTest): void {
  const { code } = emitter;
  code.add('local.get', LOCALS.listEnd);
  emitter.pushOffset();
  code.memory('i32.store', 0, 'list of bodies at walls');
  startVelocity.forEach((node, axis) => {
    const velocity = emitter.toLocal(node);
    code.add('local.get', LOCALS.listEnd).add('local.get', velocity);
    code.memory('v128.store', LISTED_VECTOR_BYTES + 16 * axis, 'velocity at the start');
  });
  code.add('local.get', LOCALS.listEnd).add('i32.const', LISTED_VECTOR_SIZE).add('i32.add');
  code.add('local.set', LOCALS.listEnd);
}

/** Pushes 1 if the condition fails for any body of the vector, otherwise 0. */
function pushFails(emitter: NodeEmitter, condition: Node): void {
  emitter.push(condition);
  pushIsFalse(emitter);
}

/** Replaces a condition on the stack by 1 if it is false in any lane, otherwise 0. */
export function pushIsFalse({ code, lanes }: NodeEmitter): void {
  code
    .add(lanes === 4 ? 'i32x4.bitmask' : 'i64x2.bitmask')
    .add('i32.const', lanes === 4 ? 15 : 3)
    .add('i32.ne');
}

export function storeListEnd({ code }: NodeEmitter, { list }: WallTest, end: number): void {
  code.add('i32.const', 0).add('local.get', end).memory('i32.store', list, 'end of the list');
}
