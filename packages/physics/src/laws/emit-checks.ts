// The checks of a loop on the results for one vector of bodies, and the handling of bodies at a wall.
import type { NodeEmitter } from './emit-nodes.ts';
import type { LoopSource, WallTest } from './loop-source.ts';
import type { Node } from './node.ts';

/** The parameters of a loop, `first`, `last` and `checked`, and its own locals. */
export const LOCALS = { first: 0, last: 1, checked: 2, offset: 3, end: 4, listEnd: 5, total: 6 } as const;

/** Keeps resting bodies in place; otherwise returns if a value is out of range, and lists bodies outside. */
export function emitChecks(emitter: NodeEmitter, source: LoopSource, results: readonly number[]): void {
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
    code.add('local.get', LOCALS.checked).add('i32.and').add('if');
    if (walls !== undefined) storeListEnd(emitter, walls);
    code
      .add('local.get', LOCALS.offset)
      .add('i32.const', types.stored === 'f32' ? 2 : 3)
      .add('i32.shr_u')
      .add('return');
    code.add('end');
  }
  if (walls === undefined) return;
  pushFails(emitter, walls.inside);
  code
    .add('if')
    .add('local.get', LOCALS.listEnd)
    .add('local.get', LOCALS.offset)
    .memory('i32.store', 0, 'list of bodies at walls');
  code.add('local.get', LOCALS.listEnd).add('i32.const', 4).add('i32.add').add('local.set', LOCALS.listEnd);
  for (const { address, node } of walls.stores) emitStore(emitter, address, node, 'velocity at the start');
  code.add('end');
}

function emitStore(emitter: NodeEmitter, address: number, node: Node, note: string | undefined): void {
  const local = emitter.toLocal(node);
  emitter.code.add('local.get', LOCALS.offset).add('local.get', local).memory('v128.store', address, note);
}

/** Pushes 1 if the condition fails for any body, otherwise 0. */
export function pushFails(emitter: NodeEmitter, condition: Node): void {
  const { code, lanes } = emitter;
  emitter.push(condition);
  code
    .add(lanes === 4 ? 'i32x4.bitmask' : 'i64x2.bitmask')
    .add('i32.const', lanes === 4 ? 15 : 3)
    .add('i32.ne');
}

export function storeListEnd({ code }: NodeEmitter, { list }: WallTest): void {
  code.add('i32.const', 0).add('local.get', LOCALS.listEnd).memory('i32.store', list, 'end of the list');
}
