// Sums over the same rows are one loop. A sum whose term needs the result of such a sum must come after it, as a loop of its
// own: with rows of another name.
import { Condition, type Expression, Scalar, Vector } from './expression.ts';
import { type RowData, SumScope } from './table.ts';

const KINDS = { scalar: Scalar, vector: Vector, condition: Condition };

/** Whether an expression contains a sum. */
export function containsSum(expression: Expression): boolean {
  const seen = new Set<Expression>();
  const visit = (each: Expression): boolean => {
    if (seen.has(each)) return false;
    seen.add(each);
    return each.op === 'sum' || each.args.some(visit);
  };
  return visit(expression);
}

/** Returns the sum of a term over the rows of a scope, as a loop of its own. */
export function sumApart(term: Vector, scope: SumScope): Vector {
  const own = new SumScope(scope.table);
  const done = new Map<Expression, Expression>();
  const rename = (expression: Expression): Expression => {
    let renamed = done.get(expression);
    if (renamed === undefined) {
      renamed = withOwnRows(expression);
      done.set(expression, renamed);
    }
    return renamed;
  };
  const withOwnRows = (expression: Expression): Expression => {
    const { op, args, data, shape } = expression;
    if (op === 'row' && (data as RowData).scope === scope)
      return new Scalar(op, [], { ...(data as RowData), scope: own });
    // The rows within a sum over the same scope are those of that sum.
    if (op === 'sum' && data === scope) return expression;
    const renamed = args.map(rename);
    return renamed.every((arg, i) => arg === args[i]) ? expression : new KINDS[shape](op, renamed, data);
  };
  return new Vector('sum', [rename(term)], own);
}
