// A text key of the structure of a law: laws with equal keys compile to the same code.
import type { ComponentName } from '../components/all.ts';
import type { ComponentSpec } from '../components/define.ts';
import type { Law, Parameter } from '../world/types.ts';
import type { ColumnData } from './body-symbols.ts';
import type { Expression } from './expression.ts';
import { type RowData, SumScope } from './table.ts';

type Formulas = Readonly<Record<string, Expression | undefined>>;

/** Numbers of custom components, so that equal structures read the same columns. */
const ownNumbers = new WeakMap<ComponentSpec, number>();
let ownCount = 0;

/** Returns the number of a custom component. */
export function componentNumber(component: ComponentSpec): number {
  const number = ownNumbers.get(component) ?? ownCount++;
  ownNumbers.set(component, number);
  return number;
}

function nameOf(component: ComponentName | ComponentSpec): string {
  return typeof component === 'string' ? component : `own${componentNumber(component)}`;
}

/** Returns the expressions of a law as text, each shared expression once. */
export function structureOf(parameters: readonly Parameter[], formulas: Formulas): string {
  const lines: string[] = parameters.map(
    (parameter) => `${parameter.kind}${'fields' in parameter ? parameter.fields : ''}`,
  );
  const seen = new Map<Expression, number>();
  const scopes = new Map<object, number>();
  const numberOf = <T>(map: Map<T, number>, key: T): number => {
    if (!map.has(key)) map.set(key, map.size);
    return map.get(key) as number;
  };
  const dataOf = ({ op, data }: Expression): string => {
    if (data === undefined) return '';
    if (op === 'parameter') return String(parameters.indexOf(data as Parameter));
    if (op === 'has') return nameOf(data as ColumnData['component']);
    if (op === 'column') return `${nameOf((data as ColumnData).component)}.${(data as ColumnData).field}`;
    if (op === 'row') return `${numberOf(scopes, (data as RowData).scope)}.${(data as RowData).index}`;
    if (op === 'kick') return JSON.stringify(data);
    if (data instanceof SumScope) return `${numberOf(scopes, data)} of ${parameters.indexOf(data.table)}`;
    return Object.is(data, -0) ? '-0' : String(data);
  };
  const visit = (expression: Expression): number => {
    const cached = seen.get(expression);
    if (cached !== undefined) return cached;
    const args = expression.args.map(visit);
    lines.push(`${expression.op}:${expression.shape[0]} ${args} ${dataOf(expression)}`);
    seen.set(expression, seen.size);
    return seen.size - 1;
  };
  for (const [name, expression] of Object.entries(formulas)) {
    if (expression !== undefined) lines.push(`${name}=${visit(expression)}`);
  }
  return lines.join(';');
}

const STATE: Readonly<Record<string, readonly ComponentName[]>> = {
  position: ['Position'],
  velocity: ['Velocity'],
  startVelocity: ['Velocity'],
  angularVelocity: ['AngularVelocity'],
  rotate: ['Rotation', 'Orientation'],
};

type Motion = Pick<Law, 'force' | 'acceleration' | 'torque'>;

/** Returns the components whose columns the expressions of a law read, and those of which they ask whether a body has them. */
export function columnsRead(law: Motion): ComponentName[] {
  const names = new Set<ComponentName>();
  for (const { op, data } of expressionsOf(law)) {
    for (const name of STATE[op] ?? []) names.add(name);
    if (op !== 'column' && op !== 'has') continue;
    const component = op === 'has' ? (data as ColumnData['component']) : (data as ColumnData).component;
    if (typeof component === 'string') names.add(component);
  }
  if (law.acceleration !== undefined) names.add('Mass');
  return [...names];
}

/** Returns whether the force of a law depends on where its body is or how it moves. */
export function readsMotion(law: Motion): boolean {
  for (const { op } of expressionsOf(law)) if (STATE[op] !== undefined) return true;
  return false;
}

/** Returns whether the force of a law depends on the velocity of its body. */
export function readsVelocity(law: Motion): boolean {
  for (const { op } of expressionsOf(law)) if (op === 'velocity' || op === 'startVelocity') return true;
  return false;
}

/** Returns whether the expressions of a law read the time. */
export function readsTime(law: Motion): boolean {
  for (const { op } of expressionsOf(law)) if (op === 'time') return true;
  return false;
}

/** The expressions of a law and all that they are made of, without that of its potential. */
function expressionsOf({ force, acceleration, torque }: Motion): Set<Expression> {
  const found = new Set<Expression>();
  const visit = (expression: Expression) => {
    if (found.has(expression)) return;
    found.add(expression);
    expression.args.forEach(visit);
  };
  for (const each of [force, acceleration, torque]) if (each !== undefined) visit(each);
  return found;
}
