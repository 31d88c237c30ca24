// One operation of a graph.
import type { SumScope } from './table.ts';

/** Operations on reals with a real result. */
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

/** One operation. Its arguments are created before it, so ids ascend along every path. */
export interface Node {
  readonly id: number;
  readonly op: Operation;
  readonly args: readonly Node[];
  /** The value of a constant, the address of a load or column, or the field of a row. */
  readonly value: number;
  /** True for a condition, false for a real. */
  readonly isMask: boolean;
  /** Equal for all bodies: computed once, as f64. */
  readonly isUniform: boolean;
  /** The sum on whose rows it depends. */
  readonly scope: SumScope | undefined;
  /** For a sum: the rows it runs over. */
  readonly over: SumScope | undefined;
}

/** Creates nodes: the graph that they belong to. */
export interface NodeMaker {
  make(op: Operation, args?: readonly Node[]): Node;
  constant(value: number): Node;
}
