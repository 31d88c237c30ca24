import { test } from 'vitest';
import { expectNone, isTest, lineOf, type Node, parse, projectFiles, read, typescriptFiles, walk } from './sources.ts';

const longestFile = 400;
const longestFunction = 70;

const codeFiles = projectFiles.filter((path) => /^(packages|games|bench|scripts)\/.*\.(ts|mjs|js)$/.test(path));
const sources = typescriptFiles.filter(
  (path) =>
    /^(packages\/[^/]+\/(src|kernels)|games|bench)\//.test(path) && !isTest(path) && !path.startsWith('bench/kernels/'),
);

test(`no file is longer than ${longestFile} lines`, () => {
  const violations = codeFiles
    .map((path) => ({ path, lines: read(path).trimEnd().split('\n').length }))
    .filter(({ lines }) => lines > longestFile)
    .map(({ path, lines }) => `${path}: ${lines} lines`);
  expectNone('A long file hides more than one idea; split it by what its parts are about:', violations);
});

test(`no function is longer than ${longestFunction} lines`, () => {
  const violations = sources.flatMap((path) => {
    const { text, tree } = parse(path);
    const found: string[] = [];
    walk(tree, (node, parent) => {
      if (!/^(FunctionDeclaration|FunctionExpression|ArrowFunctionExpression)$/.test(node.type)) return;
      const [first, last] = [lineOf(text, node.start), lineOf(text, node.end)];
      const lines = last - first + 1;
      if (lines > longestFunction) found.push(`${path}:${first} ${functionName(node, parent)}: ${lines} lines`);
    });
    return found;
  });
  expectNone('A long function is several steps; give each a name:', violations);
});

test('no literal is spread into another', () => {
  const violations = typescriptFiles.flatMap((path) => {
    const { text, tree } = parse(path);
    const found: string[] = [];
    walk(tree, (node) => {
      const spread = node.type === 'SpreadElement' ? (node.argument as Node) : undefined;
      if (!/^(Object|Array)Expression$/.test(spread?.type ?? '')) return;
      found.push(`${path}:${lineOf(text, node.start)}`);
    });
    return found;
  });
  expectNone('`...{ a, b }` only makes the formatter put a and b on one line; write them out:', violations);
});

test('packages destructure nothing into named members', () => {
  const published = sources.filter((path) => path.startsWith('packages/'));
  const violations = published.flatMap((path) => {
    const { text, tree } = parse(path);
    const found: string[] = [];
    walk(tree, (node) => {
      if (node.type !== 'AssignmentExpression') return;
      const { elements, properties } = node.left as { elements?: (Node | null)[]; properties?: Node[] };
      const targets = elements ?? properties?.map(({ value }) => value as Node) ?? [];
      if (!targets.some((target) => target?.type === 'MemberExpression' && target.computed !== true)) return;
      found.push(`${path}:${lineOf(text, node.start)}`);
    });
    return found;
  });
  const rule = 'The minifier of `next build` can make `[0, 0] = …` of `[point.x, point.y] = …`; assign one by one:';
  expectNone(rule, violations);
});

test('files and folders have kebab-case names', () => {
  const conventional = /^(\.[\w.-]+|README\.md|LICENSE|CHANGELOG\.md|CONTRIBUTING\.md)$/;
  const kebabCase = /^[a-z0-9]+(-[a-z0-9]+)*(\.[a-z0-9]+(-[a-z0-9]+)*)*$/;
  const violations = projectFiles.filter((path) =>
    path.split('/').some((part) => !conventional.test(part) && !kebabCase.test(part)),
  );
  expectNone('Names are in kebab-case, such as broad-phase/sweep-and-prune.ts:', violations);
});

test('no test runs alone', () => {
  const violations = typescriptFiles.filter(isTest).flatMap((path) => {
    const { text, tree } = parse(path);
    const found: string[] = [];
    walk(tree, (node) => {
      const property = node.property as Node | undefined;
      if (node.type !== 'MemberExpression' || property?.name !== 'only') return;
      if (/^(test|it|describe|suite|bench)\b/.test(text.slice(node.start, node.end))) {
        found.push(`${path}:${lineOf(text, node.start)}`);
      }
    });
    return found;
  });
  expectNone('`.only` silences every other test of the file; remove it:', violations);
});

function functionName(node: Node, parent: Node | undefined): string {
  const named = (node.id ?? parent?.id ?? parent?.key) as Node | undefined;
  return String(named?.name ?? 'an unnamed function');
}
