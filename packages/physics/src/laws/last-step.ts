// What a scheme knows of the last step of a body: its length, and the vectors that the body left.
//
// A row keeps its vectors when its body is removed. So that no later body of the row starts with them, the row also keeps the
// number of its body: the generation, plus 1, or 0 if it had no body that forces move. Schemes of the user have this;
// positionVerlet, the only one of the package with a memory, knows new bodies by its vectors, which saves a column.
import type { Graph } from './graph.ts';
import type { Node } from './node.ts';
import { type Axes, eachAxis } from './vector-algebra.ts';

/** A row as it was left, and the body that it has now. */
export interface LeftRow {
  readonly graph: Graph;
  readonly memory: readonly Axes[];
  /** Length of the world's last step with this scheme, or 0. */
  readonly lastDt: Node;
  /** The number of the body that left the row, and the generation of the present one. */
  readonly body: Node;
  readonly generation: Node;
  readonly isMovable: Node;
}

/** The last step of the present body: zeros if it made none. The row then keeps the number of the present body. */
export type LastStep = Pick<LeftRow, 'lastDt' | 'memory' | 'body'>;

export type LastStepOf = (left: LeftRow) => LastStep;

export function lastStepOfBody({ graph, memory, lastDt, body, generation, isMovable }: LeftRow): LastStep {
  const present = graph.make('add', [generation, graph.constant(1)]);
  const ownDt = graph.make('keep', [graph.make('equal', [body, present]), lastDt]);
  const hasLast = graph.make('less', [graph.constant(0), ownDt]);
  return {
    lastDt: ownDt,
    memory: memory.map((vector) => eachAxis((i) => graph.make('keep', [hasLast, vector[i]]))),
    body: graph.make('keep', [isMovable, present]),
  };
}
