// Translates nodes to instructions. A uniform node is computed once before the loop. Other nodes are computed in
// 128-bit vectors, and kept in a local if more than one node uses them.
import { ColumnEmitter } from './emit-columns.ts';
import { emitSum } from './emit-sum.ts';
import type { Node, Operation } from './node.ts';
import type { SumScope } from './table.ts';

const LANES: Readonly<Partial<Record<Operation, string>>> = {
  add: 'add',
  sub: 'sub',
  mul: 'mul',
  div: 'div',
  negate: 'neg',
  abs: 'abs',
  sqrt: 'sqrt',
  floor: 'floor',
  round: 'nearest',
  min: 'pmin',
  max: 'pmax',
  less: 'lt',
  lessOrEqual: 'le',
  equal: 'eq',
};

const BITS: Readonly<Partial<Record<Operation, string>>> = { and: 'v128.and', or: 'v128.or', not: 'v128.not' };

/** Functions of kernels/math, called per lane, so that the results are bitwise equal to scalar calls. */
const FUNCTIONS = new Set<Operation>(['sin', 'cos', 'exp', 'log', 'pow', 'atan2', 'noise']);

/** Emits nodes of all kinds. */
export class NodeEmitter extends ColumnEmitter {
  readonly #uses = new Map<Node, number>();
  readonly #sums = new Map<SumScope, Node[]>();
  /** Locals of uniform nodes, broadcast to all lanes. */
  readonly #spreads = new Map<Node, number>();
  /** Locals of values for the current bodies. */
  #vectors = new Map<Node, number>();

  /** Computes uniform values. Called once before the loop, with all roots of the loop. */
  begin(roots: readonly Node[]): void {
    const nodes = this.#count(roots);
    this.#findShared(nodes);
    for (const node of nodes) if (this.shared.has(node) && node.scope === undefined) this.#hoist(node, true);
    for (const node of nodes) {
      if (node.isUniform) continue;
      const asDoubles = FUNCTIONS.has(node.op);
      for (const arg of node.args) if (arg.isUniform && arg.scope === undefined) this.#hoist(arg, asDoubles);
    }
    for (const node of nodes) {
      const inRows = node.isUniform && node.scope !== undefined;
      if (inRows || node.op === 'sum')
        for (const arg of node.args) if (arg.isUniform && !arg.scope) this.#hoist(arg, true);
    }
    for (const root of roots) if (root.isUniform) this.#hoist(root, false);
  }

  /** Values computed by `emit` are valid only inside the branch. */
  branch(emit: () => void): void {
    const [vectors, doubles] = [this.#vectors, this.rowDoubles];
    this.#vectors = new Map(vectors);
    this.rowDoubles = new Map(doubles);
    emit();
    this.#vectors = vectors;
    this.rowDoubles = doubles;
  }

  /** Computes a node into a local and returns the local. */
  toLocal(node: Node): number {
    if (node.isUniform && node.scope === undefined) return this.#spreads.get(node) as number;
    const cached = this.#vectors.get(node);
    if (cached !== undefined) return cached;
    this.#compute(node);
    return this.#assign(node);
  }

  /** Pushes a node in lanes. */
  push(node: Node): void {
    const { code } = this;
    const spread = this.#spreads.get(node);
    const local = spread ?? this.#vectors.get(node);
    if (local !== undefined) {
      code.add('local.get', local);
      return;
    }
    this.#compute(node);
    if ((this.#uses.get(node) ?? 0) > 1) code.add('local.tee', this.#assign(node, false));
  }

  /** Returns the reachable nodes, arguments first, and counts their uses. */
  #count(roots: readonly Node[]): Node[] {
    const visit = (node: Node) => {
      const uses = this.#uses.get(node) ?? 0;
      this.#uses.set(node, uses + 1);
      if (uses > 0) return;
      node.args.forEach(visit);
      if (node.over === undefined) return;
      const sums = this.#sums.get(node.over) ?? [];
      this.#sums.set(node.over, [...sums, node]);
    };
    roots.forEach(visit);
    return [...this.#uses.keys()].sort((a, b) => a.id - b.id);
  }

  /** The minimum of two values uses each operand twice. */
  #findShared(nodes: readonly Node[]): void {
    const isOperation = ({ isUniform, args }: Node) => isUniform && args.length > 0;
    for (const node of nodes) {
      if (isOperation(node) && (this.#uses.get(node) ?? 0) > 1) this.shared.add(node);
      if (!node.isUniform || (node.op !== 'min' && node.op !== 'max')) continue;
      for (const arg of node.args) if (isOperation(arg)) this.shared.add(arg);
    }
  }

  #assign(node: Node, isSet = true): number {
    const local = this.local('v128');
    this.#vectors.set(node, local);
    if (isSet) this.code.add('local.set', local);
    return local;
  }

  #hoist(node: Node, asDouble: boolean): void {
    const locals = asDouble ? this.doubles : this.#spreads;
    if (locals.has(node)) return;
    if (asDouble) this.pushDouble(node);
    else this.#spread(node);
    const local = this.local(!asDouble ? 'v128' : node.isMask ? 'i32' : 'f64');
    locals.set(node, local);
    this.code.add('local.set', local);
  }

  /** Pushes a uniform node, broadcast to all lanes. */
  #spread(node: Node): void {
    const { code } = this;
    if (node.op === 'constant' || node.op === 'zero') {
      code.add('v128.const', ...this.vectorOf(node.value));
    } else if (node.isMask) {
      code.add('i32.const', 0);
      this.pushDouble(node);
      code.add('i32.sub').add('i32x4.splat');
    } else {
      this.pushDouble(node);
      if (this.types.computed === 'f32') code.add('f32.demote_f64');
      this.lane('splat');
    }
  }

  /** Computes a node in lanes, without a cached value. */
  #compute(node: Node): void {
    const { op, args, value } = node;
    const { code } = this;
    if (node.isUniform) this.#spread(node);
    else if (op === 'real') this.pushReal(value);
    else if (op === 'word') this.pushWord(value);
    else if (op === 'entity') this.pushEntity();
    else if (op === 'has') this.pushHas(args[0].value, value);
    else if (op === 'sum') emitSum(this, node, this.#sums.get(node.over as SumScope) as Node[]);
    else if (FUNCTIONS.has(op)) this.#pushCalls(node);
    else if (op === 'select' || op === 'keep') {
      const [mask, whenTrue, whenFalse] = args;
      this.push(whenTrue);
      if (op === 'select') this.push(whenFalse);
      this.push(mask);
      code.add(op === 'select' ? 'v128.bitselect' : 'v128.and');
    } else {
      for (const arg of args) this.push(arg);
      const name = BITS[op];
      if (name === undefined) this.lane(LANES[op] as string);
      else code.add(name);
    }
  }

  #pushCalls({ op, args, value }: Node): void {
    const { code } = this;
    const isWide = this.types.computed === 'f64';
    const locals = args.map((arg) => (arg.isUniform ? undefined : this.toLocal(arg)));
    for (let lane = 0; lane < this.lanes; lane++) {
      args.forEach((arg, i) => {
        if (locals[i] === undefined) {
          this.pushDouble(arg);
          return;
        }
        code.add('local.get', locals[i]);
        this.lane('extract_lane', lane);
        if (!isWide) code.add('f64.promote_f32');
      });
      if (op === 'noise') {
        this.pushRow(lane);
        code.add('i32.const', value);
      }
      code.add('call', this.importOf(op));
      if (!isWide) code.add('f32.demote_f64');
      if (lane === 0) this.lane('splat');
      else this.lane('replace_lane', lane);
    }
  }

  /** Emits code that depends on the row of a sum; a local holds the row's address. */
  withRow(row: number, emit: () => void): void {
    const outer = this.row;
    this.row = row;
    this.branch(emit);
    this.row = outer;
  }

  /** Records that a node is in a local. */
  know(node: Node, local: number): void {
    this.#vectors.set(node, local);
  }
}
