// Translates nodes to instructions. What differs between bodies is computed in 128-bit vectors, and kept in a local if more
// than one node uses it.
import { countUses, type NodeUses } from './count-uses.ts';
import { BroadcastEmitter } from './emit-broadcast.ts';
import { emitCalls } from './emit-calls.ts';
import { emitSum } from './emit-sum.ts';
import { BITS, FUNCTIONS, LANES, SIGNS } from './lane-operations.ts';
import type { Node } from './node.ts';
import type { SumScope } from './table.ts';

/** Emits nodes of all kinds. */
export class NodeEmitter extends BroadcastEmitter {
  #uses: NodeUses = { nodes: [], counts: new Map(), sums: new Map() };
  /** Locals of values for the current bodies, for each vector of an iteration. */
  #locals: Map<Node, number>[] = [];

  /** Computes uniform values. Called once before the loop, with all roots of the loop and the vectors of an iteration. */
  begin(roots: readonly Node[], vectors: number): void {
    this.#uses = countUses(roots);
    this.#locals = Array.from({ length: vectors }, () => new Map<Node, number>());
    this.hoistUniforms(roots, this.#uses);
  }

  /** Values computed by `emit` are valid only inside the branch. */
  branch(emit: () => void): void {
    const [locals, doubles] = [this.#locals, this.rowDoubles];
    this.#locals = locals.map((known) => new Map(known));
    this.rowDoubles = new Map(doubles);
    emit();
    this.#locals = locals;
    this.rowDoubles = doubles;
  }

  /** As `branch`, but values of the current bodies are computed again. */
  recompute(emit: () => void): void {
    this.branch(() => {
      for (const known of this.#locals) known.clear();
      this.rowDoubles.clear();
      emit();
    });
  }

  /** Emits code for every vector of an iteration, one after the other. */
  eachVector(emit: (vector: number) => void): void {
    for (let v = 0; v < this.#locals.length; v++) {
      this.vector = v;
      emit(v);
    }
    this.vector = 0;
  }

  /**
   * Computes values for all vectors of an iteration in turn, operation by operation: while one vector waits for a result,
   * the processor works on another.
   */
  interleave(roots: readonly Node[]): void {
    const seen = new Set<Node>();
    const visit = (node: Node) => {
      if (node.isUniform || node.scope !== undefined || seen.has(node)) return;
      seen.add(node);
      node.args.forEach(visit);
      this.eachVector(() => this.toLocal(node));
    };
    roots.forEach(visit);
  }

  /** Computes a node into a local and returns the local. */
  toLocal(node: Node): number {
    if (node.isUniform && node.scope === undefined) return this.broadcasts.get(node) as number;
    const cached = this.#known.get(node);
    if (cached !== undefined) return cached;
    this.#compute(node);
    return this.#assign(node);
  }

  /** Pushes a node in lanes. */
  push(node: Node): void {
    const { code } = this;
    const broadcast = this.broadcasts.get(node);
    const local = broadcast ?? this.#known.get(node);
    if (local !== undefined) {
      code.add('local.get', local);
      return;
    }
    this.#compute(node);
    if (this.#isReused(node)) code.add('local.tee', this.#assign(node, false));
  }

  get #known(): Map<Node, number> {
    return this.#locals[this.vector];
  }

  #isReused(node: Node): boolean {
    return (this.#uses.counts.get(node) ?? 0) > 1;
  }

  #assign(node: Node, isSet = true): number {
    const local = this.local('v128');
    this.#known.set(node, local);
    if (isSet) this.code.add('local.set', local);
    return local;
  }

  /** Computes a node in lanes, without a cached value. */
  #compute(node: Node): void {
    const { op, args, value } = node;
    const { code } = this;
    if (node.isUniform) this.pushBroadcast(node);
    else if (op === 'real') this.pushReal(value);
    else if (op === 'word') this.pushWord(value);
    else if (op === 'entity') this.pushEntity();
    else if (op === 'has') this.pushHas(args[0].value, value);
    else if (op === 'sum') emitSum(this, node, this.#uses.sums.get(node.over as SumScope) as Node[]);
    else if (FUNCTIONS.has(op)) emitCalls(this, node);
    else if (op === 'select' || op === 'keep') {
      const [mask, whenTrue, whenFalse] = args;
      this.push(whenTrue);
      if (op === 'select') this.push(whenFalse);
      this.push(mask);
      code.add(op === 'select' ? 'v128.bitselect' : 'v128.and');
    } else {
      for (const arg of args) this.push(arg);
      if (SIGNS[op] !== undefined) code.add('local.get', this.signs);
      const name = SIGNS[op] ?? BITS[op];
      if (name === undefined) this.lane(LANES[op] as string);
      else code.add(name);
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
    this.#known.set(node, local);
  }
}
