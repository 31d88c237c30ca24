// One operation of a graph.
import type { SumScope } from './table.ts';

/** Operations on reals that give a real. */
export type Operation =
  | 'add'
  | 'sub'
  | 'mul'
  | 'div'
  | 'min'
  | 'max'
  | 'negate'
  | 'abs'
  | 'sqrt'
  | 'floor'
  | 'round'
  | 'sin'
  | 'cos'
  | 'exp'
  | 'log'
  | 'pow'
  | 'atan2'
  | 'noise'
  | 'select'
  | 'keep'
  | 'less'
  | 'lessOrEqual'
  | 'equal'
  | 'and'
  | 'or'
  | 'not'
  | 'has'
  | 'constant'
  | 'zero'
  | 'load'
  | 'real'
  | 'word'
  | 'entity'
  | 'row'
  | 'sum';

/** One operation. Its arguments were made before it, so that ids ascend along every path. */
export interface Node {
  readonly id: number;
  readonly op: Operation;
  readonly args: readonly Node[];
  /** The number of a constant, the address of a load or column, the field of a row. */
  readonly value: number;
  /** A condition, and not a real. */
  readonly isMask: boolean;
  /** The same for all bodies: computed once, as a double. */
  readonly isUniform: boolean;
  /** The sum on whose rows it depends. */
  readonly scope: SumScope | undefined;
  /** Of a sum: what it runs over. */
  readonly over: SumScope | undefined;
}

/** What makes nodes: the graph that they belong to. */
export interface NodeMaker {
  make(op: Operation, args?: readonly Node[]): Node;
  constant(value: number): Node;
}
