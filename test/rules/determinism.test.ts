import { expect, test } from 'vitest';
import { expectNone, isTest, lineOf, type Node, parse, typescriptFiles, walk } from './sources.ts';

/** Exact in IEEE 754, so the same bits come out of every engine. Everything else of `Math` may differ by a bit. */
const exactMath = new Set(
  'PI E LN2 SQRT2 SQRT1_2 sqrt abs min max floor ceil round trunc sign imul fround clz32'.split(' '),
);

/** What would make two runs differ, or tie the physics to a page. */
const worldOutside = new Set(
  (
    'Date performance document window navigator location localStorage fetch XMLHttpRequest crypto process ' +
    'setTimeout setInterval setImmediate requestAnimationFrame queueMicrotask Intl'
  ).split(' '),
);

/**
 * In kernels/math `NativeMath` is free: the compiler builds it from arithmetic into our own module, so it is no engine's
 * and the same everywhere.
 */
const mathNames = new Set(['Math', 'Mathf', 'NativeMath', 'NativeMathf', 'JSMath']);

const physicsFiles = typescriptFiles.filter(
  (path) => /^packages\/(physics\/(src|kernels)|scenes\/src)\//.test(path) && !isTest(path),
);

test('there are sources to judge', () => {
  expect(physicsFiles.length).toBeGreaterThan(10);
});

test('physics uses only arithmetic that is the same on every engine', () => {
  const violations = physicsFiles.flatMap((path) =>
    problems(path, (node, parent, field) => {
      if (isPower(node)) return 'a power that is not a constant';
      if (!isReference(node, parent, field) || !mathNames.has(nameOf(node))) return undefined;
      if (/^packages\/physics\/kernels\/math\//.test(path) && nameOf(node) === 'NativeMath') return undefined;
      if (parent?.type !== 'MemberExpression' || parent.computed) return `${nameOf(node)} as a whole`;
      const member = nameOf(parent.property as Node);
      return exactMath.has(member) ? undefined : `${nameOf(node)}.${member}`;
    }),
  );
  expectNone('Use the functions of src/math (or kernels/math) and the seeded generator instead:', violations);
});

test('physics knows no clock, no page and no network', () => {
  const violations = physicsFiles.flatMap((path) =>
    problems(path, (node, parent, field) =>
      isReference(node, parent, field) && worldOutside.has(nameOf(node)) && !isSavedDate(path, node, parent)
        ? nameOf(node)
        : undefined,
    ),
  );
  expectNone('Physics runs the same anywhere: take the value as a parameter, or rename the variable:', violations);
});

/** Snapshots save the dates of the user, as the time that they hold, and read no clock: neither `new Date()` nor `Date.now()`. */
function isSavedDate(path: string, node: Node, parent: Node | undefined): boolean {
  if (nameOf(node) !== 'Date' || !path.startsWith('packages/physics/src/snapshot/')) return false;
  const takesTime = parent?.type !== 'NewExpression' || (parent.arguments as readonly Node[]).length > 0;
  return takesTime && parent?.type !== 'MemberExpression' && parent?.type !== 'CallExpression';
}

/** `2 ** 20` is a number like any other; `x ** y` is `Math.pow`. */
function isPower(node: Node): boolean {
  if (node.operator === '**=') return true;
  return node.operator === '**' && [node.left, node.right].some((side) => !isConstant(side as Node));
}

function isConstant(node: Node): boolean {
  return node.type === 'Literal' || (node.type === 'UnaryExpression' && isConstant(node.argument as Node));
}

type Judge = (node: Node, parent: Node | undefined, field: string) => string | undefined;

function problems(path: string, judge: Judge): string[] {
  const { text, tree } = parse(path);
  const found: string[] = [];
  walk(tree, (node, parent, field) => {
    const problem = judge(node, parent, field);
    if (problem) found.push(`${path}:${lineOf(text, node.start)} uses ${problem}`);
  });
  return found;
}

const nameOf = (node: Node) => String(node.name);

/** An identifier that stands for a variable, not for a member of something or a key. */
function isReference(node: Node, parent: Node | undefined, field: string): boolean {
  if (node.type !== 'Identifier') return false;
  if (parent?.type === 'MemberExpression' && field === 'property') return Boolean(parent.computed);
  return !(field === 'key' && !parent?.computed) && field !== 'label' && parent?.type !== 'TSQualifiedName';
}
