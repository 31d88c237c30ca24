// Counts how often each node of a loop is used: a value with several uses is computed once and kept in a local.
import type { Node } from './node.ts';
import type { SumScope } from './table.ts';

export interface NodeUses {
  /** The nodes, arguments first. */
  readonly nodes: readonly Node[];
  readonly counts: ReadonlyMap<Node, number>;
  /** The sums over each table. */
  readonly sums: ReadonlyMap<SumScope, Node[]>;
}

/** Visits everything that the roots depend on. */
export function countUses(roots: readonly Node[]): NodeUses {
  const counts = new Map<Node, number>();
  const sums = new Map<SumScope, Node[]>();
  const visit = (node: Node) => {
    const uses = counts.get(node) ?? 0;
    counts.set(node, uses + 1);
    if (uses > 0) return;
    node.args.forEach(visit);
    if (node.over !== undefined) sums.set(node.over, [...(sums.get(node.over) ?? []), node]);
  };
  roots.forEach(visit);
  return { nodes: [...counts.keys()].sort((a, b) => a.id - b.id), counts, sums };
}

/** Returns the uniform nodes with several uses; the minimum of two values uses each of them twice. */
export function sharedOf({ nodes, counts }: NodeUses): ReadonlySet<Node> {
  const shared = new Set<Node>();
  const isOperation = ({ isUniform, args }: Node) => isUniform && args.length > 0;
  for (const node of nodes) {
    if (isOperation(node) && (counts.get(node) ?? 0) > 1) shared.add(node);
    if (!node.isUniform || (node.op !== 'min' && node.op !== 'max')) continue;
    for (const arg of node.args) if (isOperation(arg)) shared.add(arg);
  }
  return shared;
}
