// Lowers expressions to arithmetic: vectors become components, and names become columns.

import { bitInWord, isInFirstWord } from '../components/membership.ts';
import type { Parameter } from '../world/types.ts';
import type { ColumnData } from './body-symbols.ts';
import type { Environment } from './environment.ts';
import type { Expression, Vector } from './expression.ts';
import type { Graph } from './graph.ts';
import { isShortPower, powerByProducts } from './lower-power.ts';
import { lowerVector } from './lower-vector.ts';
import type { Node, Operation } from './node.ts';
import { type RowData, SumScope } from './table.ts';
import { type Axes, dot, lengthOf } from './vector-algebra.ts';

type Lowered = Node | Axes;

/** Converts expressions to nodes, each expression once. */
export class Lowering {
  readonly #done = new Map<Expression, Lowered>();
  readonly #scopes = new Map<SumScope, SumScope>();

  constructor(
    readonly graph: Graph,
    readonly environment: Environment,
  ) {}

  scalar(expression: Expression): Node {
    return this.#lower(expression) as Node;
  }

  vector(expression: Vector): Axes {
    return this.#lower(expression) as Axes;
  }

  #lower(expression: Expression): Lowered {
    const cached = this.#done.get(expression);
    if (cached !== undefined) return cached;
    const made = expression.shape === 'vector' ? lowerVector(this, expression) : this.#makeScalar(expression);
    this.#done.set(expression, made);
    return made;
  }

  #makeScalar(expression: Expression): Node {
    const { op, args, data } = expression;
    const { graph, environment } = this;
    switch (op) {
      case 'constant':
        return graph.constant(data as number);
      case 'time':
        return environment.time;
      case 'dt':
        return environment.dt;
      case 'entity':
        return graph.make('entity');
      case 'parameter':
        return environment.parameter(data as Parameter, 0);
      case 'column': {
        const { component, field, spec } = data as ColumnData;
        if (environment.dimensions === 2 && spec.spatial === true) return graph.zero;
        return environment.column(component, field, spec.kind);
      }
      case 'row':
        return graph.make('row', [], (data as RowData).index, this.#scopeOf((data as RowData).scope));
      case 'sum':
        return this.sum(data as SumScope, this.scalar(args[0]));
      case 'has':
        return this.#has(data as ColumnData['component']);
      case 'noise':
        return environment.noise(this.scalar(args[0]), data as number);
      case 'component':
        return this.vector(args[0] as Vector)[data as number];
      case 'dot':
        return dot(graph, this.vector(args[0] as Vector), this.vector(args[1] as Vector));
      case 'pow':
        return this.#power(args[0], args[1]);
      case 'length':
        return lengthOf(graph, this.vector(args[0] as Vector));
      case 'select':
        if (this.isNever(args[0])) return this.scalar(args[2]);
        return graph.make(
          op,
          args.map((arg) => this.scalar(arg)),
        );
      default:
        return (
          environment.scalars?.[op] ??
          graph.make(
            op as Operation,
            args.map((arg) => this.scalar(arg)),
          )
        );
    }
  }

  /** What is the same for all bodies is computed once, as the function `pow` computes it. */
  #power(base: Expression, exponent: Expression): Node {
    const node = this.scalar(base);
    const { op, data } = exponent;
    const isShort = op === 'constant' && isShortPower(data as number) && !node.isUniform;
    return isShort
      ? powerByProducts(this.graph, node, data as number)
      : this.graph.make('pow', [node, this.scalar(exponent)]);
  }

  #has(component: ColumnData['component']): Node {
    const isOwn = typeof component !== 'string';
    const word = !isOwn && isInFirstWord(component) ? 'members' : 'moreMembers';
    const bit = isOwn ? this.environment.ownBit(component) : bitInWord(component);
    return this.graph.make('has', [this.environment.column('', word, 'u32')], bit);
  }

  /** Whether a condition asks for a component that no entity has. */
  isNever({ op, data }: Expression): boolean {
    return op === 'has' && this.environment.isAbsent?.(data as ColumnData['component']) === true;
  }

  /** Sums a term over the rows of a table. */
  sum(scope: SumScope, term: Node): Node {
    const [address, count] = [0, 1].map((i) => this.environment.parameter(scope.table, i));
    return this.graph.sum(this.#scopeOf(scope), address, count, term);
  }

  /**
   * Each evaluation of a law has a separate loop over the rows, because a later stage depends on the result of an
   * earlier one.
   */
  #scopeOf(scope: SumScope): SumScope {
    const copy = this.#scopes.get(scope) ?? new SumScope(scope.table);
    this.#scopes.set(scope, copy);
    return copy;
  }
}
