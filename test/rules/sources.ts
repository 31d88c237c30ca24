/** The project's files as the rules see them: their paths, their text, and the syntax tree of TypeScript files. */
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path/posix';
import { parseAst } from 'vitest/node';
import { hideDecorators } from '../../scripts/lib/kernel-decorators.mjs';
import { root } from '../../scripts/lib/paths.mjs';

/** A node of the ESTree syntax tree, as loosely as the rules need it. */
export type Node = { type: string; start: number; end: number; [key: string]: unknown };

export type Import = { source: string; typeOnly: boolean; line: number };

/** Paths from the root, with forward slashes: everything committed, and what would be with `git add`. */
export const projectFiles: readonly string[] = list('--cached', '--others', '--exclude-standard');

/** Only what is committed or staged. */
export const trackedFiles: readonly string[] = list('--cached');

export const typescriptFiles = projectFiles.filter((path) => path.endsWith('.ts') && !path.endsWith('.d.ts'));

export const isTest = (path: string) => path.endsWith('.test.ts');

export const read = (path: string) => readFileSync(`${root}/${path}`, 'utf8');

const trees = new Map<string, { text: string; tree: Node }>();

/** The text the tree's offsets refer to, and the tree. */
export function parse(path: string): { text: string; tree: Node } {
  const known = trees.get(path);
  if (known) return known;
  const text = hideDecorators(read(path));
  const parsed = { text, tree: parseAst(text, { lang: 'ts' }, path) as unknown as Node };
  trees.set(path, parsed);
  return parsed;
}

/** Calls `visit` for every node, parents first, with the node above it and the name of the field it hangs from. */
export function walk(node: Node, visit: (node: Node, parent: Node | undefined, field: string) => void): void {
  const descend = (at: Node, parent: Node | undefined, field: string): void => {
    visit(at, parent, field);
    for (const [name, value] of Object.entries(at)) {
      for (const child of Array.isArray(value) ? value : [value]) if (isNode(child)) descend(child, at, name);
    }
  };
  descend(node, undefined, '');
}

/** Every import and re-export of a file, `import('…')` included. */
export function importsOf(path: string): Import[] {
  const { text, tree } = parse(path);
  const found: Import[] = [];
  walk(tree, (node) => {
    const source = node.source as { value?: unknown } | null | undefined;
    if (!/^(Import|Export)/.test(node.type) || typeof source?.value !== 'string') return;
    const kind = node.importKind ?? node.exportKind;
    found.push({ source: source.value, typeOnly: kind === 'type', line: lineOf(text, node.start) });
  });
  return found;
}

/** The file an import names, from the root; undefined for installed packages and Node's own modules. */
export function resolveImport(from: string, source: string): string | undefined {
  const workspace = source.match(/^@principia\/([\w-]+)$/)?.[1];
  if (workspace) return `packages/${workspace}/src/index.ts`;
  if (source.startsWith('#')) return privateImport(from, source);
  if (!source.startsWith('.')) return undefined;
  const path = join(dirname(from), source);
  return (
    [path, `${path}.ts`, `${path}/index.ts`].find((name) => /\.\w+$/.test(name) && existsSync(`${root}/${name}`)) ??
    path
  );
}

/** The source behind a name of `imports` in the manifest of the package, where no condition chooses another. */
function privateImport(from: string, source: string): string | undefined {
  const folder = from.split('/').slice(0, 2).join('/');
  const target: string | undefined = JSON.parse(read(`${folder}/package.json`)).imports?.[source]?.['principia-source'];
  return target && join(folder, target);
}

export function lineOf(text: string, offset: number): number {
  return text.slice(0, offset).split('\n').length;
}

/** Fails with one sentence that says what the rule is, then one line for each place that breaks it. */
export function expectNone(rule: string, violations: readonly string[]): void {
  if (violations.length > 0) throw new Error(`${rule}\n  ${violations.join('\n  ')}`);
}

function list(...which: string[]): string[] {
  const output = execFileSync('git', ['ls-files', '-z', ...which], { cwd: root, encoding: 'utf8', maxBuffer: 1 << 26 });
  return output.split('\0').filter((path) => path !== '' && existsSync(`${root}/${path}`));
}

function isNode(value: unknown): value is Node {
  return typeof value === 'object' && value !== null && typeof (value as Node).type === 'string';
}
