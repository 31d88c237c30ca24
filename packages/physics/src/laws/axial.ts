import { type Expression, Vector } from './expression.ts';

/**
 * The same for what has a z in two dimensions, and nothing else, as a torque or a magnetic field: in what it is made of, other than
 * products of vectors, `vec3` keeps it. What is shared stays shared.
 */
export function axial<V extends Expression | undefined>(vector: V): V {
  const known = new Map<Expression, Expression>();
  const visit = (expression: Expression): Expression => {
    if (expression.shape !== 'vector' || expression.op === 'cross') return expression;
    const { op, args, data } = expression;
    let result = known.get(expression);
    if (result === undefined) {
      result = new Vector(op === 'vec3' ? 'axial3' : op, args.map(visit), data);
      known.set(expression, result);
    }
    return result;
  };
  return (vector && visit(vector)) as V;
}
