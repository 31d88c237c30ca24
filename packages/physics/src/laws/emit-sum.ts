// Emits sums over the rows of a table: a loop inside the loop over bodies.
import type { ColumnEmitter } from './emit-columns.ts';
import type { Node } from './node.ts';
import type { SumScope } from './table.ts';

/** The emitter of the terms of a sum. */
interface TermEmitter extends ColumnEmitter {
  push(node: Node): void;
  /** Computes a node and keeps it in a local. */
  toLocal(node: Node): number;
  /** Records that the value of a node is in a local. */
  know(node: Node, local: number): void;
  withRow(row: number, emit: () => void): void;
}

/** Emits all sums over the same rows as one loop, and pushes one of them. */
export function emitSum(emitter: TermEmitter, node: Node, sums: readonly Node[]): void {
  const { code } = emitter;
  const scope = node.over as SumScope;
  const rowBytes = 8 * scope.table.fields.length;
  const terms = sums.map(({ args }) => args[2]);
  storeBeforeLoop(emitter, terms, scope);
  const totals = sums.map(() => emitter.local('v128'));
  for (const total of totals) code.add('v128.const', ...emitter.vectorOf(0)).add('local.set', total);
  const [row, end] = [emitter.local('i32'), emitter.local('i32')];
  const [address, count] = node.args;
  emitter.pushDouble(address);
  code.add('i32.trunc_f64_u').add('local.tee', row);
  emitter.pushDouble(count);
  code.add('i32.trunc_f64_u').add('i32.const', rowBytes).add('i32.mul').add('i32.add').add('local.set', end);
  code.add('local.get', row).add('local.get', end).add('i32.lt_u').add('if').add('loop');
  emitter.withRow(row, () => {
    terms.forEach((term, i) => {
      code.add('local.get', totals[i]);
      emitter.push(term);
      emitter.lane('add');
      code.add('local.set', totals[i]);
    });
  });
  code.add('local.get', row).add('i32.const', rowBytes).add('i32.add').add('local.tee', row);
  code.add('local.get', end).add('i32.lt_u').add('br_if', 0).add('end').add('end');
  sums.forEach((sum, i) => {
    emitter.know(sum, totals[i]);
  });
  emitter.push(node);
}

/** Computes the parts of the terms that do not depend on the row before the loop over rows. */
function storeBeforeLoop(emitter: TermEmitter, terms: readonly Node[], scope: SumScope): void {
  const seen = new Set<Node>();
  const visit = (node: Node) => {
    if (seen.has(node)) return;
    seen.add(node);
    if (node.scope === scope) node.args.forEach(visit);
    else if (!node.isUniform) emitter.toLocal(node);
  };
  terms.forEach(visit);
}
