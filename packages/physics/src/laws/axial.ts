import { type Expression, Vector } from './expression.ts';

/**
 * The same for what has a z in two dimensions, and nothing else, as a torque or a magnetic field: in what it is made of, other than
 * products of vectors, `vec3` keeps it.
 */
export function axial<V extends Expression | undefined>(vector: V): V {
  if (vector?.shape !== 'vector' || vector.op === 'cross') return vector;
  const { op, args, data } = vector;
  return new Vector(op === 'vec3' ? 'axial3' : op, args.map(axial), data) as Expression as V;
}
