// Emits what is the same for all bodies: computed once before the loop, and broadcast to all lanes of a vector.
import { type NodeUses, sharedOf } from './count-uses.ts';
import { ColumnEmitter } from './emit-columns.ts';
import { FUNCTIONS, SIGNS } from './lane-operations.ts';
import type { Node } from './node.ts';

/** Emits uniform nodes in lanes. */
export class BroadcastEmitter extends ColumnEmitter {
  /** Locals of uniform nodes, broadcast to all lanes. */
  protected readonly broadcasts = new Map<Node, number>();

  /** Local of the mask of the sign bits of all lanes. */
  protected signs = 0;

  /** Computes all uniform values that the loop needs into locals. */
  protected hoistUniforms(roots: readonly Node[], uses: NodeUses): void {
    const { nodes } = uses;
    for (const node of sharedOf(uses)) this.shared.add(node);
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
    if (!nodes.some(({ op, isUniform }) => SIGNS[op] !== undefined && !isUniform)) return;
    this.signs = this.local('v128');
    this.code.add('v128.const', ...this.vectorOf(-0)).add('local.set', this.signs);
  }

  #hoist(node: Node, asDouble: boolean): void {
    const locals = asDouble ? this.doubles : this.broadcasts;
    if (locals.has(node)) return;
    if (asDouble) this.pushDouble(node);
    else this.pushBroadcast(node);
    const local = this.local(!asDouble ? 'v128' : node.isMask ? 'i32' : 'f64');
    locals.set(node, local);
    this.code.add('local.set', local);
  }

  /** Pushes a uniform node, broadcast to all lanes. */
  protected pushBroadcast(node: Node): void {
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
}
