// Emits uniform values: computed once in f64 before the loop or, in a sum, once per row.
import { FunctionBuilder } from './function-builder.ts';
import type { Node, Operation } from './node.ts';

const DOUBLE: Readonly<Partial<Record<Operation, string>>> = {
  add: 'f64.add',
  sub: 'f64.sub',
  mul: 'f64.mul',
  div: 'f64.div',
  negate: 'f64.neg',
  abs: 'f64.abs',
  sqrt: 'f64.sqrt',
  floor: 'f64.floor',
  round: 'f64.nearest',
  less: 'f64.lt',
  lessOrEqual: 'f64.le',
  equal: 'f64.eq',
  and: 'i32.and',
  or: 'i32.or',
  not: 'i32.eqz',
};

/** Emits uniform nodes. */
export class UniformEmitter extends FunctionBuilder {
  /** Locals of values computed before the loop. */
  protected readonly doubles = new Map<Node, number>();
  /** Local with the address of the row of a sum, and locals of values that depend on it. */
  protected row = 0;
  protected rowDoubles = new Map<Node, number>();
  /** Uniform nodes with more than one use. */
  protected readonly shared = new Set<Node>();

  /** Pushes a uniform node as f64, or a condition as 0 or 1. */
  pushDouble(node: Node): void {
    const { code } = this;
    const { op, args, value } = node;
    const local = this.doubles.get(node) ?? this.rowDoubles.get(node);
    if (local !== undefined) code.add('local.get', local);
    else if (op === 'constant' || op === 'zero') code.add('f64.const', value);
    else if (op === 'load') code.add('i32.const', 0).memory('f64.load', value, this.noteOf(value));
    else if (op === 'row') code.add('local.get', this.row).memory('f64.load', 8 * value);
    else this.#pushOperation(op, args);
    if (local !== undefined || node.scope === undefined || !this.shared.has(node)) return;
    const double = this.local(node.isMask ? 'i32' : 'f64');
    this.rowDoubles.set(node, double);
    code.add('local.tee', double);
  }

  #pushOperation(op: Operation, args: readonly Node[]): void {
    const { code } = this;
    const [a, b, c] = args;
    const doubles = (...nodes: readonly Node[]) => {
      for (const node of nodes) this.pushDouble(node);
    };
    if (op === 'min') {
      doubles(b, a, b, a);
      code.add('f64.lt').add('select');
    } else if (op === 'max') {
      doubles(b, a, a, b);
      code.add('f64.lt').add('select');
    } else if (op === 'select' || op === 'keep') {
      doubles(b);
      if (op === 'keep') code.add('f64.const', 0);
      else doubles(c);
      doubles(a);
      code.add('select');
    } else {
      doubles(...args);
      const name = DOUBLE[op];
      if (name !== undefined) code.add(name);
      else code.add('call', this.importOf(op));
    }
  }
}
