// The arithmetic of a law as a directed acyclic graph of scalar operations in which equal operations are one node:
// common subexpressions of all laws are computed once.
import { PhysicsError } from '../errors/physics-error.ts';
import type { Node, Operation } from './node.ts';
import { simplify } from './simplify.ts';
import type { SumScope } from './table.ts';

const MASKS = new Set<Operation>(['less', 'lessOrEqual', 'equal', 'and', 'or', 'not', 'has']);
const OF_BODIES = new Set<Operation>(['real', 'word', 'entity', 'has', 'noise', 'sum']);

/** Creates nodes. */
export class Graph {
  readonly #cached = new Map<string, Node>();
  readonly #scopes = new Map<SumScope, number>();
  #count = 0;

  /** Returns a node for the operation, or an existing node with the same bits. */
  make(op: Operation, args: readonly Node[] = [], value = 0, scope?: SumScope): Node {
    return simplify(this, op, args) ?? this.#find(op, args, value, scope);
  }

  constant(value: number): Node {
    return this.#find('constant', [], value, undefined);
  }

  /** A zero known at compile time, such as z in 2D: products with it are omitted. */
  get zero(): Node {
    return this.#find('zero', [], 0, undefined);
  }

  /** Returns the sum of a term over the rows of a table, whose address and length are in memory. */
  sum(scope: SumScope, address: Node, count: Node, term: Node): Node {
    return term.op === 'zero' ? term : this.#find('sum', [address, count, term], 0, scope);
  }

  #find(op: Operation, args: readonly Node[], value: number, scope: SumScope | undefined): Node {
    let key = `${op} ${Object.is(value, -0) ? '-0' : value} ${scope === undefined ? '' : this.#scopeId(scope)}`;
    for (const { id } of args) key += ` ${id}`;
    const cached = this.#cached.get(key);
    if (cached !== undefined) return cached;
    const node: Node = {
      id: this.#count++,
      op,
      args,
      value,
      isMask: MASKS.has(op),
      isUniform: !OF_BODIES.has(op) && args.every((arg) => arg.isUniform),
      scope: scopeOf(
        args.filter((arg) => op !== 'sum' || arg.scope !== scope),
        op === 'sum' ? undefined : scope,
      ),
      over: op === 'sum' ? scope : undefined,
    };
    this.#cached.set(key, node);
    return node;
  }

  #scopeId(scope: SumScope): number {
    if (!this.#scopes.has(scope)) this.#scopes.set(scope, this.#scopes.size);
    return this.#scopes.get(scope) as number;
  }
}

/** Returns the only sum whose rows the arguments read. Outside its loop, a sum is an ordinary number. */
function scopeOf(args: readonly Node[], declared: SumScope | undefined): SumScope | undefined {
  let found = declared;
  for (const { scope } of args) {
    if (found !== undefined && scope !== undefined && scope !== found) {
      throw new PhysicsError('E_TYPE', 'a sum inside a sum cannot read the rows of both.', { field: 'sum' });
    }
    found ??= scope;
  }
  return found;
}
