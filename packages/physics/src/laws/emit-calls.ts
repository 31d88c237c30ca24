// Emits calls of scalar functions, one for each lane, so that the results are bitwise equal to scalar calls.
import type { ColumnEmitter } from './emit-columns.ts';
import type { Node } from './node.ts';

/** The emitter of the arguments. */
interface ArgumentEmitter extends ColumnEmitter {
  /** Computes a node and keeps it in a local. */
  toLocal(node: Node): number;
}

/** Pushes the results of a function for all lanes. */
export function emitCalls(emitter: ArgumentEmitter, { op, args, value }: Node): void {
  const { code, lanes } = emitter;
  const isWide = emitter.types.computed === 'f64';
  const locals = args.map((arg) => (arg.isUniform ? undefined : emitter.toLocal(arg)));
  for (let lane = 0; lane < lanes; lane++) {
    args.forEach((arg, i) => {
      if (locals[i] === undefined) {
        emitter.pushDouble(arg);
        return;
      }
      code.add('local.get', locals[i]);
      emitter.lane('extract_lane', lane);
      if (!isWide) code.add('f64.promote_f32');
    });
    if (op === 'noise') {
      emitter.pushRow(lane);
      code.add('i32.const', value);
    }
    code.add('call', emitter.importOf(op));
    if (!isWide) code.add('f32.demote_f64');
    if (lane === 0) emitter.lane('splat');
    else emitter.lane('replace_lane', lane);
  }
}
