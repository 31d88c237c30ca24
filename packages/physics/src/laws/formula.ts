// Prints expressions as formulas: as plain text for terminals, or as LaTeX for pages.

import { checkObject } from '../errors/validate.ts';
import type { Law, Parameter } from '../world/types.ts';
import type { ColumnData } from './body-symbols.ts';
import type { Expression } from './expression.ts';
import type { RowData } from './table.ts';

/** Notation of the parts of a formula. */
interface Style {
  readonly names: Readonly<Record<string, string>>;
  vector(name: string): string;
  divide(a: string, b: string): string;
  root(a: string): string;
  times: string;
  call(name: string, args: readonly string[]): string;
}

const text: Style = {
  names: {
    position: 'r',
    velocity: 'v',
    startVelocity: 'v₀',
    angularVelocity: 'ω',
    force: 'F',
    acceleration: 'a',
    dt: 'Δt',
    time: 't',
    entity: 'id',
  },
  vector: (name) => name,
  divide: (a, b) => `${a}/${b}`,
  root: (a) => `√(${a})`,
  times: ' ',
  call: (name, args) => `${name}(${args.join(', ')})`,
};

const latex: Style = {
  names: { ...text.names, startVelocity: 'v_0', angularVelocity: '\\omega', dt: '\\Delta t', entity: '\\mathrm{id}' },
  vector: (name) => `\\mathbf{${name}}`,
  divide: (a, b) => `\\frac{${a}}{${b}}`,
  root: (a) => `\\sqrt{${a}}`,
  times: '\\,',
  call: (name, args) => `\\operatorname{${name}}\\left(${args.join(', ')}\\right)`,
};

/** Operator precedence: sums, products, and expressions that need no brackets. */
const [SUM, PRODUCT, ATOM] = [1, 2, 3];

interface Printed {
  readonly text: string;
  readonly binding: number;
}

/** Returns the formulas of a law: its force, acceleration, torque and potential. */
export function formulasOf(law: Law, kind: 'text' | 'latex' = 'text'): string[] {
  checkObject(law, 'formulasOf: law');
  const style = kind === 'text' ? text : latex;
  const formulas: [string, Expression | undefined][] = [
    [style.vector('F'), law.force],
    [style.vector('a'), law.acceleration],
    [kind === 'text' ? 'τ' : style.vector('\\tau'), law.torque],
    ['U', law.potential],
  ];
  return formulas.flatMap(([name, expression]) =>
    expression === undefined ? [] : [`${name} = ${new Printer(law, style).printWithDefinitions(expression)}`],
  );
}

/** In a formula with more operations, repeated expressions get a name: written out, it could grow exponentially. */
const LONG = 200;

class Printer {
  readonly #names = new Map<Expression, string>();

  constructor(
    readonly law: Law,
    readonly style: Style,
  ) {}

  /** Returns the formula, followed by the definitions of its names. */
  printWithDefinitions(expression: Expression): string {
    const { sizes, shared } = measure(expression);
    if ((sizes.get(expression) as number) <= LONG) return this.print(expression).text;
    const definitions = shared.map((subexpression, i) => {
      const { text: printed } = this.print(subexpression);
      const name = `q_${i + 1}`;
      this.#names.set(subexpression, name);
      return `${name} = ${printed}`;
    });
    return [this.print(expression).text, ...definitions.reverse()].join(', ');
  }

  print(expression: Expression): Printed {
    const name = this.#names.get(expression);
    return name === undefined ? this.#write(expression) : atom(name);
  }

  #write(expression: Expression): Printed {
    const { op, args, data } = expression;
    const { style } = this;
    switch (op) {
      case 'constant':
        return atom(String(data));
      case 'parameter':
        return this.#parameter(expression);
      case 'column':
        return atom(this.#column(data as ColumnData));
      case 'row':
        return atom(this.#rowField(data as RowData));
      case 'add':
        return { text: `${this.#in(args[0], SUM)} + ${this.#in(args[1], SUM)}`, binding: SUM };
      case 'sub':
        return { text: `${this.#in(args[0], SUM)} − ${this.#in(args[1], PRODUCT)}`, binding: SUM };
      case 'mul':
        return { text: `${this.#in(args[1], PRODUCT)}${style.times}${this.#in(args[0], PRODUCT)}`, binding: PRODUCT };
      case 'div':
        return this.#fraction(args[0], args[1]);
      case 'negate':
        return { text: `−${this.#in(args[0], PRODUCT)}`, binding: SUM };
      case 'dot':
        return { text: `${this.#in(args[0], ATOM)}·${this.#in(args[1], ATOM)}`, binding: PRODUCT };
      case 'cross':
        return { text: `${this.#in(args[0], ATOM)} × ${this.#in(args[1], ATOM)}`, binding: PRODUCT };
      case 'length':
      case 'abs':
        return atom(`|${this.print(args[0]).text}|`);
      case 'sqrt':
        return atom(style.root(this.print(args[0]).text));
      case 'component':
        return atom(`${this.#in(args[0], ATOM)}.${'xyz'[data as number]}`);
      case 'select':
        // A coefficient that is 1 without its component reads as that coefficient.
        if (args[0].op === 'has' && args[1].op === 'column' && args[2].data === 1) return this.print(args[1]);
        return {
          text: `${this.#in(args[1], SUM)} if ${this.print(args[0]).text}, else ${this.#in(args[2], SUM)}`,
          binding: 0,
        };
      case 'less':
        return { text: `${this.#in(args[0], SUM)} < ${this.#in(args[1], SUM)}`, binding: 0 };
      case 'lessOrEqual':
        return { text: `${this.#in(args[0], SUM)} ≤ ${this.#in(args[1], SUM)}`, binding: 0 };
      case 'equal':
        return { text: `${this.#in(args[0], SUM)} = ${this.#in(args[1], SUM)}`, binding: 0 };
      case 'sum':
        return { text: `${this.style === text ? 'Σ' : '\\sum_i'} ${this.#in(args[0], PRODUCT)}`, binding: PRODUCT };
      case 'vec3':
      case 'axial3':
        return atom(this.#vector(args));
      default:
        if (args.length === 0) return this.#named(expression, style.names[op] ?? op);
        return atom(
          style.call(
            op,
            args.map((arg) => this.print(arg).text),
          ),
        );
    }
  }

  /** A name of more than one letter is upright in typeset formulas. */
  #word(name: string): string {
    return this.style === text || name.length === 1 ? name : `\\mathrm{${name}}`;
  }

  #in(expression: Expression, binding: number): string {
    const printed = this.print(expression);
    return printed.binding < binding ? `(${printed.text})` : printed.text;
  }

  #fraction(a: Expression, b: Expression): Printed {
    const isText = this.style === text;
    const [above, below] = isText
      ? [this.#in(a, PRODUCT), this.#in(b, ATOM)]
      : [this.print(a).text, this.print(b).text];
    return { text: this.style.divide(above, below), binding: isText ? PRODUCT : ATOM };
  }

  #parameter(expression: Expression): Printed {
    const { law } = this;
    const name = law.names[law.parameters.indexOf(expression.data as Parameter)] ?? 'p';
    return this.#named(expression, expression.shape === 'vector' ? name : this.#word(name));
  }

  #named({ shape }: Expression, name: string): Printed {
    return atom(shape === 'vector' ? this.style.vector(name) : name);
  }

  #rowField({ scope, index }: RowData): string {
    const name = scope.table.fields[index];
    return this.style === text ? `${name}ᵢ` : `${this.#word(name)}_i`;
  }

  #column({ component, field }: ColumnData): string {
    if (component === 'Mass') return 'm';
    if (typeof component !== 'string') return this.#word(field);
    return this.#word(this.law.columns[`${component}.${field}`] ?? `${component}.${field}`);
  }

  /** Three columns of one component form a vector of that name. */
  #vector(args: readonly Expression[]): string {
    const [x] = args;
    const { component, field } = (x.data ?? {}) as Partial<ColumnData>;
    const isWhole = x.op === 'column' && field === 'x' && this.law.columns[`${component}.x`] !== undefined;
    if (isWhole) return this.style.vector(this.law.columns[`${component}.x`].replace(/\.x$/, ''));
    return `(${args.map((arg) => this.print(arg).text).join(', ')})`;
  }
}

/** Counts the operations below each expression when it is written out, and finds the repeated expressions. */
function measure(root: Expression) {
  const sizes = new Map<Expression, number>();
  const shared = new Set<Expression>();
  const visit = (expression: Expression): number => {
    const cached = sizes.get(expression);
    if (cached !== undefined) {
      if (expression.args.length > 0) shared.add(expression);
      return cached;
    }
    const size = expression.args.reduce((sum, arg) => sum + visit(arg), 1);
    sizes.set(expression, size);
    return size;
  };
  visit(root);
  // The order is that of the traversal: operands come before the expressions that use them.
  return { sizes, shared: [...sizes.keys()].filter((expression) => shared.has(expression)) };
}

function atom(printed: string): Printed {
  return { text: printed, binding: ATOM };
}
