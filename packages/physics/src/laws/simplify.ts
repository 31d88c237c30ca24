// Simplifies operations before compilation. Every rule gives the same bits for every number, or drops a product with a
// zero that exists only because of the dimensions. Nothing is reassociated.
import type { Node, NodeMaker, Operation } from './node.ts';

/** Returns a simpler node that is equal to the operation, if there is one. */
export function simplify(graph: NodeMaker, op: Operation, args: readonly Node[]): Node | undefined {
  const [a, b, c] = args;
  if (args.length > 0 && args.every((arg) => arg.op === 'constant')) {
    const value = evaluate(
      op,
      args.map((arg) => arg.value),
    );
    if (value !== undefined) return graph.constant(value);
  }
  switch (op) {
    case 'add':
      if (a.op === 'zero') return b;
      if (b.op === 'zero') return a;
      if (b.op === 'negate') return graph.make('sub', [a, b.args[0]]);
      return a.op === 'negate' ? graph.make('sub', [b, a.args[0]]) : ordered(graph, op, a, b);
    case 'sub':
      if (b.op === 'zero') return a;
      if (a.op === 'zero') return graph.make('negate', [b]);
      return b.op === 'negate' ? graph.make('add', [a, b.args[0]]) : undefined;
    case 'mul':
      return product(graph, a, b);
    case 'div':
      if (a.op === 'zero' || isNumber(b, 1)) return a;
      return isPowerOfTwo(b) ? graph.make('mul', [a, graph.constant(1 / b.value)]) : undefined;
    case 'negate':
      if (a.op === 'zero') return a;
      return a.op === 'negate' ? a.args[0] : undefined;
    case 'abs':
    case 'sqrt':
      return a.op === 'zero' ? a : undefined;
    case 'select':
      if (b === c) return b;
      return c.op === 'zero' || (c.op === 'constant' && Object.is(c.value, 0)) ? graph.make('keep', [a, b]) : undefined;
    case 'keep':
      return b.op === 'zero' ? b : undefined;
    case 'not':
      return a.op === 'not' ? a.args[0] : undefined;
    case 'and':
    case 'or':
      return a === b ? a : undefined;
    default:
      return undefined;
  }
}

function product(graph: NodeMaker, a: Node, b: Node): Node | undefined {
  if (a.op === 'zero' || isNumber(b, 1)) return a;
  if (b.op === 'zero' || isNumber(a, 1)) return b;
  if (b.op === 'negate') return graph.make('negate', [graph.make('mul', [a, b.args[0]])]);
  if (a.op === 'negate') return graph.make('negate', [graph.make('mul', [a.args[0], b])]);
  return ordered(graph, 'mul', a, b);
}

/** Orders the operands of commutative operations: the older operand first. */
function ordered(graph: NodeMaker, op: Operation, a: Node, b: Node): Node | undefined {
  return a.id > b.id ? graph.make(op, [b, a]) : undefined;
}

function isNumber(node: Node, value: number): boolean {
  return node.op === 'constant' && node.value === value;
}

/** Division by a power of two is exactly a multiplication by its inverse. */
function isPowerOfTwo({ op, value }: Node): boolean {
  const size = Math.abs(value);
  if (op !== 'constant' || !(size >= 2 ** -60 && size <= 2 ** 60)) return false;
  let remaining = size;
  while (remaining > 1) remaining /= 2;
  while (remaining < 1) remaining *= 2;
  return remaining === 1;
}

function evaluate(op: Operation, [a, b]: readonly number[]): number | undefined {
  switch (op) {
    case 'add':
      return a + b;
    case 'sub':
      return a - b;
    case 'mul':
      return a * b;
    case 'div':
      return a / b;
    case 'min':
      return b < a ? b : a;
    case 'max':
      return a < b ? b : a;
    case 'negate':
      return -a;
    case 'abs':
      return Math.abs(a);
    case 'sqrt':
      return Math.sqrt(a);
    case 'floor':
      return Math.floor(a);
    default:
      return undefined;
  }
}
