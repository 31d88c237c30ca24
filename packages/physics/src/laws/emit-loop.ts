// The function of a loop over bodies, with what comes before and after its iterations.
import { LOCALS, storeListEnd } from './emit-checks.ts';
import { emitIterations } from './emit-iterations.ts';
import { NodeEmitter } from './emit-nodes.ts';
import type { ModuleSource } from './encode.ts';
import type { LoopSource } from './loop-source.ts';
import type { Node, Operation } from './node.ts';

const TWO_ARGUMENTS = new Set<Operation>(['pow', 'atan2']);

/**
 * The function `run(first, last, checked)` over rows [first, last), multiples of 16. If `checked` is not 0 it stops at
 * bodies that are out of range and returns the first row of that iteration; otherwise it returns `last`.
 */
export function emitLoop(source: LoopSource): ModuleSource {
  const { walls, total, types, vectors = 1 } = source;
  const emitter = new NodeEmitter(types, 3, LOCALS.offset, source.noteOf);
  for (const type of ['i32', 'i32', 'i32', 'i32', 'v128', 'i32'] as const) emitter.local(type);
  const { code, realShift } = emitter;
  emitter.begin(rootsOf(source), vectors);
  if (walls !== undefined)
    code.add('i32.const', 0).memory('i32.load', walls.list, 'end of the list').add('local.set', LOCALS.listEnd);
  code.add('local.get', LOCALS.first).add('i32.const', realShift).add('i32.shl').add('local.set', LOCALS.offset);
  code.add('local.get', LOCALS.last).add('i32.const', realShift).add('i32.shl').add('local.set', LOCALS.end);
  code.add('local.get', LOCALS.offset).add('local.get', LOCALS.end).add('i32.lt_u').add('if');
  emitIterations(emitter, source);
  code.add('end');
  if (walls !== undefined) storeListEnd(emitter, walls, LOCALS.listEnd);
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
  const { resting, startVelocity = [], inside } = walls ?? {};
  const stored = [...stores, ...(resting?.stores ?? [])].map(({ node }) => node);
  const tests = [inRange, inside, resting?.atRest, resting?.canRest, fastCheck];
  return [...stored, ...startVelocity, ...tests, total].filter((node) => node !== undefined);
}

function parametersOf(name: Operation): ModuleSource['parameters'] {
  if (name === 'noise') return ['f64', 'f64', 'i32', 'i32'];
  return TWO_ARGUMENTS.has(name) ? ['f64', 'f64'] : ['f64'];
}
