// Tests the description of a step. It is read by people, so it must be complete and use public names.
import { describe, expect, test } from 'vitest';
import { lawOf } from '../../../../test/support/law-lab.ts';
import {
  boxWalls,
  COMPONENTS,
  createPhysicsWorld,
  defineForce,
  defineLaw,
  destroyWorld,
  explain,
  type Force,
  linearDrag,
  type PhysicsWorldOptions,
  quadraticDrag,
  scalar,
  select,
  spawn,
  step,
  type TableLocation,
  table,
  uniformGravity,
  vec3,
  vector,
} from '../index.ts';
import { formulasOf } from '../laws/formula.ts';

function textOf(forces: readonly Force[], options: PhysicsWorldOptions = {}): string {
  const world = createPhysicsWorld({ capacity: 10, forces, ...options });
  spawn(world, { position: {}, velocity: {}, mass: 1 });
  return explain(world);
}

/** Counts the nesting depth of brackets line by line. */
function depthsOf(text: string): { readonly deepest: number; readonly end: number } {
  let [depth, deepest] = [0, 0];
  for (const line of text.split('\n')) {
    const word = line.trim().split(' ')[0].replace(/\)+$/, '');
    if (/^(block|loop|if)$/.test(word)) depth++;
    if (word === 'end') depth--;
    expect(depth).toBeGreaterThanOrEqual(0);
    deepest = Math.max(deepest, depth);
  }
  return { deepest, end: depth };
}

function brackets(text: string): number {
  return [...text].reduce((depth, letter) => depth + (letter === '(' ? 1 : letter === ')' ? -1 : 0), 0);
}

const formulaOf = (force: Force, kind?: 'latex') => formulasOf(force.law as NonNullable<Force['law']>, kind);

describe('formulas', () => {
  test('of gravity: acceleration and potential', () => {
    expect(formulaOf(uniformGravity())).toEqual(['a = scale acceleration', 'U = scale (−acceleration·r m)']);
  });

  test('of drag, linear and quadratic, with the names of the law', () => {
    expect(formulaOf(linearDrag())).toEqual(['F = −c (v − wind)']);
    expect(formulaOf(quadraticDrag())).toEqual(['F = −|v − wind| k (v − wind)']);
  });

  test('as LaTeX: vectors in bold, fractions and roots drawn', () => {
    const drift = defineLaw({
      name: 'drift',
      reads: { c: COMPONENTS.LinearDrag },
      parameters: { w: vector('m/s') },
      force: ({ velocity, c }, { w }) => velocity.sub(w).mul(c),
    });
    expect(formulaOf(drift({ w: {} }), 'latex')).toEqual(['\\mathbf{F} = c\\,(\\mathbf{v} − \\mathbf{w})']);
    const fall = defineLaw({
      name: 'fall',
      parameters: { k: scalar('') },
      force: ({ position, mass }, { k }) => position.mul(k).div(mass.sqrt()),
    });
    expect(formulaOf(fall({ k: 1 }), 'latex')).toEqual(['\\mathbf{F} = \\frac{k\\,\\mathbf{r}}{\\sqrt{m}}']);
    expect(formulaOf(fall({ k: 1 }))).toEqual(['F = k r/√(m)']);
  });

  test('brackets appear only where operator precedence requires them', () => {
    const law = defineLaw({
      name: 'order',
      reads: { a: COMPONENTS.Charge, b: COMPONENTS.LinearDrag },
      force: ({ velocity, a, b }) => velocity.mul(a.sub(b.sub(a)).div(b.mul(a))).add(velocity.negate()),
    });
    expect(formulaOf(law())).toEqual(['F = (a − (b − a))/(a b) v + −v']);
  });

  test('of conditions and sums', () => {
    const law = defineLaw({
      name: 'cases',
      parameters: { t: table(['q'], (): TableLocation => ({ at: 0, count: 0 })) },
      force: ({ velocity, position, mass }, { t }) =>
        select(mass.less(1), velocity, position).add(t.sum(({ q }) => velocity.mul(q))),
    }) as () => Force;
    expect(formulaOf(law())).toEqual(['F = (v if m < 1, else r) + Σ qᵢ v']);
  });

  test('of exponential size name their subexpressions', () => {
    const growing = lawOf({
      force: ({ velocity, mass }: never) => {
        let k = (mass as { mul(b: unknown): never }).mul(2);
        for (let i = 0; i < 60; i++) k = (k as { mul(b: unknown): never }).mul(k);
        return (velocity as { mul(b: unknown): never }).mul(k);
      },
    });
    const [formula] = formulaOf(growing);
    expect(formula.length).toBeLessThan(2000);
    expect(formula).toMatch(/^F = q_61 v|^F = q_60 q_60 v/);
    expect(formula).toMatch(/q_2 = q_1 q_1, q_1 = 2 m$/);
    expect(textOf([growing]).length).toBeLessThan(50_000);
  });
});

const everything = () => [uniformGravity(), linearDrag(), quadraticDrag({ x: 1 })];

describe('explain', () => {
  test.each([
    ['in the plane', {}],
    ['in space, f32', { dimensions: 3, precision: 'f32' }],
    ['with walls', { walls: [boxWalls({ min: { x: 0, y: 0 }, max: { x: 1, y: 1 } })] }],
  ] as const)('shows one loop with balanced brackets: %s', (_, options) => {
    const text = textOf(everything(), options as PhysicsWorldOptions);
    expect(text).toContain('The whole step is one loop:');
    expect(text.match(/\(module/g)).toHaveLength(1);
    const code = text.slice(text.indexOf('(module')).replace(/;;.*/g, '');
    expect(brackets(code)).toBe(0);
    const { deepest, end } = depthsOf(code);
    expect(end).toBe(0);
    expect(deepest).toBeGreaterThanOrEqual(2);
  });

  test('describes every force in list order, and the integrator', () => {
    const text = textOf([...everything(), defineForce({ name: 'wand', accumulate() {} })]);
    expect(text).toMatch(/^A step in 2D, f64, by velocity Verlet\./);
    const lines = [
      'uniform gravity: a = scale acceleration',
      'linear drag: F = −c (v − wind)',
      'wand: a function, called',
    ];
    const at = lines.map((line) => text.indexOf(line));
    expect(at.every((place) => place > 0)).toBe(true);
    expect(at).toEqual([...at].sort((a, b) => a - b));
    expect(text).toContain('Forces and integrator are separate loops:');
    // One module for the laws, and three segments: before, between and after the two evaluations.
    expect(text.match(/\(module/g)).toHaveLength(4);
    expect(depthsOf(text.replace(/;;.*/g, '')).end).toBe(0);
  });

  test('names the columns and parameters that are read or written', () => {
    const text = textOf(everything());
    for (const name of ['Position.x', 'Velocity.y', 'Mass.value', 'LinearDrag.coefficient', 'wind of quadratic drag']) {
      expect(text).toMatch(new RegExp(`load.* ;; .*${name.replace('.', '\\.')}`));
    }
    expect(text).toMatch(/v128\.store.* ;; .*Position\.x/);
  });

  test('shows only instructions of the compiled code: a law without a sine calls no sine', () => {
    expect(textOf(everything())).not.toContain('call $');
    const wave = lawOf({ force: ({ time }: never) => vec3((time as { sin(): never }).sin(), 0) });
    expect(textOf([wave])).toContain('(import "math" "sin" (func $sin (param f64) (result f64)))');
  });

  test('changes nothing', () => {
    const [asked, other] = [0, 1].map(() => {
      const world = createPhysicsWorld({ capacity: 10, forces: everything() });
      spawn(world, { position: {}, velocity: { x: 1 }, mass: 1, linearDrag: 1 });
      return world;
    });
    explain(asked);
    for (const world of [asked, other]) step(world, 0.1);
    expect(asked.components.Velocity.x[1]).toBe(other.components.Velocity.x[1]);
    expect(asked.tick).toBe(1);
  });

  test('is rejected during a step and for a destroyed world', () => {
    const world = createPhysicsWorld({ capacity: 10 });
    world.phases.input.push((each) => void explain(each));
    expect(() => step(world, 0.1)).toThrow(/E_REENTRANT/);
    destroyWorld(world);
    expect(() => explain(world)).toThrow(/E_DESTROYED/);
  });
});
