// Powers with a constant exponent that is whole or half: products, and one square root. A power in general is computed
// by logarithm and exponential, which costs fifty times as much.
import type { Node, NodeMaker } from './node.ts';

/** Eight factors are within four units in the last place of the power. */
const MAX_FACTORS = 8;

/** Whether a power is computed by products. */
export function isShortPower(exponent: number): boolean {
  return Number.isInteger(2 * exponent) && Math.abs(exponent) <= MAX_FACTORS;
}

/** Returns a node to the power of an exponent for which `isShortPower` holds. */
export function powerByProducts(graph: NodeMaker, base: Node, exponent: number): Node {
  const size = Math.abs(exponent);
  const factors = size % 1 === 0 ? [] : [graph.make('sqrt', [base])];
  let square = base;
  for (let rest = Math.floor(size); rest > 0; rest >>= 1) {
    if (rest % 2 === 1) factors.push(square);
    if (rest > 1) square = graph.make('mul', [square, square]);
  }
  if (factors.length === 0) return graph.constant(1);
  const power = factors.reduce((a, b) => graph.make('mul', [a, b]));
  return exponent < 0 ? graph.make('div', [graph.constant(1), power]) : power;
}
